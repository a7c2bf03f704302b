// Tests which surfaces cover a point, and which photons count below them.
#include "common/tracer/covering_surfaces.h"

#include <gtest/gtest.h>

#include "photonmap/photon_sinks.h"
#include "tests/support/scene_builder.h"
#include "tests/support/statistics.h"

namespace {

using namespace tests;
using common::CoveringSurfaces;
using common::HitBatch;
using photonmap::GatherSettings;

constexpr float nothing = std::numeric_limits<float>::infinity();

/// Makes a horizontal plate from (x, y) on, facing up.
Mesh plate(float height, float x = -1, float y = -1, float width = 2, float depth = 2) {
    return quad({x, y, height}, {width, 0, 0}, {0, depth, 0});
}

Scene scene_of(const std::vector<Mesh>& meshes) {
    Scene scene;
    for (const Mesh& mesh : meshes) add(scene, mesh, double_sided(diffuse({0.5f, 0.5f, 0.5f})));
    return scene;
}

/// A scene with its covering surfaces.
struct Layers {
    Scene scene;
    common::RayScene rays;
    CoveringSurfaces covers;

    explicit Layers(Scene made) : scene(std::move(made)), rays(scene), covers(rays) {}
    explicit Layers(const std::vector<Mesh>& meshes) : Layers(scene_of(meshes)) {}

