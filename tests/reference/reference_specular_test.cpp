// Tests the reference where the answer is known: light by way of mirrors and glass.
#include "common/reference/directions.h"
#include "common/reference/specular.h"
#include "common/tracer/scatter.h"
#include "tests/support/reference_tracing.h"
#include "tests/support/tracing.h"

namespace {

using namespace tests;
using common::reference::specular_arrival;

constexpr std::uint64_t seed = 1;
constexpr std::uint64_t passes = count_for(65, 17);

const Material black = diffuse(Rgb(0, 0, 0));

/// Returns the same triangles with their geometric normals and no shared vertices.
Mesh faceted(const Mesh& mesh) {
    Mesh flat;
    for (const auto& [i, j, k] : mesh.triangle) {
        const auto first = static_cast<std::uint32_t>(flat.position.size());
        flat.position.insert(flat.position.end(), {mesh.position[i], mesh.position[j], mesh.position[k]});
        flat.triangle.push_back({first, first + 1, first + 2});
    }
    return flat;
}

/// Adds a box that faces outwards.
void add_block(Scene& scene, const Vec3& low, const Vec3& high, const Material& material) {
    for (Mesh wall : box_walls(low, high)) {
        for (auto& [i, j, k] : wall.triangle) std::swap(j, k);
        add(scene, wall, material);
    }
}

// --- plane mirror: the panel is seen where its image is

TEST(ReferenceMirror, ShowsAPanelWhereItsImageIs) {
    Scene scene;
    add(scene, quad({-4, 0, -4}, {0, 0, 8}, {8, 0, 0}), black);                                      // up
    add(scene, quad({-0.5f, 1, -0.5f}, {0, 0, 1}, {1, 0, 0}), diffuse(Rgb(0, 0, 0), Rgb(9, 9, 9)));  // up
    add(scene, quad({-4, 2, -4}, {8, 0, 0}, {0, 0, 8}), mirror(Rgb(0.9f, 0.5f, 0.2f)));              // down
    const Mesh image = quad({-0.5f, 3, -0.5f}, {0, 0, 1}, {1, 0, 0});
    std::vector<SurfacePoint> points;
    std::vector<V3d> expected;
    for (const Vec2& xz : {Vec2(3, 0), Vec2(-2.5f, 1), Vec2(2, 2)}) {  // out of the panel's own shadow
        points.push_back(front_of(scene, on_quad(0, (xz.y + 4) / 8, (xz.x + 4) / 8)));
        expected.push_back(V3d(0.9f, 0.5f, 0.2f) * (9 * lambert(image.position, points.back().position,
                                                                points.back().shading_normal)));
    }
    expect_irradiance(trace_reference(scene, points, seed, 2 * passes - 1), expected);
}

TEST(ReferenceMirror, MayEmitItself) {
    Scene scene;
    add(scene, quad({-4, 0, -4}, {0, 0, 8}, {8, 0, 0}), black);
    Material lamp = mirror();
    lamp.emitted_radiance = Rgb(3, 3, 3);
    const Mesh panel = quad({-1, 2, -1}, {2, 0, 0}, {0, 0, 2});  // down
    add(scene, panel, lamp);
    const SurfacePoint point = front_of(scene, on_quad(0, 0.6f, 0.5f));
    const std::vector<double> expected = {3 * lambert(panel.position, point.position, point.shading_normal)};
    expect_irradiance(trace_reference(scene, std::span(&point, 1), seed, passes), std::span(expected));
}

// --- glass

/// Returns the transmittance of a plate at this cosine with all reflections inside it: (1 - R) / (1 + R),
/// with R of one face by Fresnel's two formulae (1823), of sines and tangents.
double through_plate(double cosine, double index) {
    const double angle = std::acos(cosine), bent = std::asin(std::sin(angle) / index);
    const auto plate = [](double r) { return (1 - r) / (1 + r); };
    const double s = std::sin(angle - bent) / std::sin(angle + bent);
    const double p = std::tan(angle - bent) / std::tan(angle + bent);
    // Physically, each polarisation is transmitted separately; here, surfaces mix them at each face.
    return plate(0.5 * (s * s + p * p));
}

TEST(ReferenceGlass, PlateLetsThroughWhatItDoesNotReflect) {
    constexpr float half = 2000, index = 1.5f;
    Scene scene;
    add(scene, quad({-half, 0, -half}, {0, 0, 2 * half}, {2 * half, 0, 0}), black);
    add_block(scene, {-half, 1, -half}, {half, 1.5f, half}, glass(index));
    scene.sky = common::Sky{Rgb(1, 1, 1)};
    double expected = 0;
    constexpr int steps = 100'000;
    for (int i = 0; i < steps; ++i) {
        const double cosine_sq = (i + 0.5) / steps;  // flux from a uniform sky is uniform in it
        expected += through_plate(std::sqrt(cosine_sq), static_cast<double>(index)) * pi / steps;
    }
    EXPECT_NEAR(expected / pi, 0.85, 0.02);
    const SurfacePoint point = front_of(scene, on_quad(0, 0.5f, 0.5f));
    const std::vector<double> all = {expected};
    expect_irradiance(trace_reference(scene, std::span(&point, 1), seed, 4 * passes - 3), std::span(all));
}

/// Makes a box that emits 1 and reflects half, so that radiance is 2 everywhere.
Scene furnace() {
    return closed_box(diffuse(Rgb(0.5f, 0.5f, 0.5f), Rgb(1, 1, 1)));
}

TEST(ReferenceGlass, ChangesNothingInAFurnace) {
    for (const Material& material : {glass(1.5f), glass(2.4f), mirror()}) {
        Scene scene = furnace();
        add(scene, faceted(sphere({0.1f, -0.2f, 0.3f}, 0.6f, 2)), material);
        std::mt19937 engine(static_cast<unsigned>(seed));
        std::vector<SurfacePoint> points;
        for (int i = 0; i < 20; ++i) points.push_back(random_point(scene, fronts(0, 12), engine));
        const std::vector<double> expected(points.size(), 2 * pi);
        expect_irradiance(trace_reference(scene, points, seed, passes), std::span(expected));
    }
}

/// In glass, radiance is its squared index times the radiance outside. A plate that emits half of that inside
/// does not change the furnace.
TEST(ReferenceGlass, HoldsRadianceByTheSquareOfItsIndex) {
    constexpr float index = 1.5f, inside = 2 * index * index;
    Scene scene = furnace();
    add_block(scene, {-0.5f, -0.4f, -0.6f}, {0.5f, 0.4f, 0.6f}, glass(index));
    const Material in_glass = diffuse(Rgb(0.5f, 0.5f, 0.5f), Rgb(inside / 2, inside / 2, inside / 2));
    add(scene, quad({-0.2f, 0, -0.2f}, {0.4f, 0.1f, 0}, {0, 0.1f, 0.4f}), double_sided(in_glass));
    const auto plate = static_cast<std::uint32_t>(scene.triangle.size()) - 2;
    std::mt19937 engine(static_cast<unsigned>(seed));
    std::vector<SurfacePoint> points;
    std::vector<double> expected;
    for (int i = 0; i < 12; ++i) {
        const LitFace face{plate + static_cast<std::uint32_t>(i % 2), i % 4 < 2};
        points.push_back(random_point(scene, std::span(&face, 1), engine));
        expected.push_back(pi * static_cast<double>(inside));
        points.push_back(random_point(scene, fronts(0, 12), engine));
        expected.push_back(2 * pi);
    }
    expect_irradiance(trace_reference(scene, points, seed, passes), std::span(expected));
}

constexpr std::size_t room_points = count_for(10'000, 500);

/// Makes white walls of albedo one half, one of them emitting, around a coarse sphere with smooth normals.
Scene room_with_sphere(const Material& material) {
    Scene scene;
    const auto walls = box_walls({-1, -1, -1}, {1, 1, 1});
    for (std::size_t i = 0; i < walls.size(); ++i)
        add(scene, walls[i], diffuse(Rgb(0.5f, 0.5f, 0.5f), i == 3 ? Rgb(1, 1, 1) : Rgb(0, 0, 0)));
    add(scene, sphere({0.1f, -0.1f, 0.2f}, 0.75f, 1), material);
    return scene;
}

/// Smooth normals on coarse facets deflect light about a normal that is not the surface's own, but no energy
/// may be lost.
TEST(ReferenceMirror, KeepsTheEnergyWithSmoothNormals) {
    expect_closed_room(room_with_sphere(mirror()), fronts(0, 12), 4 * pi, 0.5, room_points);
}

/// Facets that refract light like a round ball may trap some of it. The photon tracer tells how much reaches
/// the walls.
TEST(ReferenceGlass, GivesTheWallsWhatPhotonsDoWithSmoothNormals) {
    const Scene scene = room_with_sphere(glass());
    struct FluxSum {
        double flux = 0;
        void consume(std::span<const common::HitBatch> wave) {
            for (const common::HitBatch& batch : wave)
                for (const Rgb& f : batch.flux) flux += static_cast<double>(f.x);
        }
    };
    Sample photons;
    for (std::uint64_t run = 0; run < count_for(40, 10); ++run) {
        FluxSum sum;
        const auto report = trace(scene, run, {.photons = count_for(10'000, 500)}, sum);
        photons.add(sum.flux * static_cast<double>(report.watts_per_flux()) / 24);  // the walls' area
    }
    const Sample points = mean_irradiance(scene, fronts(0, 12), room_points);
    EXPECT_NEAR(points.mean(), photons.mean(),
                z_for(1e-5) * std::hypot(points.standard_error(), photons.standard_error()));
}

// --- comparison with the photon tracer's scattering

/// Makes one triangle whose vertex normals are tilted in different directions.
Scene crooked(const Material& material) {
    Mesh mesh;
    mesh.position = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normal = {Vec3(1, 0.3f, 1).normalized(), Vec3(-0.5f, 1, 0.9f).normalized(),
                   Vec3(1.2f, -0.8f, 0.7f).normalized()};
    mesh.triangle = {{0, 1, 2}};
    Scene scene;
    add(scene, mesh, material);
    return scene;
}

/// Returns features of a pair of directions: indicators of their sides, and products of cosines.
std::array<double, 8> features(const V3d& arriving_from, const V3d& leaving) {
    const V3d a = V3d(1, 2, 3).normalized(), b = V3d(-2, 1, 0.5).normalized();
    const double i = arriving_from.dot(a), o = leaving.dot(b);
    const double from_front = arriving_from.z > 0, to_front = leaving.z > 0;
    return {
        1,     from_front * to_front, from_front * (1 - to_front), to_front * (1 - from_front), i * i, o * o,
        i * o, i * i * o * o};
}

/// Light of radiance 1 from everywhere is sorted by its incoming and outgoing directions: photons and adjoint
/// must agree. Of eight features in two materials at five places, one fails by chance with probability 1e-5.
TEST(ReferenceSpecular, IsTheAdjointOfThePhotonTracer) {
    using common::reference::cosine_direction;
    const std::uint64_t count = count_for(1'000'000, 20'000);
    for (const Material& material : {glass(1.6f), mirror()}) {
        const Scene scene = crooked(material);
        for (const Vec2& uv :
             {Vec2(0.1f, 0.1f), Vec2(0.8f, 0.1f), Vec2(0.1f, 0.8f), Vec2(0.33f, 0.33f), Vec2(0.5f, 0.1f)}) {
            const SurfaceId place{0, uv.x, uv.y};
            std::mt19937 engine(static_cast<unsigned>(seed));
            std::uniform_real_distribution<double> uniform(0, 1);
            std::array<Sample, 8> difference;
            for (std::uint64_t n = 0; n < count; ++n) {
                const Vec3 side(0, 0, n % 2 == 0 ? 1.0f : -1.0f);
                const auto direction = [&] {
                    return cosine_direction(side, {uniform(engine), uniform(engine)});
                };
                std::array<double, 8> by_photon{}, by_adjoint{};
                const Vec3 from = direction(), to = direction();
                const auto u = static_cast<float>(uniform(engine));
                if (const auto photon = common::scatter(scene, place, -from, Rgb(1, 1, 1), {0, 0, 0, u}))
                    by_photon = features(V3d(from), V3d(photon->direction));
                // Glass of index n has n^2 times the radiance outside; here it also has radiance 1.
                if (const auto arrival = specular_arrival(scene, place, to, uniform(engine))) {
                    by_adjoint = features(V3d(arrival->towards), V3d(to));
                    for (double& feature : by_adjoint) feature *= arrival->factor;
                }
                for (std::size_t f = 0; f < 8; ++f) difference[f].add(by_photon[f] - by_adjoint[f]);
            }
            for (std::size_t f = 0; f < 8; ++f)
                EXPECT_NEAR(difference[f].mean(), 0,
                            z_for(1e-5 / 80) * difference[f].standard_error() + 1e-12)
                    << "feature " << f << " at " << uv.x << ", " << uv.y;
        }
    }
}

TEST(ReferenceSpecular, ReflectsAsFresnelSays) {
    using common::reference::reflected_fraction;
    for (const double index : {1.2, 1.5, 2.4, 1 / 1.5, 1 / 2.4})
        for (double cosine = 0.001; cosine < 1; cosine += 0.01)
            EXPECT_NEAR(reflected_fraction(cosine, index),
                        static_cast<double>(common::fresnel_reflectance(static_cast<float>(cosine),
                                                                        static_cast<float>(1 / index))),
                        2e-4)
                << cosine << ", index " << index;
    EXPECT_NEAR(reflected_fraction(1, 1.5), 0.04, 1e-12);
    EXPECT_EQ(reflected_fraction(0.5, 1 / 1.5), 1);
}

}  // namespace
