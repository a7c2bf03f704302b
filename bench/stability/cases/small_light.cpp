// 17. Fireflies: a small bright light that is seen in a mirror.
#include "bench/stability/stability_case.h"
#include "bench/stability/traced_light.h"

namespace bench {
namespace {

using common::Vec3;
using scene_builder::pi;

constexpr double sizes[] = {0.3, 0.1, 0.03, 0.01, 0.001};
constexpr int side = 32;  // places each way, a texel and a disc at each
constexpr double disc_radius = 0.06, texel_size = 4.0 / side;
constexpr std::uint32_t floor_triangle = 4;
constexpr std::size_t texels_wanted = side * side + 4;  // the light has up to four

/// A square light of 1 W at the origin that shines up to a mirror 1 above, and a black floor beside it, which
/// has all its light from the mirror.
common::Scene mirrored_light(double size, float reflectance) {
    const auto s = static_cast<float>(size);
    const auto radiance = static_cast<float>(1 / (pi * size * size));
    common::Scene scene;
    add(scene, scene_builder::quad({-s / 2, -s / 2, 0}, {s, 0, 0}, {0, s, 0}),
        scene_builder::diffuse({0, 0, 0}, {radiance, radiance, radiance}));
    add(scene, scene_builder::quad({-1, -3, 1}, {0, 6, 0}, {5, 0, 0}),
        scene_builder::mirror({reflectance, reflectance, reflectance}));
    add(scene, scene_builder::quad({0.5f, -2, 0}, {4, 0, 0}, {0, 4, 0}), scene_builder::diffuse({0, 0, 0}));
    return scene;
}

/// Mean of a smooth function over a square or disc whose coordinates have this variance about its center,
/// exact for polynomials of order 3.
template <class Function>
double mean_around(double x, double y, double variance, Function function) {
    const double step = std::sqrt(2 * variance);
    return (function(x + step, y) + function(x - step, y) + function(x, y + step) + function(x, y - step)) /
           4;
}

/// Irradiance from a Lambertian light of 1 W: cos^2 / (pi d^2), with d the way to its image 2 above and cos =
/// 2 / d at both ends; the mean over the light and over a place whose coordinates have this variance.
double irradiance_at(double x, double y, double size, double variance) {
    return mean_around(x, y, variance, [&](double at_x, double at_y) {
        return mean_around(at_x, at_y, size * size / 12, [](double dx, double dy) {
            const double d_sq = dx * dx + dy * dy + 4;
            return 4 / (pi * d_sq * d_sq);
        });
    });
}

/// Photons at all places over their predicted number, and the mean of (photons - predicted)^2 / predicted:
/// both 1 where photons fall independently and count the same.
struct Counted {
    double sum = 0, predicted_sum = 0, squares = 0;

    void add(double photons, double predicted) {
        sum += photons;
        predicted_sum += predicted;
        squares += (photons - predicted) * (photons - predicted) / predicted;
    }
    [[nodiscard]] double mean() const { return sum / predicted_sum; }
    [[nodiscard]] double noise() const { return squares / (side * side); }
};

/// As if half the photons were stored, with twice the flux.
void keep_every_other(common::HitBatch& hits) {
    const std::size_t kept = hits.size() / 2;
    for (std::size_t i = 0; i < kept; ++i)
        hits.set(i, hits.position[2 * i], hits.direction[2 * i], hits.flux[2 * i] * 2.0f, hits.surface[2 * i],
                 0);
    hits.resize(kept);
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    const float reflectance = run.has_mutation("the mirror takes a tenth") ? 0.9f : 1;
    const bool brighter = run.has_mutation("photons are fewer and brighter");
    // The means by four points leave (size / distance)^4 and less of it.
    constexpr double series = 1e-4, shares_of_all = 1e-3;
    const auto one = [](double) { return 1.0; };
    std::vector<StabilityCurve> curves = {
        curve_at("photon map, mean", sizes, one, Expected::equal, series),
        curve_at("light map, mean", sizes, one, Expected::equal, series),
        curve_at("photon map, variance x photons", sizes, one, Expected::equal, shares_of_all),
        curve_at("light map, variance x photons", sizes, one, Expected::equal, shares_of_all)};

    std::vector<common::Scene> scenes;
    std::vector<shlm::PreparedTexels> prepared;
    for (const double size : sizes) {
        scenes.push_back(mirrored_light(size, reflectance));
        prepared.push_back(texels_of(scenes.back(), texels_wanted));
    }
    run.for_each_seed([&](std::uint64_t seed) {
        for (std::size_t i = 0; i < std::size(sizes); ++i) {
            const common::Scene& scene = scenes[i];
            auto [hits, report] =
                traced(scene, seed, {.photons = run.either<std::uint64_t>(1'000'000, 40'000)});
            if (brighter) keep_every_other(hits);
            const auto photon_map =
                map_of(photonmap::GridPhotonSink(scene, within(scene, disc_radius)), hits);
            const auto light_map = light_map_of<FlatModel>(prepared[i], hits, shlm::OwnTexel{});
            Counted in_discs, in_texels;
            for (int place = 0; place < side * side; ++place) {
                const common::SurfacePoint point = scene_builder::front_of(
                    scene,
                    scene_builder::on_quad(floor_triangle, (static_cast<float>(place % side) + 0.5f) / side,
                                           (static_cast<float>(place / side) + 0.5f) / side));
                // A photon has 1 W x the number emitted: irradiance x area counts photons.
                const auto count = [&](Counted& counted, const auto& map, double area, double variance) {
                    counted.add(map.irradiance(point).x * area,
                                irradiance_at(point.position.x, point.position.y, sizes[i], variance) * area *
                                    static_cast<double>(report.fates.emitted));
                };
                count(in_discs, photon_map, pi * disc_radius * disc_radius, disc_radius * disc_radius / 4);
                count(in_texels, light_map, texel_size * texel_size, texel_size * texel_size / 12);
            }
            curves[0].points[i].measured.push_back(in_discs.mean());
            curves[1].points[i].measured.push_back(in_texels.mean());
            curves[2].points[i].measured.push_back(in_discs.noise());
            curves[3].points[i].measured.push_back(in_texels.noise());
        }
    });
    return curves;
}

const RegisteredCase registered(
    171,
    {.name = "small-light",
     .purpose =
         "A small bright light that is seen in a mirror or through glass: paths from the eye hardly ever "
         "find it, and where one does it leaves a firefly.",
     .scene = "A square light of 1 W and swept size shines up to a mirror; a black floor beside it, 4 x 4, "
              "has all "
              "its light from there. 1024 texels, and as many discs of radius 0.06 in a photon map. Seeds "
              "draw all "
              "photons.",
     .swept = "side of the light / its distance from the mirror",
     .measured = "mean / predicted; variance x photons / mean^2",
     .theory =
         "Irradiance cos^2 / (pi d^2), d from the light's image behind the mirror. Every photon that comes "
         "brings the same flux, however small its light: the variance is that of their number.",
     .advice = "Nothing to do: both methods trace from the light, so that its size does not matter.",
     .mutations = {"the mirror takes a tenth", "photons are fewer and brighter"},
     .run = run,
     .logarithmic_swept = true});

}  // namespace
}  // namespace bench
