// 8. Sparse texels: how noise depends on the number of hits when they are few.
#include "bench/experiments/stability/sparse_hits.h"
#include "bench/experiments/stability/stability_case.h"

namespace bench::stability {
namespace {

using common::SurfacePoint;

constexpr std::size_t k = 20;  // photons in a gather

std::vector<StabilityCurve> run(const CaseRun& run) {
    const SparseFloor floor;
    constexpr double places[] = {0.1, 0.3, 1, 3, 10};
    const auto of_photon_map = [&](double n) {
        // The expected number of photons x within the distance of the k-th nearest is Gamma(k) distributed.
        // (k - 1) / x has the mean 1 and the second moment (k - 1)^2 / ((k - 1) (k - 2)).
        const double variance = 1.0 / (k - 2);
        return run.has_mutation("the photon map's noise falls with its photons") ? variance / n : variance;
    };
    const double texels = run.has_mutation("four texels are as noisy as one") ? 1 : 4;
    constexpr auto least_hits = shlm::default_least_hits;
    const auto of_blocks = [](double n) {
        return mean_over_blocks(n, least_hits, SparseFloor::levels, square_of_error);
    };
    const std::uint64_t in_blocks = run.has_mutation("texels are shown alone") ? 0 : least_hits;
    std::vector<StabilityCurve> curves = {
        curve_at("photon map, 20 nearest", places, of_photon_map),
        curve_at("light map, own texel", places, [](double n) { return 1 / n; }),
        curve_at("light map, 4 nearest texels", places, [&](double n) { return 1 / (texels * n); }),
        curve_at("light map, own texel, in blocks of 100 hits", places, of_blocks)};
    const std::vector<SurfacePoint> among_four = floor.points_among_four(), all = floor.middles_of_texels(),
                                    middle = floor.points_in_the_middle();

    run.for_each_seed([&](std::uint64_t seed) {
        Generator generator(seed);
        for (std::size_t i = 0; i < std::size(places); ++i) {
            const common::HitBatch hits = floor.hits(places[i], generator);
            const auto photon_map = photon_map_of(floor.scene, hits, nearest(k, 0.5));
            const auto own = light_map_of<FlatModel>(floor.texels, hits, shlm::OwnTexel{});
            const auto four = light_map_of<FlatModel>(floor.texels, hits, shlm::NearestTexels{4});
            const auto blocks = light_map_of<FlatModel>(floor.texels, hits, shlm::OwnTexel{}, in_blocks);
            curves[0].points[i].measured.push_back(mean_of(photon_map, middle, square_of_error));
            curves[1].points[i].measured.push_back(mean_of(own, among_four, square_of_error));
            curves[2].points[i].measured.push_back(mean_of(four, among_four, square_of_error));
            curves[3].points[i].measured.push_back(mean_of(blocks, all, square_of_error));
        }
    });
    return curves;
}

const RegisteredCase registered(
    82,
    {.name = "sparse-texels",
     .purpose = "Noise of few hits: a light map's grows as its texels shrink, a photon map's stays what it "
                "is, as its gathers grow instead.",
     .scene = "A floor of 1 x 1 with 64 x 64 texels under vertical light of 1 W/m^2, and so few hits that "
              "each texel has a Poisson number of them.",
     .swept = "hits to a texel, on average: n",
     .measured = "relative variance of the irradiance",
     .theory = "Light map: 1/n of texels that show their own hits, 1/(4 n) with 4 of them. In blocks of 100 "
               "hits: that of the largest block with fewer, over all Poisson numbers that it and its parent "
               "may have. Photon map of the k nearest: 1/(k - 2), whatever the number of photons.",
     .advice = "Nothing to do: texels are shown in blocks of 100 hits, which have the noise of 50 nearest "
               "photons. With 100 hits to a texel and more, more texels show more.",
     .mutations = {"the photon map's noise falls with its photons", "four texels are as noisy as one",
                   "texels are shown alone"},
     .run = run,
     .logarithmic_swept = true,
     .logarithmic_measured = true});

}  // namespace
}  // namespace bench::stability
