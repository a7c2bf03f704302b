// Measures again, over several seeds, how far the methods' images are from the references: for new
// references, and for intended changes of the methods. The commit must give the reason.
#include "bench/setup/output_folder.h"
#include "bench/setup/provenance.h"
#include "common/core/input_error.h"
#include "tests/support/reference_difference.h"

namespace {

using namespace reference_difference;

Json spread_of(const tests::Sample& sample) {
    return {{"mean", sample.mean()}, {"standard_deviation", std::sqrt(sample.variance())}};
}

Json measured(const Subject& subject, const fs::path& folder) {
    tests::Sample relmse, relative_bias;
    for (std::uint64_t seed = first_seed; seed < first_seed + seed_count; ++seed) {
        render(subject, seed, folder / "image.exr");
        const Figures figures = compare(folder / "image.exr", subject.scene).figures;
        relmse.add(figures.relmse);
        relative_bias.add(figures.relative_bias);
    }
    fmt::print("{} {}: relMSE {:.4f} +- {:.4f}, relative bias {:.4f} +- {:.4f}\n", subject.scene,
               subject.method, relmse.mean(), std::sqrt(relmse.variance()), relative_bias.mean(),
               std::sqrt(relative_bias.variance()));
    return {{"scene", subject.scene},
            {"method", subject.method},
            {"relmse", spread_of(relmse)},
            {"relative_bias", spread_of(relative_bias)}};
}

void update(const fs::path& folder) {
    Json document = {{"context", bench::provenance()}};
    document["context"]["drawing"] = fmt::format("{}", fmt::join(drawing, " "));
    document["first_seed"] = first_seed;
    document["seeds"] = seed_count;
    for (const char* scene : scenes) document["references"][scene] = identity_of(reference_of(scene));
    for (const Subject& subject : subjects()) document["bounds"].push_back(measured(subject, folder));
    bench::write_text(bounds_file(), document.dump(1) + "\n");
    fmt::print("{}\n", bounds_file().string());
}

}  // namespace

int main(int argc, char**) {
    if (argc > 1) {
        fmt::print(stderr, "update_difference_bounds: takes no arguments\n");
        return 2;
    }
    std::string folder = (fs::temp_directory_path() / "shlmbench-bounds-XXXXXX").string();
    if (mkdtemp(folder.data()) == nullptr) return 2;
    int exit_code = 0;
    try {
        update(folder);
    } catch (const std::exception& e) {
        fmt::print(stderr, "update_difference_bounds: {}\n", e.what());
        exit_code = 2;
    }
    std::error_code ignored;
    fs::remove_all(folder, ignored);
    return exit_code;
}
