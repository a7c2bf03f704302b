// Tests direct light apart, as a user asks for it.
#include "common/image/image.h"
#include "tests/support/statistics.h"
#include "tests/support/study_command.h"

namespace {

using namespace study_command;

using DirectLight = Study;

/// Returns the sum of each run's answers, by method.
std::map<std::string, tests::Sample> sums_of(const fs::path& out, const Json& rows) {
    std::map<std::string, tests::Sample> sums;
    for (const Json& row : rows) {
        double sum = 0;
        for (const float value : values_of<float>(answers_of(out, row))) sum += double{value};
        sums[row["method"]].add(sum);
    }
    return sums;
}

/// Photons of all light, and those of indirect light with sampled direct light, have the same mean over the
/// picture. Seeds of both are independent of each other only in the photons' part, so the bound takes the
/// variance of both. A fortieth is left for direct light that photons blur over edges; in this box, direct
/// light is more than a third.
TEST_F(DirectLight, AddsUpToAllLightForBothMethods) {
    constexpr int seeds = 8;
    Request request = {.out = path("photons"),
                       .methods = {"shlm/L2/normalised/own", "photonmap/compact/k50"},
                       .hits = "20000",
                       .seeds = std::to_string(seeds),
                       .texels = "1024"};
    const auto all = sums_of(request.out, study(request));
    request.out = path("traced");
    request.more = {"--direct", "traced"};
    const Json rows = study(request);
    for (const Json& row : rows) {
        EXPECT_EQ(row["direct"], "traced");
        EXPECT_EQ(row["direct_samples"], 64);
    }
    const double t = tests::t_for(1e-5 / 2, 2 * seeds - 2);
    for (const auto& [method, apart] : sums_of(request.out, rows)) {
        const tests::Sample& together = all.at(method);
        const double error = std::hypot(apart.standard_error(), together.standard_error());
        EXPECT_NEAR(apart.mean(), together.mean(), t * error + together.mean() / 40) << method;
    }
}

TEST_F(DirectLight, IsNotInRowsOfPhotonsAlone) {
    EXPECT_FALSE(rows_of(finished_study())[0].contains("direct"));
}

TEST_F(DirectLight, IsRefusedWhereItHasNoMeaning) {
    const Request request = {.out = path("out"), .methods = {"shlm"}, .hits = "1000", .seeds = "1"};
    const auto with = [&](const Words& more) {
        Request other = request;
        other.more = more;
        return other;
    };
    expect_refusal(with({"--direct", "none"}), {"--direct", "'none'", "photons", "traced"});
    for (const char* samples : {"0", "100"})
        expect_refusal(with({"--direct-samples", samples}), {"--direct-samples", "multiple of 64"});
    (void)study(request);
    expect_refusal(with({"--direct", "traced"}), {"out/study.json", "setting", "--anew"});
    expect_refused(
        run_command(render(cornell, "shlm", {"--direct", "traced", "--map", path("map.exr")}), said),
        {"--map"});
}

/// Returns the mean irradiance over a picture, W/m^2.
double mean_of(const std::string& file) {
    const common::Image image = common::read_image(file);
    double sum = 0;
    for (std::size_t p = 0; p < image.pixel_count(); ++p)
        for (std::size_t c = 4; c < 7; ++c) sum += double{image.at(p, c)};
    return sum / static_cast<double>(image.pixel_count());
}

/// Light that counts twice or is lost would be a third of all or more; 2000 hits know the mean to a tenth.
TEST_F(DirectLight, IsDrawn) {
    std::map<std::string, double> mean;
    for (const std::string direct : {"photons", "traced"}) {
        ASSERT_EQ(run_command(render(cornell, "shlm", {"--direct", direct}), said).exit_code, 0);
        mean[direct] = mean_of(path("image.exr"));
    }
    EXPECT_NEAR(mean["traced"], mean["photons"], 0.1 * mean["photons"]);
}

}  // namespace
