// glTF loader: tangents for normal maps of files without tangents.
#include <cmath>
#include <map>
#include <numbers>

#include "common/scene/surface_point.h"
#include "tests/support/load_gltf.h"

namespace {

using namespace gltf_text;

constexpr float pi = std::numbers::pi_v<float>;

/// Returns a PNG of one pixel, 230, 160, 200: a normal that is tilted along u.
Bytes leaning_png() {
    return {0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A, 0x00, 0x00, 0x00, 0x0D, 0x49, 0x48,
            0x44, 0x52, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x02, 0x00, 0x00,
            0x00, 0x90, 0x77, 0x53, 0xDE, 0x00, 0x00, 0x00, 0x0C, 0x49, 0x44, 0x41, 0x54, 0x78,
            0xDA, 0x63, 0x78, 0xB6, 0xE0, 0x04, 0x00, 0x04, 0xBE, 0x02, 0x4F, 0xE8, 0xFE, 0x3E,
            0x6B, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4E, 0x44, 0xAE, 0x42, 0x60, 0x82};
}

struct Vertex {
    Vec3 position, normal;
    Vec2 uv;
};

/// Makes a mesh with a normal map in the image file "leaning.png".
GltfFile mapped(const std::vector<Vertex>& vertices, const std::vector<std::uint32_t>& indices) {
    std::vector<float> position, normal, uv;
    for (const Vertex& v : vertices) {
        position.insert(position.end(), {v.position.x, v.position.y, v.position.z});
        normal.insert(normal.end(), {v.normal.x, v.normal.y, v.normal.z});
        uv.insert(uv.end(), {v.uv.x, v.uv.y});
    }
    GltfFile file;
    const int positions = file.add_accessor<float>(position, f32, "VEC3");
    const int normals = file.add_accessor<float>(normal, f32, "VEC3");
    const int texcoords = file.add_accessor<float>(uv, f32, "VEC2");
    file.document["meshes"] = {
        {{"primitives",
          {{{"attributes", {{"POSITION", positions}, {"NORMAL", normals}, {"TEXCOORD_0", texcoords}}},
            {"indices", file.add_accessor<std::uint32_t>(indices, u32, "SCALAR")}}}}}};
    file.document["nodes"] = {{{"mesh", 0}}};
    file.document["scenes"] = {{{"nodes", {0}}}};
    file.document["textures"] = {{{"source", 0}}};
    file.document["images"] = {{{"uri", "leaning.png"}}};
    file.material() = matt();
    file.material()["normalTexture"] = {{"index", 0}};
    return file;
}

/// Returns texture coordinates in which u grows along `degrees` from +x towards +y, with v downwards.
Vec2 turned(float x, float y, float degrees, bool is_mirrored = false) {
    const float c = std::cos(degrees * pi / 180), s = std::sin(degrees * pi / 180);
    return {c * x + s * y, (is_mirrored ? 1.0f : -1.0f) * (c * y - s * x)};
}

Vec3 direction(float degrees) {
    return {std::cos(degrees * pi / 180), std::sin(degrees * pi / 180), 0};
}

/// Makes two triangles, 0 1 2 and 0 2 3, in the plane z = 0, with angles of 90 and 45 degrees at the origin.
/// The first has u = x and v = -y.
std::vector<Vertex> fan(const Vec2& last_uv) {
    const Vec3 up(0, 0, 1);
    return {{{0, 0, 0}, up, {0, 0}},
            {{1, 0, 0}, up, {1, 0}},
            {{0, 1, 0}, up, {0, -1}},
            {{-1, 1, 0}, up, last_uv}};
}

/// Returns the tangents of the triangles' corners at `position`, by their sign.
std::map<float, Vec3> tangents_at(const Scene& scene, const Vec3& position) {
    std::map<float, Vec3> tangents;
    for (const auto& triangle : scene.triangle) {
        for (const std::uint32_t vertex : triangle) {
            if (scene.position[vertex] == position)
                tangents[scene.tangent_sign[vertex]] = scene.tangent[vertex];
        }
    }
    return tangents;
}

class TangentsOfMaps : public LoadGltf {
  protected:
    void SetUp() override { directory.write("leaning.png", leaning_png()); }
};

TEST_F(TangentsOfMaps, AreMeansByAngle) {
    const Scene scene = load(mapped(fan({-1, -2}), {0, 1, 2, 0, 2, 3}));
    // In the second, u = x and v = x - y: along (1, 1, 0), u grows and v is constant.
    const Vec3 second = Vec3(1, 1, 0).normalized();
    const Vec3 mean = (Vec3(1, 0, 0) * (pi / 2) + second * (pi / 4)).normalized();
    const auto tangents = tangents_at(scene, {0, 0, 0});
    ASSERT_EQ(tangents.size(), 1u);
    expect_near(tangents.at(1), mean);
    // Corners of a single triangle have its own tangent.
    expect_near(tangents_at(scene, {1, 0, 0}).at(1), {1, 0, 0});
    expect_near(tangents_at(scene, {-1, 1, 0}).at(1), second);
    EXPECT_EQ(scene.position.size(), 4u) << "no vertex has become two";
}

TEST_F(TangentsOfMaps, LieAcrossTheNormal) {
    std::vector<Vertex> vertices = fan({-1, -2});
    for (Vertex& v : vertices) v.normal = Vec3(0.6f, 0, 0.8f);
    const Scene scene = load(mapped(vertices, {0, 1, 2, 0, 2, 3}));
    for (std::size_t v = 0; v < 4; ++v) {
        EXPECT_NEAR(scene.tangent[v].dot(scene.normal[v]), 0, 1e-6);
        EXPECT_NEAR(scene.tangent[v].length(), 1, 1e-6);
    }
    expect_near(tangents_at(scene, {1, 0, 0}).at(1), {0.8f, 0, -0.6f});
}

TEST_F(TangentsOfMaps, AreNotSharedAcrossMirrorsOrCreases) {
    // u grows away from the y axis on both sides.
    const Vec3 up(0, 0, 1);
    std::vector<Vertex> vertices = {{{0, 0, 0}, up, {0, 0}},
                                    {{0, 1, 0}, up, {0, -1}},
                                    {{1, 0, 0}, up, {1, 0.2f}},
                                    {{-1, 0, 0}, up, {1, 0.2f}}};
    const std::vector<std::uint32_t> indices = {0, 2, 1, 0, 1, 3};
    const Scene mirrored = load(mapped(vertices, indices));
    const auto at_seam = tangents_at(mirrored, {0, 0, 0});
    EXPECT_TRUE(at_seam.empty() || at_seam.count(1) == 0 || at_seam.at(1) == Vec3(0))
        << "each triangle's own derivatives say the same";

    // A third triangle makes the right side uneven, so the vertices on the seam are duplicated.
    vertices.push_back({{1, 1, 0}, up, {1.5f, -1}});
    std::vector<std::uint32_t> uneven = indices;
    uneven.insert(uneven.end(), {1, 2, 4});
    const Scene scene = load(mapped(vertices, uneven));
    EXPECT_EQ(scene.position.size(), 7u);
    const auto tangents = tangents_at(scene, {0, 1, 0});
    ASSERT_EQ(tangents.size(), 2u);
    EXPECT_GT(tangents.at(1).x, 0.9f);
    EXPECT_LT(tangents.at(-1).x, -0.9f);
    EXPECT_EQ(scene.triangle.size(), 3u);
    EXPECT_EQ(triangles_of(scene)[1], (std::array<Vec3, 3>{Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(-1, 0, 0)}));
}

TEST_F(TangentsOfMaps, GoByEdgesNotByCorners) {
    // Two triangles that only touch in a point do not affect each other there.
    const Vec3 up(0, 0, 1);
    const auto at = [&](float x, float y, float degrees) {
        return Vertex{{x, y, 0}, up, turned(x, y, degrees)};
    };
    std::vector<Vertex> vertices = {at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(-1, 0, 40), at(-1, -1, 40)};
    // Another one has an edge in common with the first and rotates its tangent.
    vertices.push_back({{0, 1, 0}, up, {0, -1.5f}});
    const Scene scene = load(mapped(vertices, {0, 1, 2, 0, 3, 4, 0, 2, 5}));
    std::vector<Vec3> at_origin;
    for (const auto& triangle : scene.triangle) at_origin.push_back(scene.tangent[triangle[0]]);
    expect_near(at_origin[0], at_origin[2]);
    EXPECT_GT((at_origin[0] - Vec3(1, 0, 0)).length(), 0.05f);
    expect_near(at_origin[1], direction(40));
}

TEST_F(TangentsOfMaps, OfNeighboursServeWhereTextureCoordinatesHaveNoArea) {
    const Scene scene = load(mapped(fan({0, -1}), {0, 1, 2, 0, 2, 3}));
    for (const std::uint32_t vertex : {scene.triangle[1][0], scene.triangle[1][1]})
        expect_near(scene.tangent[vertex], {1, 0, 0});
    EXPECT_EQ(tangents_at(scene, {-1, 1, 0}).begin()->second, Vec3(0)) << "none reaches this corner";
}

TEST_F(TangentsOfMaps, AreNotMadeForFlatWalls) {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    for (int j = 0; j <= 20; ++j)
        for (int i = 0; i <= 20; ++i) {
            const float x = 0.07f * static_cast<float>(i), y = 0.11f * static_cast<float>(j);
            vertices.push_back({{x, y, 0}, {0, 0, 1}, turned(x * 0.7f, y * 0.7f, 33)});
        }
    for (std::uint32_t j = 0; j < 20; ++j)
        for (std::uint32_t i = 0; i < 20; ++i) {
            const std::uint32_t a = 21 * j + i;
            indices.insert(indices.end(), {a, a + 1, a + 22, a, a + 22, a + 21});
        }
    const Scene scene = load(mapped(vertices, indices));
    EXPECT_EQ(scene.tangent, std::vector<Vec3>(scene.position.size(), Vec3(0)));
    EXPECT_EQ(scene.tangent_sign, std::vector<float>(scene.position.size(), 1.0f));
}

/// Makes a sphere of n by 2 n cells about the origin, with sheared texture coordinates, so that no cell is
/// square in them.
GltfFile sphere(std::uint32_t n, const Json& node = Json::object()) {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t j = 0; j <= n; ++j)
        for (std::uint32_t i = 0; i <= 2 * n; ++i) {
            const float s = static_cast<float>(i) / static_cast<float>(n),
                        t = static_cast<float>(j) / static_cast<float>(n);
            const Vec3 p(std::sin(pi * t) * std::cos(pi * s), std::cos(pi * t),
                         -std::sin(pi * t) * std::sin(pi * s));
            vertices.push_back({p, p, {s + t * t, t}});
        }
    for (std::uint32_t j = 1; j + 1 < n; ++j)  // without its poles
        for (std::uint32_t i = 0; i < 2 * n; ++i) {
            const std::uint32_t a = (2 * n + 1) * j + i, below = a + 2 * n + 1;
            indices.insert(indices.end(), {a, below, below + 1, a, below + 1, a + 1});
        }
    GltfFile file = mapped(vertices, indices);
    file.document["nodes"][0].update(node);
    return file;
}

