// Nearest texels on a pillar whose circumference is a few texels: which ones are nearest changes from row to
// row.
#include <algorithm>
#include <cmath>

#include "bench/experiments/stability/known_light.h"
#include "bench/experiments/stability/stability_case.h"

namespace bench::stability {
namespace {

using common::Vec3;
using scene_builder::pi;

constexpr int faces = 8, rows = 8;  // each face is one texel wide
constexpr double radius = 1;
const double face_width = 2 * radius * std::sin(pi / faces);

/// The normal of face 0 is +x. Parallel light comes from between it and the normal of face 1.
constexpr double light_from = pi / 6;
double irradiance_of(int face) {
    return std::max(0.0, std::cos(2 * pi * face / faces - light_from));
}

/// Makes a pillar around the z axis. Each face has its own lightmap: one column of texels of this height.
common::Scene pillar(double height) {
    const auto corner = [](int k) {
        const double angle = 2 * pi * (k - 0.5) / faces;
        return Vec3(Imath::V3d(radius * std::cos(angle), radius * std::sin(angle), 0));
    };
    const Vec3 up(0, 0, static_cast<float>(rows * height));
    common::Scene scene;
    for (int k = 0; k < faces; ++k) {
        scene_builder::Mesh face = scene_builder::quad(corner(k), corner(k + 1) - corner(k), up);
        face.position[1] = corner(k + 1);  // not rounded: it is the next face's
        face.position[2] = corner(k + 1) + up;
        add(scene, face, scene_builder::diffuse({0.5f, 0.5f, 0.5f}));
    }
    return scene;
}

/// Distance from face 0, in widths of face 1. Points are on face 1, `above` rows over the middle of each row
/// that has neighbours.
constexpr double across = 0.25;
std::vector<common::SurfacePoint> points_in_rows(const common::Scene& scene, double above) {
    std::vector<common::SurfacePoint> points;
    for (int row = 2; row < rows - 2; ++row)
        points.push_back(scene_builder::front_of(
            scene, scene_builder::on_quad(2, static_cast<float>(across),
                                          static_cast<float>((row + 0.5 + above) / rows))));
    return points;
}

/// Returns the mean over the four nearest texels of faces 0, 1 and 2, weighted by their areas projected on
/// face 1.
double seen_by_nearest(double above, double height) {
    struct Near {
        double distance_sq;
        int face;
    };
    std::vector<Near> near;
    const auto center = [](int face) {
        const double angle = 2 * pi * face / faces, inner = radius * std::cos(pi / faces);
        return Imath::V2d(inner * std::cos(angle), inner * std::sin(angle));
    };
    const double side = 2 * pi / faces + pi / 2;  // along face 1
    const Imath::V2d point =
        center(1) + Imath::V2d(std::cos(side), std::sin(side)) * ((across - 0.5) * face_width);
    for (int face = 0; face < 3; ++face)
        for (int row = -3; row <= 3; ++row)
            near.push_back({(center(face) - point).length2() + std::pow((row - above) * height, 2), face});
    std::partial_sort(near.begin(), near.begin() + 4, near.end(),
                      [](const Near& a, const Near& b) { return a.distance_sq < b.distance_sq; });
    double sum = 0, weights = 0;
    for (int i = 0; i < 4; ++i) {
        const double weight = std::cos(2 * pi * (near[static_cast<std::size_t>(i)].face - 1) / faces);
        sum += weight * irradiance_of(near[static_cast<std::size_t>(i)].face);
        weights += weight;
    }
    return sum / weights;
}

constexpr double in_the_middle = 0.05,
                 at_the_edge = 0.45;  // rows; off the places where two texels are as near

std::vector<StabilityCurve> run(const CaseRun& run) {
    constexpr double ratios[] = {0.75, 0.9, 1.1, 1.4, 2, 3};  // no two texels tie at these
    const auto bead = [](double ratio) {
        const double height = ratio * face_width;
        return seen_by_nearest(in_the_middle, height) / seen_by_nearest(at_the_edge, height);
    };
    const auto even = [](double) { return 1.0; };
    std::vector<StabilityCurve> curves = {
        curve_at("light map, 4 nearest texels, as in the paper", ratios, bead),
        curve_at("light map, 4 nearest of the own surface", ratios, bead),
        curve_at("light map, bilinear", ratios, even), curve_at("light map, own texel", ratios, even)};
    std::vector<common::Scene> scenes;
    std::vector<shlm::PreparedTexels> prepared;
    for (const double ratio : ratios) {
        scenes.push_back(pillar(ratio * face_width));
        prepared.push_back(texels_of(scenes.back(), faces * rows));
    }
    const bool other_gather = run.has_mutation("the texels around the point");

    run.for_each_seed([&](std::uint64_t seed) {
        Generator generator(seed);
        for (std::size_t i = 0; i < std::size(ratios); ++i) {
            common::HitBatch hits;
            for (std::uint32_t face = 0; face < faces; ++face) {
                const auto irradiance = static_cast<float>(irradiance_of(static_cast<int>(face)));
                if (irradiance == 0) continue;
                const std::size_t first = hits.size();
                irradiate_quad(hits, scenes[i], 2 * face, run.either<std::size_t>(100'000, 20'000), generator,
                               always(-scenes[i].geometric_normal[2 * face]));
                for (std::size_t hit = first; hit < hits.size(); ++hit) hits.flux[hit] *= irradiance;
            }
            const auto middle = points_in_rows(scenes[i], in_the_middle);
            const auto edge = points_in_rows(scenes[i], at_the_edge);
            const shlm::Gather nearest =
                other_gather ? shlm::Gather(shlm::Bilinear{}) : shlm::NearestTexels{4, false};
            const shlm::Gather gathers[] = {nearest, shlm::NearestTexels{4, true}, shlm::Bilinear{},
                                            shlm::OwnTexel{}};
            for (std::size_t g = 0; g < std::size(gathers); ++g) {
                const auto map = light_map_of<FlatModel>(prepared[i], hits, gathers[g]);
                curves[g].points[i].measured.push_back(mean_irradiance(map, middle) /
                                                       mean_irradiance(map, edge));
            }
        }
    });
    return curves;
}

const RegisteredCase registered(
    41,
    {.name = "narrow-pillar",
     .purpose = "Beads on pillars, bars and pipes that are narrower than two texels: the four nearest texels "
                "are one "
                "face's and both neighbours' in the middle of a row, and two faces' between rows.",
     .scene = "A pillar of eight faces, each one texel wide, in parallel light of 1 W/m^2 by 100,000 photons "
              "a lit "
              "face (short form: 20,000). A quarter of a face's width beside an edge.",
     .swept = "height of a texel / its width",
     .measured = "irradiance in the middle of rows / that between rows",
     .theory =
         "Nearest texels: the weighted means of the faces' exact irradiances over the four nearest places of "
         "the texels. All others: 1.",
     .advice = "None of the gathers by nearest texels avoids it. Bilinear does, and so do texels that are a "
               "quarter "
               "of the pillar's width.",
     .mutations = {"the texels around the point"},
     .run = run});

}  // namespace
}  // namespace bench::stability
