// 2. Topological bias: on a curved surface the ball of a gather holds more or less than a flat disc.
#include <numbers>

#include "bench/experiments/stability/floor_light.h"
#include "bench/experiments/stability/stability_case.h"

namespace bench::stability {
namespace {

using common::Vec3;

constexpr double pi = std::numbers::pi;
constexpr int strips = 255;

/// Makes the upper half of a cylinder of radius 1 around the y axis, in flat strips. It is as long as its
/// unrolled width, so w x w texels are square.
const common::Scene& cylinder() {
    static const common::Scene made = [] {
        const auto at = [](int strip) {
            const double angle = pi * (static_cast<double>(strip) / strips - 0.5);
            return Vec3(Imath::V3d(std::sin(angle), -pi / 2, std::cos(angle)));
        };
        scene_builder::Mesh mesh;
        for (int k = 0; k < strips; ++k) {
            const float u0 = static_cast<float>(k) / strips, u1 = static_cast<float>(k + 1) / strips;
            const auto strip =
                scene_builder::quad(at(k), at(k + 1) - at(k), {0, std::numbers::pi_v<float>, 0});
            mesh = joined(std::move(mesh),
                          scene_builder::with_lightmap_uv(strip, {{u0, 0}, {u1, 0}, {u1, 1}, {u0, 1}}));
        }
        common::Scene scene;
        add(scene, mesh, scene_builder::diffuse({1, 1, 1}));
        return scene;
    }();
    return made;
}

/// Returns where a photon of vertical light arrives that is at `s` of the cylinder's width.
common::SurfaceId under(double s, double t) {
    const auto edge = [](double strip) { return (std::sin(pi * (strip / strips - 0.5)) + 1) / 2; };
    const double strip = std::floor(strips * (std::asin(2 * s - 1) / pi + 0.5));
    const double within = (s - edge(strip)) / (edge(strip + 1) - edge(strip));
    return scene_builder::on_quad(2 * static_cast<std::uint32_t>(strip), static_cast<float>(within),
                                  static_cast<float>(t));
}

/// Returns the point at `s` of the way round.
common::SurfaceId around(double s, double t) {
    const double strip = std::floor(strips * s);
    return scene_builder::on_quad(2 * static_cast<std::uint32_t>(strip),
                                  static_cast<float>(strips * s - strip), static_cast<float>(t));
}

/// Makes one photon in each cell of a grid, at random within the cell. Such even photons have so little noise
/// that bias shows. `place(s, t)` is where a photon arrives, `direction(normal)` its direction; together they
/// carry `power`, W.
template <class Place, class Direction>
common::HitBatch light(int cells, double power, Generator& generator, Place place, Direction direction) {
    const auto flux = static_cast<float>(power / cells / cells);
    common::HitBatch hits;
    hits.reserve(static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells));
    for (int j = 0; j < cells; ++j)
        for (int i = 0; i < cells; ++i) {
            const double s = (i + double{uniform(generator)}) / cells;
            const double t = (j + double{uniform(generator)}) / cells;
            const common::SurfaceId on = place(s, t);
            hits.push_back(common::position_at(cylinder(), on),
                           direction(cylinder().geometric_normal[on.triangle]), {flux, flux, flux}, on);
        }
    return hits;
}

/// Returns points along the top of the cylinder, with room for every ball of the case.
std::vector<common::SurfacePoint> points_on_top() {
    std::vector<common::SurfacePoint> points;
    for (int i = 0; i < 8; ++i)
        points.push_back(scene_builder::front_of(
            cylinder(), scene_builder::on_quad(strips / 2 * 2, 0.5f, 0.36f + 0.04f * static_cast<float>(i))));
    return points;
}

// Let R = 1, let a be the angle from the top and s = 2 sin(a / 2) the distance from it. There, a strip of the
// ball is 2 sqrt(r^2 - s^2) long and da = ds / sqrt(1 - s^2 / 4) wide. Over a disc, s^2, s^4 and s^6 are on
// average r^2 / 4, r^4 / 8 and 5 r^6 / 64.

/// Parallel light has cos a photons per unit of area, and each counts 1 / cos a times on a surface that faces
/// the light. So the estimate is the mean of 1 / sqrt(1 - s^2 / 4).
double read_in_parallel_light(double r) {
    return 1 + r * r / 32 + 3 * std::pow(r, 4) / 1024 + 25 * std::pow(r, 6) / 65536;
}

/// Uniform light from all sides has the same photon density everywhere. Of the light above a plane tilted by
/// a, an untilted plane sees (1 + cos a) / 2 = 1 - s^2 / 4. So the estimate is the mean of sqrt(1 - s^2 / 4).
double read_in_even_light(double r) {
    return 1 - r * r / 32 - std::pow(r, 4) / 1024 - 5 * std::pow(r, 6) / 65536;
}

/// Returns the mean of cos a over a texel of width h that is centred on the top.
double read_by_texel(double h) {
    return std::sin(h / 2) / (h / 2);
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    const common::Scene& scene = cylinder();
    constexpr std::size_t texels_around[] = {31, 15, 9, 5, 3};
    std::vector<double> sizes;
    std::vector<shlm::PreparedTexels> prepared;
    for (const std::size_t w : texels_around) {
        sizes.push_back(pi / static_cast<double>(w));
        prepared.push_back(texels_of(scene, w * w));
    }
    const bool flat = run.has_mutation("a ball's part of the surface is a flat disc");
    const bool point = run.has_mutation("a texel is a point");
    const auto if_not = [](bool without, auto predicted) {
        return [=](double size) { return without ? 1.0 : predicted(size); };
    };
    // The next terms of the series are below 1e-4, and a strip's angle squared is 1.5e-4.
    constexpr double allowed = 2.5e-4;
    std::vector<StabilityCurve> curves = {
        curve_at("photon map, parallel light", sizes, if_not(flat, read_in_parallel_light), Expected::equal,
                 allowed),
        // Cosines below the clamp e of the divisor reduce the estimate by e / 2.
        curve_at("photon map, light from all sides", sizes, if_not(flat, read_in_even_light), Expected::equal,
                 allowed + common::min_incident_cosine / 2),
        curve_at("light map, own texel, parallel light", sizes, if_not(point, read_by_texel), Expected::equal,
                 allowed)};
    const auto points = points_on_top();

    run.for_each_seed([&](std::uint64_t seed) {
        Generator generator(seed);
        const int cells = run.either(600, 200);
        const auto down = [](const Vec3&) { return Vec3(0, 0, -1); };
        const common::HitBatch parallel = light(cells, 2 * pi, generator, under, down);
        const common::HitBatch even = light(cells, pi * pi, generator, around, [&](const Vec3& normal) {
            return diffusely_onto(normal)(generator);
        });
        const auto in_parallel = photon_map_of(scene, parallel, within(scene, 1));
        const auto in_even = photon_map_of(scene, even, within(scene, 1));
        for (std::size_t i = 0; i < sizes.size(); ++i) {
            const auto gather = within(scene, sizes[i]);
            curves[0].points[i].measured.push_back(mean_irradiance(in_parallel.with_gather(gather), points));
            curves[1].points[i].measured.push_back(mean_irradiance(in_even.with_gather(gather), points));
            const auto light_map = light_map_of<FlatModel>(prepared[i], parallel, shlm::OwnTexel{});
            curves[2].points[i].measured.push_back(mean_irradiance(light_map, points));
        }
    });
    return curves;
}

const RegisteredCase registered(
    21,
    {.name = "convex-cylinder",
     .purpose =
         "Topological bias on curved surfaces: the part of the surface that is inside a ball is larger "
         "than a flat disc, and its photons come at other angles. A texel is as large as it is.",
     .scene = "A cylinder of radius R under parallel light of 1 W/m^2 straight onto its top, or even light "
              "from all sides. Means over 8 points along the top.",
     .swept = "radius of the gather / R, width of the texel / R",
     .measured = "irradiance / truth",
     .theory = "Photon map in parallel light: 1 + r^2 / 32 R^2 + 3 r^4 / 1024 R^4 + ...; in even light, as "
               "photons are read by their angle: 1 - r^2 / 32 R^2 - r^4 / 1024 R^4 - .... Light map: "
               "sin(h / 2R) / (h / 2R), the mean over the texel.",
     .advice = "No remedy is needed below r = R / 2, where it is less than 1 %. A sphere cannot show it.",
     .mutations = {"a ball's part of the surface is a flat disc", "a texel is a point"},
     .run = run});

}  // namespace
}  // namespace bench::stability