/// Returns the largest angle, in degrees, between the normals of two triangles at the middle of a common
/// edge. Edges where the texture coordinates are discontinuous are legitimate seams.
float largest_seam(const Scene& scene) {
    std::map<std::array<float, 2>, Vec3> normal_at;
    float largest = 0;
    for (std::uint32_t t = 0; t < scene.triangle.size(); ++t) {
        for (const auto& [u, v] : {std::pair(0.5f, 0.0f), std::pair(0.0f, 0.5f), std::pair(0.5f, 0.5f)}) {
            const common::SurfaceId place{t, u, v};
            const Vec3 normal =
                common::surface_point_at(scene, place, -scene.geometric_normal[t]).shading_normal;
            const Vec2 uv = common::texcoord_at(scene, place, 0) * 1e4f;
            const auto known = normal_at.try_emplace({std::round(uv.x), std::round(uv.y)}, normal).first;
            const float sine = known->second.cross(normal).length();
            largest = std::max(largest, std::asin(std::min(1.0f, sine)) * 180 / pi);
        }
    }
    return largest;
}

TEST_F(TangentsOfMaps, LeaveNoSeamsOnASmoothBody) {
    Scene scene = load(sphere(8));
    EXPECT_LT(largest_seam(scene), 0.1f);
    std::fill(scene.tangent.begin(), scene.tangent.end(), Vec3(0));
    EXPECT_GT(largest_seam(scene), 1) << "from each triangle's own derivatives";
}

