// 15. Rays through edges and vertices of a closed surface.
#include "bench/experiments/stability/aimed_rays.h"
#include "bench/experiments/stability/plain_embree.h"
#include "bench/experiments/stability/stability_case.h"

namespace bench::stability {
namespace {

/// Makes a sphere without its last `missing` triangles.
common::Scene sphere(int levels, std::size_t missing) {
    scene_builder::Mesh mesh = scene_builder::sphere({0, 0, 0}, 1, levels);
    mesh.triangle.resize(mesh.triangle.size() - missing);
    common::Scene scene;
    add(scene, mesh, scene_builder::diffuse({1, 1, 1}));
    return scene;
}

/// Rays are aimed at the whole sphere, and traced in what is left of it.
struct Sphere {
    common::Scene whole, there;
    common::RayScene robust;
    PlainEmbree plain;

    Sphere(int levels, std::size_t missing)
        : whole(sphere(levels, 0)), there(sphere(levels, missing)), robust(there), plain(there) {}
};

/// If a ray passes a vertex closer than rounding, the sign of each edge function is random. The ray misses
/// all n triangles there if all signs agree, with probability 2^(1 - n). The six vertices of the octahedron
/// have 4 edges, those from subdivision 6. Rays are aimed at corners of triangles.
double chance_of_slipping_through(double triangles) {
    const double corners = 3 * triangles, at_octahedron = 6 * 4;
    return (at_octahedron / 8 + (corners - at_octahedron) / 32) / corners;
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    const bool not_robust = run.has_mutation("Embree is not robust");
    const std::size_t missing = run.has_mutation("a triangle is missing") ? 1 : 0;
    std::vector<std::unique_ptr<Sphere>> spheres;
    std::vector<double> triangles;
    for (int levels = 0; levels <= run.either(7, 5); ++levels) {
        triangles.push_back(8 * std::pow(4.0, levels));
        spheres.push_back(std::make_unique<Sphere>(levels, missing));
    }
    const auto none = [](double) { return 0.0; };
    std::vector<StabilityCurve> curves = {
        curve_at("at random", triangles, none),
        curve_at("at random, packets", triangles, none),
        curve_at("at edges", triangles, none),
        curve_at("at edges, packets", triangles, none),
        curve_at("at vertices", triangles, chance_of_slipping_through, Expected::at_most),
        curve_at("at vertices, packets", triangles, chance_of_slipping_through, Expected::at_most),
        curve_at("at edges, Embree not robust", triangles, none, Expected::shown),
        curve_at("at vertices, Embree not robust", triangles, none, Expected::shown)};
    run.for_each_seed([&](std::uint64_t seed) {
        Generator generator(seed);
        for (std::size_t i = 0; i < spheres.size(); ++i) {
            const Sphere& at = *spheres[i];
            std::size_t judged = 0, shown = 6;
            for (const Aim aim : {Aim::anywhere, Aim::edges, Aim::vertices}) {
                const AimedRays rays =
                    aimed_rays(at.whole, aim, run.either<std::size_t>(50'000, 4'000), generator);
                const double plainly = escaped_singly(
                    rays, [&](const auto& from, const auto& along) { return at.plain.meets(from, along); });
                const double robustly = escaped_singly(rays, [&](const auto& from, const auto& along) {
                    return at.robust.nearest(from, along).has_value();
                });
                curves[judged++].points[i].measured.push_back(not_robust ? plainly : robustly);
                curves[judged++].points[i].measured.push_back(escaped_in_packets(rays, at.robust));
                if (aim != Aim::anywhere) curves[shown++].points[i].measured.push_back(plainly);
            }
        }
    });
    return curves;
}

const RegisteredCase registered(
    150,
    {.name = "watertight",
     .purpose = "Rays that pass between two triangles leave a closed room, and their light is lost.",
     .scene =
         "A sphere of triangles, an octahedron with its edges halved again and again, and rays from its "
         "middle that are aimed at random places, at points on edges and at vertices, alone and in packets. "
         "Seeds draw the rays.",
     .swept = "triangles of the sphere",
     .measured = "part of the rays that escape",
     .theory =
         "Robust: no ray slips through an edge, as both triangles reckon with the same number for it. At a "
         "vertex of n edges Embree promises nothing; by chance at most 2^(1 - n) of the rays that come "
         "nearer than rounding, where all n signs agree.",
     .advice =
         "Nothing to do for photons: next to none come that near to a vertex. Do not aim rays at vertices "
         "of meshes.",
     .mutations = {"Embree is not robust", "a triangle is missing"},
     .run = run,
     .logarithmic_swept = true});

}  // namespace
}  // namespace bench::stability
