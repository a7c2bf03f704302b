// 8. Triangles smaller than a texel: none may lose its light.
#include "bench/experiments/stability/stability_case.h"
#include "bench/experiments/stability/tiled_floor.h"

namespace bench::stability {
namespace {

using common::SurfaceId;
using common::SurfacePoint;

constexpr double radius = 0.1;  // of the photon map

/// Makes `count` photons of 1 W together, at random positions on the floor.
common::HitBatch irradiate(const TiledFloor& floor, std::size_t count, Generator& generator) {
    const float flux = 1 / static_cast<float>(count);
    common::HitBatch hits;
    hits.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double x = uniform(generator), y = uniform(generator);
        const SurfaceId on = floor.at(x, y);
        hits.push_back(common::position_at(floor.scene, on), {0, 0, -1}, {flux, flux, flux}, on);
    }
    return hits;
}

/// Returns the hits on triangles that a rasteriser keeps which fills texels whose centres are covered.
common::HitBatch on_triangles_with_center(const TiledFloor& floor, const common::HitBatch& hits) {
    const std::vector<bool> has_center = floor.has_texel_center();
    common::HitBatch kept;
    for (std::size_t i = 0; i < hits.size(); ++i)
        if (has_center[hits.surface[i].triangle])
            kept.push_back(hits.position[i], hits.direction[i], hits.flux[i], hits.surface[i]);
    return kept;
}

double flux_of(const common::HitBatch& hits) {
    double sum = 0;
    for (const common::Rgb& flux : hits.flux) sum += flux.x;
    return sum;
}

double flux_of(const shlm::HarmonicMap<FlatModel>& map) {
    double sum = 0;
    for (const auto& texel : map.texels())
        sum += double{texel.irradiance(texel.face.normal).x} * texel.face.area;
    return sum;
}

double largest_error_of_area(const shlm::PreparedTexels& texels) {
    double largest = 0;
    for (const shlm::TexelGeometry& texel : texels.geometry)
        largest =
            std::max(largest, std::abs(double{texel.area} * static_cast<double>(texels.geometry.size()) - 1));
    return largest;
}

/// Returns points at least `margin` from every edge.
std::vector<SurfacePoint> points_on(const TiledFloor& floor, double margin, Generator& generator) {
    std::vector<SurfacePoint> points;
    for (int i = 0; i < 400; ++i) {
        const double x = margin + (1 - 2 * margin) * uniform(generator),
                     y = margin + (1 - 2 * margin) * uniform(generator);
        points.push_back(scene_builder::front_of(floor.scene, floor.at(x, y)));
    }
    return points;
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    std::vector<TiledFloor> floors;
    std::vector<double> places;
    for (const int cells : {141, 45, 26, 14, 7, 3, 1})  // none but the last fits 20 texels
        places.push_back(floors.emplace_back(cells, 20).triangle_area_in_texels());
    const double disc = run.has_mutation("the photon map's disc is a square") ? scene_builder::pi / 4 : 1;
    const auto one = [](double) { return 1.0; };
    std::vector<StabilityCurve> curves = {
        curve_at("photon map, irradiance", places, [&](double) { return disc; }),
        curve_at("light map, own texel, irradiance", places, one),
        // A single hit is off by half a quantum, and floats by their last bits: 2^-24 each, in the worst case
        // all in the same direction.
        curve_at("light map, flux kept", places, one, Expected::equal, 1e-6),
        // Corners are floats in units of texels, exact to 2^-20. The smallest legs are 0.14 texels, so this
        // is at worst 1.4e-5 of a triangle's area, and of a texel's if all errors have the same sign.
        curve_at(
            "light map, largest error of a texel's area", places, [](double) { return 0.0; }, Expected::equal,
            2e-5),
        // The centre of each texel lies in one triangle, so there are no more such triangles than texels.
        curve_at(
            "flux kept by triangles with a texel center", places,
            [](double area) { return std::min(1.0, area); }, Expected::at_most)};
    for (std::size_t i = 0; i < floors.size(); ++i)
        curves[3].points[i].measured = {largest_error_of_area(floors[i].texels)};

    run.for_each_seed([&](std::uint64_t seed) {
        Generator generator(seed);
        for (std::size_t i = 0; i < floors.size(); ++i) {
            const TiledFloor& floor = floors[i];
            common::HitBatch hits = irradiate(floor, run.either<std::size_t>(80'000, 20'000), generator);
            const double flux = flux_of(hits);
            const auto photon_map = photon_map_of(floor.scene, hits, within(floor.scene, radius));
            const common::HitBatch kept = on_triangles_with_center(floor, hits);
            if (run.has_mutation("triangles without a texel center get no texel")) hits = kept;
            const auto own = light_map_of<FlatModel>(floor.texels, hits, shlm::OwnTexel{});
            curves[0].points[i].measured.push_back(
                mean_irradiance(photon_map, points_on(floor, radius, generator)));
            curves[1].points[i].measured.push_back(mean_irradiance(own, points_on(floor, 0, generator)));
            curves[2].points[i].measured.push_back(flux_of(own) / flux);
            curves[4].points[i].measured.push_back(flux_of(kept) / flux);
        }
    });
    return curves;
}

const RegisteredCase registered(
    80,
    {.name = "small-triangles",
     .purpose = "Triangles smaller than a texel: a lightmap that is rasterised, texel by texel center, has "
                "no place for most of them and loses their light.",
     .scene = "A floor of 1 x 1 under vertical light of 1 W/m^2, cut into squares of two triangles each, "
              "20 x 20 texels across their edges. Radius of the photon map: 0.1.",
     .swept = "area of a triangle / area of a texel",
     .measured = "irradiance or flux / truth",
     .theory = "Irradiance and flux 1, all texels of one area. Triangles with a texel center keep the "
               "ratio of the areas, at most.",
     .advice = "No remedy needed: each triangle is clipped against every texel that it touches, and a hit "
               "finds its texel by its coordinates.",
     .mutations = {"the photon map's disc is a square", "triangles without a texel center get no texel"},
     .run = run,
     .logarithmic_swept = true});

}  // namespace
}  // namespace bench::stability