TEST_F(TangentsOfMaps, AreDerivativesWhereTheFileSaysSo) {
    GltfFile file = sphere(8);
    file.material()["normalTexture"]["extras"] = {{"tangents", "derivatives"}};
    const Scene scene = load(file);
    EXPECT_EQ(scene.tangent, std::vector<Vec3>(scene.position.size(), Vec3(0)));
    file.material()["normalTexture"]["extras"] = {{"tangents", 1}};
    EXPECT_NE(load(file).tangent, scene.tangent) << "says nothing";
}

TEST_F(TangentsOfMaps, AreNotMadeWithoutAMapOrBesideTheFilesOwn) {
    GltfFile file = sphere(4);
    const auto is_zero = [](const Vec3& t) { return t == Vec3(0); };
    Scene scene = load(file);
    ASSERT_FALSE(std::any_of(scene.tangent.begin(), scene.tangent.end(), is_zero));
    file.material().erase("normalTexture");
    scene = load(file);
    EXPECT_TRUE(std::all_of(scene.tangent.begin(), scene.tangent.end(), is_zero));

    file = sphere(4);
    std::vector<float> own;
    for (std::size_t i = 0; i < 5 * 9; ++i) own.insert(own.end(), {1, 0, 0, -1});
    file.primitive()["attributes"]["TANGENT"] = file.add_accessor<float>(own, f32, "VEC4");
    scene = load(file);
    EXPECT_EQ(scene.tangent, std::vector<Vec3>(scene.position.size(), Vec3(1, 0, 0)));
    file.primitive()["attributes"].erase("NORMAL");
    scene = load(file);
    EXPECT_TRUE(std::all_of(scene.tangent.begin(), scene.tangent.end(), [](const Vec3& t) {
        return t != Vec3(1, 0, 0);
    })) << "which mean nothing without normals";
}

