// 15. Skinny triangles at grazing angles.
#include "bench/experiments/stability/aimed_rays.h"
#include "bench/experiments/stability/plain_embree.h"
#include "bench/experiments/stability/stability_case.h"

namespace bench::stability {
namespace {

/// Makes a corridor that is rotated, so that no coordinate is exact. Each wall has two triangles of its full
/// length.
common::Scene corridor(float length) {
    return scene_builder::moved(
        scene_builder::closed_box(scene_builder::diffuse({1, 1, 1}), {-length / 2, -0.5f, -0.5f},
                                  {length / 2, 0.5f, 0.5f}),
        scene_builder::skew_rotation(), {0, 0, 0});
}

/// Returns the distance from an edge, in widths, below which rounding decides on which side of it a ray
/// passes. The side is the sign of (edge x place) . direction. It is rounded by some 2^-24 of the lengths of
/// its factors, which is the square of the corridor's length l. At distance d from an edge that the ray is
/// nearly parallel to, at an angle of 1 / l, it is l d / l. So the side is random below d = l^2 2^-24. One
/// such edge does no harm, as both its triangles agree on the side. A ray slips through where several are
/// that near: a fraction d of those aimed at one edge, and d^2 of all.
double near_edges(double length) {
    return length * length * 0x1p-24;
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    constexpr double lengths[] = {1, 10, 100, 1e3, 1e4, 1e5};
    const bool not_robust = run.has_mutation("Embree is not robust");
    const auto near_two = [](double length) { return std::min(1.0, std::pow(near_edges(length), 2)); };
    const auto near_one = [](double length) { return std::min(1.0, near_edges(length)); };
    std::vector<StabilityCurve> curves = {
        curve_at("at random", lengths, near_two, Expected::at_most),
        curve_at("at random, packets", lengths, near_two, Expected::at_most),
        curve_at("at edges", lengths, near_one, Expected::at_most),
        curve_at("at edges, packets", lengths, near_one, Expected::at_most),
        curve_at("at edges, Embree not robust", lengths, near_one, Expected::shown)};
    std::vector<common::Scene> scenes;
    for (const double length : lengths) scenes.push_back(corridor(static_cast<float>(length)));
    run.for_each_seed([&](std::uint64_t seed) {
        Generator generator(seed);
        for (std::size_t i = 0; i < scenes.size(); ++i) {
            const common::RayScene robust(scenes[i]);
            const PlainEmbree plain(scenes[i]);
            std::size_t curve = 0;
            for (const Aim aim : {Aim::anywhere, Aim::edges}) {
                const AimedRays rays =
                    aimed_rays(scenes[i], aim, run.either<std::size_t>(100'000, 5'000), generator);
                const double plainly = escaped_singly(
                    rays, [&](const auto& from, const auto& along) { return plain.meets(from, along); });
                const double robustly = escaped_singly(rays, [&](const auto& from, const auto& along) {
                    return robust.nearest(from, along).has_value();
                });
                curves[curve++].points[i].measured.push_back(not_robust ? plainly : robustly);
                curves[curve++].points[i].measured.push_back(escaped_in_packets(rays, robust));
                if (aim == Aim::edges) curves[4].points[i].measured.push_back(plainly);
            }
        }
    });
    return curves;
}

const RegisteredCase registered(
    151,
    {.name = "skinny-triangles",
     .purpose =
         "Triangles many times longer than wide, met at grazing angles, where rounding is largest beside "
         "their width.",
     .scene =
         "A closed corridor 1 wide and high, its axis skew, each wall two triangles; rays from its middle "
         "tenth at random places of triangles and of edges, most of them nearly along the walls. Seeds draw "
         "the rays.",
     .swept = "length of the corridor / width",
     .measured = "part of the rays that escape",
     .theory =
         "Edges that a ray is nearly parallel to and passes within l^2 2^-24 widths are on either side of it "
         "by chance. One does no harm, as both its triangles agree; a ray slips through between several, "
         "at most l^2 2^-24 of those aimed at one, l^4 2^-48 of all.",
     .advice =
         "Nothing to do up to triangles 1000 times as long as wide. Cut longer ones where light must not "
         "leak.",
     .mutations = {"Embree is not robust"},
     .run = run,
     .logarithmic_swept = true,
     .logarithmic_measured = true});

}  // namespace
}  // namespace bench::stability
