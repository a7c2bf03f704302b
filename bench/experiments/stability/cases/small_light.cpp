// 17. Fireflies: a small bright light, seen in a mirror or through glass.
#include <fmt/format.h>

#include <array>

#include "bench/experiments/stability/stability_case.h"
#include "bench/experiments/stability/traced_light.h"

namespace bench::stability {
namespace {

using scene_builder::Material;
using scene_builder::pi;

constexpr double sizes[] = {0.3, 0.1, 0.03, 0.01, 0.001};
constexpr int side = 32;  // places each way, a texel and a disc at each
constexpr double disc_radius = 0.06, texel_size = 4.0 / side;
constexpr std::uint32_t floor_triangle = 2;
constexpr std::size_t texels_wanted = side * side + 4;  // the light has up to four
constexpr float refraction = 1.5f;                      // index of the glass

Material light(double size) {
    const auto radiance = static_cast<float>(1 / (pi * size * size));
    return scene_builder::diffuse({0, 0, 0}, {radiance, radiance, radiance});
}

/// Makes a floor of 4 x 4 in the plane z = 0, beside the light.
scene_builder::Mesh black_floor() {
    return scene_builder::quad({0.5f, -2, 0}, {4, 0, 0}, {0, 4, 0});
}

/// Makes a square light of 1 W at the origin, which faces a mirror 1 above. All light on the floor comes by
/// way of the mirror.
common::Scene light_in_mirror(double size, float reflectance) {
    const auto s = static_cast<float>(size);
    common::Scene scene;
    add(scene, scene_builder::quad({-s / 2, -s / 2, 0}, {s, 0, 0}, {0, s, 0}), light(size));
    add(scene, black_floor(), scene_builder::diffuse({0, 0, 0}));
    add(scene, scene_builder::quad({-1, -3, 1}, {0, 6, 0}, {5, 0, 0}),
        scene_builder::mirror({reflectance, reflectance, reflectance}));
    return scene;
}

/// Makes the scene with the light at its mirror image, 2 above the floor, and a thin pane half way.
common::Scene light_through_glass(double size) {
    constexpr float thickness = 1e-4f;
    const auto s = static_cast<float>(size);
    common::Scene scene;
    add(scene, scene_builder::quad({-s / 2, -s / 2, 2}, {0, s, 0}, {s, 0, 0}), light(size));
    add(scene, black_floor(), scene_builder::diffuse({0, 0, 0}));
    add(scene, scene_builder::quad({-1, -3, 1}, {6, 0, 0}, {0, 6, 0}), scene_builder::glass(refraction));
    add(scene, scene_builder::quad({-1, -3, 1 - thickness}, {0, 6, 0}, {6, 0, 0}),
        scene_builder::glass(refraction));
    return scene;
}

/// Returns the reflectance of a glass surface for unpolarised light (Fresnel).
double reflected(double cosine) {
    const double inside = std::sqrt(1 - (1 - cosine * cosine) / (refraction * refraction));
    const double across = (cosine - refraction * inside) / (cosine + refraction * inside);
    const double along = (inside - refraction * cosine) / (inside + refraction * cosine);
    return (across * across + along * along) / 2;
}

/// Returns the transmittance of a pane's two surfaces with all reflections between them: (1 - r)^2 (1 + r^2 +
/// r^4 + ...).
double transmitted(double cosine) {
    const double r = reflected(cosine);
    return (1 - r) / (1 + r);
}

double all(double) {
    return 1;
}

/// Returns the mean of a smooth function over a square or disc whose coordinates have this variance about its
/// centre. It is exact for polynomials of order 3.
template <class Function>
double mean_around(double x, double y, double variance, Function function) {
    const double step = std::sqrt(2 * variance);
    return (function(x + step, y) + function(x - step, y) + function(x, y + step) + function(x, y - step)) /
           4;
}

/// The transmitted or reflected fraction of the light, as a function of the cosine of incidence.
using Share = double (*)(double cosine);

/// Returns the irradiance from a Lambertian light of 1 W, or its image, 2 above: cos^2 / (pi d^2), where d is
/// the distance and cos = 2 / d at both ends. It is the mean over the light and over a region whose
/// coordinates have this variance.
double irradiance_at(double x, double y, double size, double variance, Share share) {
    return mean_around(x, y, variance, [&](double at_x, double at_y) {
        return mean_around(at_x, at_y, size * size / 12, [&](double dx, double dy) {
            const double d_sq = dx * dx + dy * dy + 4;
            return share(2 / std::sqrt(d_sq)) * 4 / (pi * d_sq * d_sq);
        });
    });
}

/// Accumulates photons over their predicted number, and the mean of (photons - predicted)^2 / predicted. Both
/// are 1 for independent photons of equal flux.
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

/// Acts as if half the photons were stored, with twice the flux.
void keep_every_other(common::HitBatch& hits) {
    const std::size_t kept = hits.size() / 2;
    for (std::size_t i = 0; i < kept; ++i)
        hits.set(i, hits.position[2 * i], hits.direction[2 * i], hits.flux[2 * i] * 2.0f, hits.surface[2 * i],
                 0);
    hits.resize(kept);
}

struct Setup {
    common::Scene scene;
    double size;  ///< of the light
    Share share;
};

/// Returns mean and noise of the photon map, then of the light map.
std::array<double, 4> measure(const Setup& setup, const shlm::PreparedTexels& texels, std::uint64_t seed,
                              const CaseRun& run) {
    const common::Scene& scene = setup.scene;
    auto [hits, report] = traced(scene, seed, {.photons = run.either<std::uint64_t>(1'000'000, 40'000)});
    if (run.has_mutation("photons are fewer and brighter")) keep_every_other(hits);
    const auto photon_map = map_of(photonmap::GridPhotonSink(scene, within(scene, disc_radius)), hits);
    const auto light_map = light_map_of<FlatModel>(texels, hits, shlm::OwnTexel{});
    Counted in_discs, in_texels;
    for (int place = 0; place < side * side; ++place) {
        const common::SurfacePoint point = scene_builder::front_of(
            scene, scene_builder::on_quad(floor_triangle, (static_cast<float>(place % side) + 0.5f) / side,
                                          (static_cast<float>(place / side) + 0.5f) / side));
        // A photon has 1 W times the number emitted, so irradiance x area is a number of photons.
        const auto count = [&](Counted& counted, const auto& map, double area, double variance) {
            const double irradiance =
                irradiance_at(point.position.x, point.position.y, setup.size, variance, setup.share);
            counted.add(map.irradiance(point).x * area,
                        irradiance * area * static_cast<double>(report.fates.emitted));
        };
        count(in_discs, photon_map, pi * disc_radius * disc_radius, disc_radius * disc_radius / 4);
        count(in_texels, light_map, texel_size * texel_size, texel_size * texel_size / 12);
    }
    return {in_discs.mean(), in_texels.mean(), in_discs.noise(), in_texels.noise()};
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    // The means by four points have an error below (size / distance)^4. The pane moves light by its
    // thickness.
    constexpr double series = 1e-4, moved = 1e-4, shares_of_all = 1e-3;
    const auto one = [](double) { return 1.0; };
    std::vector<StabilityCurve> curves;
    for (const auto& [seen, tolerance] :
         {std::pair("in a mirror", series), {"through glass", series + moved}}) {
        const auto add = [&](const char* what, double at_most) {
            curves.push_back(
                curve_at(fmt::format("{}, {}", what, seen), sizes, one, Expected::equal, at_most));
        };
        add("photon map, mean", tolerance);
        add("light map, mean", tolerance);
        add("photon map, variance x photons", shares_of_all);
        add("light map, variance x photons", shares_of_all);
    }

    const float reflectance = run.has_mutation("the mirror takes a tenth") ? 0.9f : 1;
    const Share through_glass = run.has_mutation("the pane does not reflect") ? all : transmitted;
    std::vector<Setup> setups;  // mirror and glass of each size
    std::vector<shlm::PreparedTexels> texels;
    for (const double size : sizes) {
        setups.push_back({light_in_mirror(size, reflectance), size, all});
        setups.push_back({light_through_glass(size), size, through_glass});
    }
    for (const Setup& setup : setups) texels.push_back(texels_of(setup.scene, texels_wanted));
    run.for_each_seed([&](std::uint64_t seed) {
        for (std::size_t i = 0; i < setups.size(); ++i) {
            const std::array<double, 4> figures = measure(setups[i], texels[i], seed, run);
            for (std::size_t k = 0; k < figures.size(); ++k)
                curves[i % 2 * figures.size() + k].points[i / 2].measured.push_back(figures[k]);
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
     .scene =
         "A square light of 1 W and swept size shines up to a mirror, or down through a pane of glass "
         "(index 1.5); a black floor beside it, 4 x 4, has all its light from there. 1024 texels, and as "
         "many discs of radius 0.06 in a photon map. Seeds draw all photons.",
     .swept = "side of the light / its distance from mirror or pane",
     .measured = "mean / predicted; variance x photons / mean^2",
     .theory =
         "Irradiance cos^2 / (pi d^2), d from the light's image behind the mirror; through glass that from "
         "the light, times (1 - r) / (1 + r), r Fresnel's. Every photon that comes brings the same flux, "
         "however small its light: the variance is that of their number.",
     .advice = "Nothing to do: both methods trace from the light, so that its size does not matter.",
     .mutations = {"the mirror takes a tenth", "the pane does not reflect", "photons are fewer and brighter"},
     .run = run,
     .logarithmic_swept = true});

}  // namespace
}  // namespace bench::stability
