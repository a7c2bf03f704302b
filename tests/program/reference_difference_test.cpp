// Compares the methods' images with the path-traced references. They differ as much as with other seeds, and
// more with every error that is planted.
#include "tests/support/reference_difference.h"

#include <gtest/gtest.h>

#include <iostream>

#include "tests/support/gltf_text.h"

namespace reference_difference {

void PrintTo(const Subject& subject, std::ostream* out) {
    *out << subject.scene << ", " << subject.method;
}

}  // namespace reference_difference

namespace {

using namespace reference_difference;
using gltf_text::TemporaryDirectory;

#if !defined(NDEBUG) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool slow_build = true;
#else
constexpr bool slow_build = false;
#endif

/// It must not be one of the seeds that the bounds come from.
constexpr std::uint64_t seed = 1;

/// Probability of a false alarm for each comparison. There are 22, so the whole file fails once in 4500
/// seeds.
constexpr double alpha = 1e-5;

bool takes_too_long(const std::string& scene) {
    return slow_build && scene == "atrium";
}

const Json& measured() {
    static const Json document = Json::parse(child_process::text_of(bounds_file()), nullptr, false);
    if (document.is_discarded())
        throw std::runtime_error("update_difference_bounds makes " + bounds_file().string());
    return document;
}

struct Bounds {
    Interval relmse, relative_bias;

