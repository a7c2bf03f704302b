// 8. Texels by face: the cost of a mesh cut into ever smaller triangles if no lightmap coordinates say which
// of them belong together.
#include "bench/experiments/stability/sparse_hits.h"
#include "bench/experiments/stability/stability_case.h"
#include "bench/experiments/stability/tiled_floor.h"
#include "shlm/layout/face_charts.h"

namespace bench::stability {
namespace {

constexpr int texels_along = 20;
constexpr std::size_t texels = texels_along * texels_along;
constexpr double hits_per_texel = 10;

/// Makes vertical light of 1 W/m^2.
common::HitBatch irradiate(const TiledFloor& floor, Generator& generator) {
    constexpr double expected = hits_per_texel * texels;
    const auto flux = static_cast<float>(1 / expected);
    common::HitBatch hits;
    for (std::size_t i = poisson(expected, generator); i > 0; --i) {
        const double x = uniform(generator), y = uniform(generator);
        const common::SurfaceId on = floor.at(x, y);
        hits.push_back(common::position_at(floor.scene, on), {0, 0, -1}, {flux, flux, flux}, on);
    }
    return hits;
}

shlm::PreparedTexels by_face(const common::Scene& scene) {
    return {scene, shlm::find_lightmap_uv(scene), texels, shlm::TexelPlacement::face};
}

/// Makes texels where each triangle has its own chart.
shlm::PreparedTexels by_triangle(const common::Scene& scene) {
    std::vector<shlm::TexelChart> charts;
    for (std::uint32_t t = 0; t < scene.triangle.size(); ++t)
        charts.push_back(shlm::face_charts(scene, std::span(&t, 1), false, 1.0 / texels_along).front());
    shlm::PreparedTexels prepared = by_face(scene);
    prepared.layout = shlm::TexelLayout(scene, charts, texels);
    prepared.geometry = shlm::texel_geometry(scene, prepared.layout, common::SurfacePieces(scene));
    return prepared;
}

double variance(const TiledFloor& floor, const shlm::PreparedTexels& prepared, const common::HitBatch& hits,
                Generator& generator) {
    std::vector<common::SurfacePoint> points;
    for (std::size_t i = 0; i < 4 * texels; ++i) {
        const double x = uniform(generator), y = uniform(generator);
        points.push_back(scene_builder::front_of(floor.scene, floor.at(x, y)));
    }
    return mean_of(light_map_of<FlatModel>(prepared, hits, shlm::OwnTexel{}), points, square_of_error);
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    constexpr std::size_t finer = 3;  // the first floors have triangles smaller than texels
    std::vector<TiledFloor> floors;
    std::vector<shlm::PreparedTexels> by_faces, by_triangles;
    std::vector<double> places;
    const bool not_joined = run.has_mutation("triangles are not joined");
    for (const int cells : {141, 45, 26, 14, 7, 3, 1}) {
        const TiledFloor& floor = floors.emplace_back(cells, texels_along);
        by_faces.push_back(not_joined ? by_triangle(floor.scene) : by_face(floor.scene));
        if (places.size() < finer) by_triangles.push_back(by_triangle(floor.scene));
        places.push_back(floor.triangle_area_in_texels());
    }

    std::vector<StabilityCurve> curves = {
        curve_at(
            "texels by face, texels / wanted", places, [](double) { return 1.0; }, Expected::equal, 1e-9),
        curve_at("texels by face, variance", places, [](double) { return 1 / hits_per_texel; }),
        curve_at("each triangle by itself, variance", std::span(places).first(finer),
                 [](double area) { return 1 / (hits_per_texel * area); })};
    for (std::size_t i = 0; i < floors.size(); ++i)
        curves[0].points[i].measured = {static_cast<double>(by_faces[i].layout.texel_count()) / texels};
    run.for_each_seed([&](std::uint64_t seed) {
        Generator generator(seed);
        for (std::size_t i = 0; i < floors.size(); ++i) {
            const common::HitBatch hits = irradiate(floors[i], generator);
            curves[1].points[i].measured.push_back(variance(floors[i], by_faces[i], hits, generator));
            if (i < finer)
                curves[2].points[i].measured.push_back(variance(floors[i], by_triangles[i], hits, generator));
        }
    });
    return curves;
}

const RegisteredCase registered(
    83,
    {.name = "face-texels",
     .purpose =
         "Texels without lightmap coordinates: if each triangle had texels of its own, small ones would "
         "have too many, and each of these too few hits.",
     .scene = "A floor of 1 x 1 under vertical light of 1 W/m^2, cut into squares of two triangles each; "
              "400 texels are wanted, and 10 hits fall on the area of each.",
     .swept = "area of a triangle / area of a texel",
     .measured = "number of texels / wanted, and relative variance of the irradiance",
     .theory = "400 texels and a variance of 1/10, however the floor is cut. Each triangle by itself: 1/10 "
               "of the ratio of the areas.",
     .advice = "No remedy needed: triangles that are flat together share their texels "
               "(shlm/layout/flat_patches.h).",
     .mutations = {"triangles are not joined"},
     .run = run,
     .logarithmic_swept = true,
     .logarithmic_measured = true});

}  // namespace
}  // namespace bench::stability