    /// Returns the height above the point at (s, t) of the quad with this first triangle, as seen from its
    /// front.
    [[nodiscard]] float height_over(std::uint32_t triangle, float s, float t) const {
        return covers.height_over(front_of(scene, on_quad(triangle, s, t)));
    }
};

/// Makes a strip along y. It follows the floor from x = 0 to 1, bends up and back over itself in steps of 20
/// degrees, and ends flat at x = 0, `over` the floor.
Mesh strip_bent_over_itself(float over) {
    const float radius = over / 2;
    std::vector<Vec3> edge = {{0, 0, 0}};
    for (int step = 0; step <= 9; ++step) {
        const float angle = static_cast<float>(step) * std::numbers::pi_v<float> / 9;
        edge.emplace_back(1 + radius * std::sin(angle), 0, radius * (1 - std::cos(angle)));
    }
    edge.emplace_back(0, 0, over);
    Mesh mesh;
    for (std::size_t i = 0; i + 1 < edge.size(); ++i)
        mesh = joined(std::move(mesh), quad(edge[i], edge[i + 1] - edge[i], {0, 1, 0}));
    return mesh;
}

TEST(CoveringSurfaces, AreTheNearestAlongTheNormal) {
    const Layers layers({plate(0), plate(0.25f, 0), plate(0.5f)});
    EXPECT_EQ(layers.height_over(0, 0.75f, 0.5f), 0.25f);
    EXPECT_EQ(layers.height_over(0, 0.25f, 0.5f), 0.5f) << "beside the first";
    EXPECT_EQ(layers.height_over(2, 0.25f, 0.5f), 0.25f);
    EXPECT_EQ(layers.height_over(4, 0.5f, 0.5f), nothing);
}

TEST(CoveringSurfaces, LieOnTheSideThatIsLookedAt) {
    const Layers layers({plate(0), plate(0.25f)});
    const common::SurfacePoint from_below =
        common::surface_point_at(layers.scene, on_quad(2, 0.5f, 0.5f), {0, 0, 1});
    EXPECT_EQ(layers.covers.height_over(from_below), 0.25f);
}

TEST(CoveringSurfaces, AreNoneAtThePointItself) {
    for (const Vec3& offset : {Vec3(0, 0, 0), Vec3(100, -300, 200)}) {
        Scene scene = scene_of({plate(0), plate(0), quad({-1, -1, 0}, {0, 2, 0}, {2, 0, 0})});
        const Layers twice(moved(std::move(scene), skew_rotation(), offset));
        for (const std::uint32_t triangle : {0u, 2u, 4u})
            for (const float s : {0.1f, 0.3f, 0.7f})
                EXPECT_EQ(twice.height_over(triangle, s, 0.45f), nothing)
                    << "as often as it is there, on either side";
    }
}

TEST(CoveringSurfaces, AreNotTheSurfaceItself) {
    const Layers layers({strip_bent_over_itself(0.5f)});
    EXPECT_EQ(layers.height_over(0, 0.5f, 0.5f), nothing);
}

TEST(CoveringSurfaces, CountTheirMemory) {
    const Layers layers({sphere({0, 0, 0}, 1, 5)});
    EXPECT_GE(layers.covers.bytes(), layers.scene.triangle.size() * sizeof(std::uint32_t));
}

/// Adds vertical photons of flux 1 on the quad with this first triangle, on a grid of 40 x 40.
void light(HitBatch& hits, const Scene& scene, std::uint32_t triangle) {
    for (int j = 0; j < 40; ++j)
        for (int i = 0; i < 40; ++i) {
            const common::SurfaceId on =
                on_quad(triangle, (static_cast<float>(i) + 0.5f) / 40, (static_cast<float>(j) + 0.5f) / 40);
            hits.push_back(common::position_at(scene, on), {0, 0, -1}, {1, 1, 1}, on);
        }
}

HitBatch lit(const Scene& scene, std::initializer_list<std::uint32_t> quads) {
    HitBatch hits;
    for (const std::uint32_t triangle : quads) light(hits, scene, triangle);
    return hits;
}

template <class Sink>
auto map_of(const Layers& layers, const HitBatch& hits, const GatherSettings& settings, bool know_covers) {
    Sink sink(layers.scene, settings, know_covers ? &layers.covers : nullptr);
    sink.consume(std::span(&hits, 1));
    return std::move(sink).finish(1);
}

GatherSettings within(const Scene& scene, double radius) {
    return {.selection = photonmap::FixedRadius{radius / scene.diagonal()}};
}

template <class Sink>
class CoveredPhotonMap : public testing::Test {
  protected:
    /// Returns what a map of these photons gives at the front of (s, t) of a quad.
    static float read(const Layers& layers, const HitBatch& hits, const GatherSettings& settings,
                      std::uint32_t triangle, float s, float t) {
        return map_of<Sink>(layers, hits, settings, true)
            .irradiance(front_of(layers.scene, on_quad(triangle, s, t)))
            .x;
    }
};

// The engines that find all photons.
using Sinks = testing::Types<photonmap::FlannPhotonSink, photonmap::NanoflannPhotonSink,
                             photonmap::GridPhotonSink, photonmap::CompactPhotonSink>;
class SinkNames {
  public:
    template <class Sink>
    static std::string GetName(int i) {
        return std::array{"flann", "nanoflann", "grid", "compact"}[static_cast<std::size_t>(i)];
    }
};
TYPED_TEST_SUITE(CoveredPhotonMap, Sinks, SinkNames);

TYPED_TEST(CoveredPhotonMap, ReadsNothingOfThePanelOverThePoint) {
    for (const float height : {0.001f, 0.1f, 0.25f}) {
        const Layers layers({plate(0), plate(height)});
        const GatherSettings settings = within(layers.scene, 0.3);
        const HitBatch panel = lit(layers.scene, {2}), both = lit(layers.scene, {0, 2});
        EXPECT_EQ(this->read(layers, panel, settings, 0, 0.4f, 0.6f), 0) << height;
        EXPECT_EQ(this->read(layers, both, settings, 0, 0.4f, 0.6f),
                  this->read(layers, lit(layers.scene, {0}), settings, 0, 0.4f, 0.6f))
            << height;
        EXPECT_GT(map_of<TypeParam>(layers, panel, settings, false)
                      .irradiance(front_of(layers.scene, on_quad(0, 0.4f, 0.6f)))
                      .x,
                  50)
            << "by normals alone";
    }
}

TYPED_TEST(CoveredPhotonMap, ReadsThePanelBesideThePoint) {
    const Layers layers({plate(0), plate(0.001f, 0)});
    const HitBatch panel = lit(layers.scene, {2});
    EXPECT_GT(this->read(layers, panel, within(layers.scene, 0.3), 0, 0.48f, 0.5f), 50);
}

TYPED_TEST(CoveredPhotonMap, ReadsWhatIsHigherButNotAsHighAsTheCover) {
    // A step beside the floor, below a canopy over both.
    const Layers layers({plate(0, -1, -1, 1), plate(0.05f, 0, -1, 1), plate(0.2f)});
    const GatherSettings settings = within(layers.scene, 0.3);
    const HitBatch step = lit(layers.scene, {2}), all = lit(layers.scene, {2, 4});
    const float expected = this->read(layers, step, settings, 0, 0.95f, 0.5f);
    EXPECT_GT(expected, 50);
    EXPECT_EQ(this->read(layers, all, settings, 0, 0.95f, 0.5f), expected);
}

/// Expects a map to give the same answers, at the front of each triangle, as one that only tests normals.
template <class Sink>
void expect_the_same_everywhere(const Layers& layers, const GatherSettings& settings) {
    HitBatch hits;
    for (std::uint32_t t = 0; t < layers.scene.triangle.size(); ++t)
        for (const float u : {0.1f, 0.3f, 0.5f})
            for (const float v : {0.1f, 0.2f, 0.4f}) {
                const common::SurfaceId on{t, u, v};
                for (const float side : {-1.0f, 1.0f})
                    hits.push_back(common::position_at(layers.scene, on),
                                   layers.scene.geometric_normal[t] * side, {1, 1, 1}, on);
            }
    const auto knowing = map_of<Sink>(layers, hits, settings, true);
    const auto not_knowing = map_of<Sink>(layers, hits, settings, false);
    float sum = 0;
    for (std::uint32_t t = 0; t < layers.scene.triangle.size(); ++t) {
        const common::SurfacePoint point = front_of(layers.scene, {t, 0.25f, 0.25f});
        const float irradiance = knowing.irradiance(point).x;
        EXPECT_EQ(irradiance, not_knowing.irradiance(point).x) << "triangle " << t;
        sum += irradiance;
    }
    EXPECT_GT(sum, 0);
}

/// Returns the mesh with no shared vertices and each triangle slightly apart from its neighbours.
Mesh torn(Mesh mesh) {
    Mesh soup;
    for (const common::TriangleVertices& corners : mesh.triangle) {
        Vec3 middle(0, 0, 0);
        for (const std::uint32_t corner : corners) middle += mesh.position[corner] / 3;
        const auto first = static_cast<std::uint32_t>(soup.position.size());
        for (const std::uint32_t corner : corners)
            soup.position.push_back(middle + (mesh.position[corner] - middle) * 0.999f);
        soup.triangle.push_back({first, first + 1, first + 2});
    }
    return soup;
}

/// Returns the same triangles with the opposite orientation.
Mesh turned_inside_out(Mesh mesh) {
    for (common::TriangleVertices& corners : mesh.triangle) std::swap(corners[1], corners[2]);
    for (Vec3& normal : mesh.normal) normal = -normal;
    return mesh;
}

TYPED_TEST(CoveredPhotonMap, AnswersAsByNormalsAloneWhereNothingIsCovered) {
    const Mesh ball = sphere({0, 0, 0}, 1, 3);
    const std::pair<const char*, std::vector<Mesh>> scenes[] = {
        {"a sphere", {ball}},
        {"a sphere's inside", {turned_inside_out(ball)}},
        {"a soup", {torn(ball)}},
        {"a soup's inside", {turned_inside_out(torn(ball))}},
        {"edges that do not match",
         {plate(0, -1, -1, 1), plate(0, 0, -1, 1, 0.7f), plate(0, 0, -0.3f, 1, 1.3f)}},
        {"a corner", {plate(0), quad({-1, -1, 0}, {0, 2, 0}, {0, 0, 1})}},
        {"steps", {plate(0, -1, -1, 1), quad({0, 1, 0}, {0, -2, 0}, {0, 0, 0.1f}), plate(0.1f, 0, -1, 1)}},
        {"a recess", {plate(0, -1, -1, 0.9f), plate(-0.01f, -0.1f, -1, 0.2f), plate(0, 0.1f, -1, 0.9f)}},
        {"a surface that bends over itself", {strip_bent_over_itself(0.1f)}},
        {"the same surface twice", {plate(0), plate(0)}}};
    for (const auto& [name, meshes] : scenes) {
        SCOPED_TRACE(name);
        const Layers layers(moved(scene_of(meshes), skew_rotation(), {3, 4, 5}));
        expect_the_same_everywhere<TypeParam>(layers, within(layers.scene, 0.4));
    }
}

TYPED_TEST(CoveredPhotonMap, TakesTheNearestOfThoseThatCount) {
    if constexpr (!std::is_same_v<TypeParam, photonmap::GridPhotonSink>) {
        const Layers layers({plate(0), plate(0.001f)});
        const GatherSettings settings{photonmap::NearestPhotons{10}, {}, 0.5f};
        EXPECT_EQ(this->read(layers, lit(layers.scene, {0, 2}), settings, 0, 0.41f, 0.63f),
                  this->read(layers, lit(layers.scene, {0}), settings, 0, 0.41f, 0.63f));
    }
}

}  // namespace