    [[nodiscard]] bool contain(const Figures& figures) const {
        return relmse.contains(figures.relmse) && relative_bias.contains(figures.relative_bias);
    }
};

Bounds bounds_of(const Subject& subject) {
    for (const Json& entry : measured()["bounds"]) {
        if (entry["scene"] != subject.scene || entry["method"] != subject.method) continue;
        const auto interval = [&](const char* figure) {
            const Json& found = entry[figure];
            return Spread{found["mean"], found["standard_deviation"], measured()["seeds"]}.prediction(alpha);
        };
        return {interval("relmse"), interval("relative_bias")};
    }
    throw std::runtime_error("no bounds of " + subject.scene + ", " + subject.method);
}

/// Returns the subject's image, which is rendered when it is first needed.
const fs::path& image_of(const Subject& subject) {
    static const TemporaryDirectory folder;
    static std::map<std::string, fs::path> drawn;
    std::string name = subject.scene + "-" + subject.method;
    std::replace(name.begin(), name.end(), '/', '-');
    const auto [at, is_new] = drawn.try_emplace(name, folder.path() / (name + ".exr"));
    if (is_new) render(subject, seed, at->second);
    return at->second;
}

/// Writes the same image with its irradiance times `factor` to a file of its own.
fs::path scaled(const fs::path& image, float factor) {
    common::Image pixels = common::read_image(image);
    for (const char* name : {"irradiance.R", "irradiance.G", "irradiance.B"})
        for (std::size_t p = 0; p < pixels.pixel_count(); ++p)
            pixels.at(p, *pixels.find_channel(name)) *= factor;
    fs::path file = image;
    file.replace_extension(".scaled.exr");
    common::write_exr(file, pixels, {}, common::Precision::single);
    return file;
}

std::string described(const Figures& figures, const Bounds& bounds) {
    return fmt::format("relMSE {:.4g} of {:.4g} to {:.4g}, relative bias {:.4g} of {:.4g} to {:.4g}, seed {}",
                       figures.relmse, bounds.relmse.low, bounds.relmse.high, figures.relative_bias,
                       bounds.relative_bias.low, bounds.relative_bias.high, seed);
}

/// Whether an image is outside the subject's bounds, and whether the command alone detects that.
struct Found {
    bool by_bounds, by_command;
    std::string figures;
};

Found find_error(const fs::path& image, const Subject& subject) {
    const Bounds bounds = bounds_of(subject);
    const Comparison found = compare(image, subject.scene, bounds.relmse.high);
    return {!bounds.contain(found.figures), found.fails, described(found.figures, bounds)};
}

/// Expects detection by the bounds always, and by --fail-relmse in all scenes but the atrium. There the
/// relMSE is mostly noise, which decreases as the image becomes darker.
void expect_found(const fs::path& image, const Subject& subject) {
    const Found found = find_error(image, subject);
    EXPECT_TRUE(found.by_bounds) << found.figures;
    EXPECT_TRUE(found.by_command || subject.scene == "atrium") << found.figures;
}

TEST(ReferenceDifference, BoundsAreOfTheReferencesThatAreKept) {
    for (const std::string scene : scenes) {
        ASSERT_TRUE(fs::exists(reference_of(scene)))
            << "shlmbench reference makes it: " << reference_of(scene);
        EXPECT_EQ(measured()["references"][scene], identity_of(reference_of(scene)))
            << scene << ": update_difference_bounds measures the bounds anew";
    }
    EXPECT_EQ(measured()["first_seed"], first_seed);
    EXPECT_EQ(measured()["seeds"], seed_count);
    EXPECT_TRUE(seed < first_seed || seed >= first_seed + seed_count);
    EXPECT_EQ(measured()["context"]["drawing"], fmt::format("{}", fmt::join(drawing, " ")));
}

class ReferenceDifferenceOf : public testing::TestWithParam<Subject> {
  protected:
    void SetUp() override {
        if (takes_too_long(GetParam().scene)) GTEST_SKIP() << "takes too long without optimisation";
    }
};

TEST_P(ReferenceDifferenceOf, IsThatOfOtherSeeds) {
    const Bounds bounds = bounds_of(GetParam());
    const Comparison found = compare(image_of(GetParam()), GetParam().scene, bounds.relmse.high);
    std::cout << described(found.figures, bounds) << "\n";
    EXPECT_TRUE(bounds.contain(found.figures)) << described(found.figures, bounds);
    EXPECT_FALSE(found.fails);
}

TEST_P(ReferenceDifferenceOf, GrowsWithAForgottenFactor) {
    for (const float factor : {std::numbers::pi_v<float>, std::numbers::inv_pi_v<float>, 2.0f, 0.5f}) {
        SCOPED_TRACE(factor);
        expect_found(scaled(image_of(GetParam()), factor), GetParam());
    }
}

std::string test_name(const testing::TestParamInfo<Subject>& info) {
    const std::string& method = info.param.method;
    return info.param.scene + (method.starts_with("photonmap") ? "PhotonMap"
                               : method.starts_with("shlm/L0") ? "TraditionalLightMap"
                                                               : "LightMap");
}

INSTANTIATE_TEST_SUITE_P(Subjects, ReferenceDifferenceOf, testing::ValuesIn(subjects()), test_name);

/// Returns the smallest factor above 1 that the bounds detect in an image without noise of its own.
double smallest_factor(const Subject& subject) {
    const Interval bias = bounds_of(subject).relative_bias;
    return (1 + bias.high) / (1 + 0.5 * (bias.low + bias.high));
}

TEST(ReferenceDifference, GrowsWithAFactorOfFivePercent) {
    double smallest = 2;
    for (const std::string scene : scenes) {
        if (takes_too_long(scene)) continue;
        bool spread_allows_it = false;
        std::vector<std::string> found, missed;
        for (const Subject& subject : subjects()) {
            if (subject.scene != scene) continue;
            const double factor = smallest_factor(subject);
            std::cout << fmt::format("{}, {}: the smallest factor found is {:.3f}\n", scene, subject.method,
                                     factor);
            smallest = std::min(smallest, factor);
            spread_allows_it |= factor < 1.05;
            for (const float planted : {1.05f, 0.95f})
                (find_error(scaled(image_of(subject), planted), subject).by_bounds ? found : missed)
                    .push_back(fmt::format("{} x {}", subject.method, planted));
        }
        EXPECT_TRUE(!found.empty() || !spread_allows_it)
            << scene << ": missed " << fmt::format("{}", fmt::join(missed, ", "));
        if (!missed.empty()) std::cout << fmt::format("{}: missed {}\n", scene, fmt::join(missed, ", "));
    }
    EXPECT_LT(smallest, 1.05);
}

TEST(ReferenceDifference, GrowsWithoutTheCosine) {
    for (const std::string scene : scenes) {
        if (takes_too_long(scene)) continue;
        SCOPED_TRACE(scene);
        expect_found(image_of({scene, "shlm/L2/flux/knn4"}), {scene, "shlm/L2/radiance/knn4"});
    }
}

TEST(ReferenceDifference, GrowsWhereNormalsAreIgnored) {
    for (const char* flat : {"shlm/L0/normalised/knn4", "shlm/L0/normalised/bilinear"}) {
        SCOPED_TRACE(flat);
        expect_found(image_of({"bumpy", flat}), {"bumpy", "shlm/L2/radiance/knn4"});
    }
}

// Student's t.

TEST(StudentsT, HasTheQuantilesOfTheTables) {
    for (const auto& [chance, degrees, t] :
         {std::tuple(0.05, 1, 12.7062047), std::tuple(0.05, 2, 4.3026527), std::tuple(0.05, 15, 2.1314495),
          std::tuple(0.001, 15, 4.0727652), std::tuple(0.05, 30, 2.0422725), std::tuple(0.01, 9, 3.2498355)})
        EXPECT_NEAR(tests::t_for(chance, degrees), t, 1e-6) << chance << ", " << degrees;
    for (const double chance : {0.5, 0.01, 1e-5}) {  // cases with closed forms
        EXPECT_NEAR(tests::t_for(chance, 1), 1 / std::tan(std::numbers::pi / 2 * chance),
                    1e-4 / chance * 1e-5);
        EXPECT_NEAR(tests::t_for(chance, 2), std::sqrt(2 / (chance * (2 - chance)) - 2), 1e-4);
        EXPECT_NEAR(tests::t_for(chance, 100'000), tests::z_for(chance), 1e-3);
    }
}

TEST(StudentsT, PredictsAsManyValuesAsItSays) {
    const Interval interval = Spread{2, 0.5, 16}.prediction(0.05);
    EXPECT_NEAR(interval.high - 2, 2.1314495 * 0.5 * std::sqrt(17.0 / 16), 1e-6);
    EXPECT_NEAR(2 - interval.low, interval.high - 2, 1e-12);
    EXPECT_FALSE(interval.contains(std::numeric_limits<double>::quiet_NaN()));
}

}  // namespace