TEST_F(TangentsOfMaps, GoWithMovedTextureCoordinates) {
    GltfFile moved = sphere(6);
    moved.material()["normalTexture"]["extensions"]["KHR_texture_transform"] = {
        {"rotation", pi / 2}, {"scale", {2, 3}}, {"offset", {0.5, 0.25}}};
    const Scene scene = load(moved), plain = load(sphere(6));
    const common::TextureUse& use = scene.material[0].normal_texture;
    for (std::uint32_t t = 0; t < scene.triangle.size(); ++t) {
        // Compares with the derivatives at the middle of the triangle; the mesh is coarse.
        const auto [a, b, c] = scene.triangle[t];
        const auto& uv = scene.texcoord[0];
        const Vec2 to_b = use.transform(uv[b]) - use.transform(uv[a]),
                   to_c = use.transform(uv[c]) - use.transform(uv[a]);
        const float area = to_b.x * to_c.y - to_b.y * to_c.x;
        const Vec3 along_u = ((scene.position[b] - scene.position[a]) * to_c.y -
                              (scene.position[c] - scene.position[a]) * to_b.y) *
                             std::copysign(1.0f, area);
        EXPECT_GT(scene.tangent[a].dot(along_u.normalized()), 0.7f);
        EXPECT_LT(plain.tangent[plain.triangle[t][0]].dot(along_u.normalized()), 0.7f);
        EXPECT_EQ(scene.tangent_sign[a], -std::copysign(1.0f, area));
    }
}

