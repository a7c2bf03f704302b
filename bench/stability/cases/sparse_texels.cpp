// 8. Sparse texels: how the noise of few hits depends on their number.
#include "bench/stability/sparse_hits.h"
#include "bench/stability/stability_case.h"

namespace bench {
namespace {

using common::SurfacePoint;

constexpr std::size_t k = 20;  // photons in a gather

double square_of_error(double irradiance) {
    return (irradiance - 1) * (irradiance - 1);
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    const SparseFloor floor;
    constexpr double places[] = {0.1, 0.3, 1, 3, 10};
    const auto of_photon_map = [&](double n) {
        // The k-th nearest has a Gamma(k) number of photons, x, within its distance on average; k - 1 over x
        // has the mean 1 and the second moment (k - 1)^2 / ((k - 1) (k - 2)).
        const double variance = 1.0 / (k - 2);
        return run.has_mutation("the photon map's noise falls with its photons") ? variance / n : variance;
    };
    const double texels = run.has_mutation("four texels are as noisy as one") ? 1 : 4;
    std::vector<StabilityCurve> curves = {
        curve_at("photon map, 20 nearest", places, of_photon_map),
        curve_at("light map, own texel", places, [](double n) { return 1 / n; }),
        curve_at("light map, 4 nearest texels", places, [&](double n) { return 1 / (texels * n); })};
    const std::vector<SurfacePoint> among_four = floor.points_among_four(),
                                    middle = floor.points_in_the_middle();

    run.for_each_seed([&](std::uint64_t seed) {
        Generator generator(seed);
        for (std::size_t i = 0; i < std::size(places); ++i) {
            const common::HitBatch hits = floor.hits(places[i], generator);
            const auto photon_map = photon_map_of(floor.scene, hits, nearest(k, 0.5));
            const auto own = light_map_of<FlatModel>(floor.texels, hits, shlm::OwnTexel{});
            const auto four = light_map_of<FlatModel>(floor.texels, hits, shlm::NearestTexels{4});
            curves[0].points[i].measured.push_back(mean_of(photon_map, middle, square_of_error));
            curves[1].points[i].measured.push_back(mean_of(own, among_four, square_of_error));
            curves[2].points[i].measured.push_back(mean_of(four, among_four, square_of_error));
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
     .theory = "Light map: 1/n, 1/(4 n) with 4 texels. Photon map of the k nearest: 1/(k - 2), whatever the "
               "number of photons.",
     .advice = "Choose the number of texels by that of the hits (--texels): 4 n is to a light map what k "
               "is to a photon map.",
     .mutations = {"the photon map's noise falls with its photons", "four texels are as noisy as one"},
     .run = run,
     .logarithmic_swept = true,
     .logarithmic_measured = true});

}  // namespace
}  // namespace bench