TEST_F(TangentsOfMaps, OfAMirroredNodeAreMirrored) {
    const Scene plain = load(sphere(5)), mirrored = load(sphere(5, {{"scale", {-1, 1, 1}}}));
    ASSERT_EQ(plain.triangle.size(), mirrored.triangle.size());
    for (std::size_t t = 0; t < plain.triangle.size(); ++t) {
        const auto [a, b, c] = plain.triangle[t];
        const auto [d, e, f] = mirrored.triangle[t];
        for (const auto& [v, w] : {std::pair(a, d), std::pair(b, f), std::pair(c, e)}) {
            EXPECT_EQ(plain.tangent[v] * Vec3(-1, 1, 1), mirrored.tangent[w]);
            EXPECT_EQ(plain.tangent_sign[v], -mirrored.tangent_sign[w]);
        }
    }
}

TEST_F(TangentsOfMaps, AreMadeBeforeANodeStretchesThem) {
    const Scene plain = load(sphere(5)), stretched = load(sphere(5, {{"scale", {1, 4, 0.5}}}));
    ASSERT_EQ(plain.tangent.size(), stretched.tangent.size());
    for (std::size_t v = 0; v < plain.tangent.size(); ++v)
        expect_near(stretched.tangent[v], (plain.tangent[v] * Vec3(1, 4, 0.5f)).normalized(), 1e-5f);
}

TEST_F(TangentsOfMaps, SurviveAnyCoordinates) {
    // Coinciding positions, coordinates that overflow, and triangles without area.
    std::vector<Vertex> vertices = fan({3e38f, -3e38f});
    vertices.push_back(vertices[0]);
    GltfFile file = mapped(vertices, {0, 1, 2, 0, 2, 3, 0, 4, 1, 1, 1, 2, 0, 0, 0});
    file.material()["normalTexture"]["extensions"]["KHR_texture_transform"]["scale"] = {1e30, -1e30};
    const Scene scene = load(file);
    for (const Vec3& tangent : scene.tangent) EXPECT_TRUE(common::is_finite(tangent));
    for (std::uint32_t t = 0; t < scene.triangle.size(); ++t) {
        const common::SurfacePoint point = common::surface_point_at(scene, {t, 0.3f, 0.3f}, {0, 0, -1});
        EXPECT_NEAR(point.shading_normal.length(), 1, 1e-5f);
    }
}

TEST_F(TangentsOfMaps, OfManyTrianglesAtOneVertexOrEdgeTakeNoTime) {
    // So many that anything of quadratic cost would take minutes.
    constexpr std::uint32_t count = 50000;
    std::vector<Vertex> vertices = {{{0, 0, 0}, {0, 0, 1}, {0, 0}}, {{0, 1, 0}, {0, 0, 1}, {0, -1}}};
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < count; ++i) {
        const float x = 1 + static_cast<float>(i) / count;
        vertices.push_back({{x, 0, 0}, {0, 0, 1}, {1, x}});
        vertices.push_back({{x, 1, 0}, {0, 0, 1}, {2, -x * x}});
        indices.insert(indices.end(), {0, 2 + 2 * i, 1});              // an edge in common
        indices.insert(indices.end(), {0, 2 + 2 * i, 2 + 2 * i + 1});  // a vertex in common
    }
    EXPECT_EQ(load(mapped(vertices, indices)).triangle.size(), 2u * count);
}

}  // namespace
