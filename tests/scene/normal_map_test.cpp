#include <gtest/gtest.h>

#include <random>

#include "tests/support/scene_builder.h"

namespace {

using namespace tests;

constexpr float half_texel = 128.0f / 255 * 2 - 1;  // the value of 8 bits that is nearest to 0

/// Makes a quad in the plane z = 0 that faces +z, with these texture coordinates and a normal map of one
/// texel.
Scene mapped(const std::array<std::uint8_t, 3>& texel, const std::vector<Vec2>& uv, float scale = 1) {
    Mesh mesh = quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    mesh.texcoord[0] = uv;
    Material material = diffuse(Rgb(1, 1, 1));
    material.normal_texture = {0, 0};
    material.normal_scale = scale;
    Scene scene;
    add(scene, mesh, material);
    scene.texture.emplace_back("normal", 1, 1, std::vector<std::uint8_t>(texel.begin(), texel.end()),
                               common::ColorSpace::linear, common::Wrap::repeat, common::Wrap::repeat);
    return scene;
}

void add_tangents(Scene& scene, const Vec3& tangent, float sign) {
    std::fill(scene.tangent.begin(), scene.tangent.end(), tangent);
    std::fill(scene.tangent_sign.begin(), scene.tangent_sign.end(), sign);
}

/// The orientation of an image on a wall: u to the right, v down.
const std::vector<Vec2> upright = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
/// Its mirror image: u to the left, v down.
const std::vector<Vec2> mirrored = {{1, 1}, {0, 1}, {0, 0}, {1, 0}};
/// Rotated by a quarter turn: u up, v to the right.
const std::vector<Vec2> turned = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};

Vec3 shading_normal(const Scene& scene, const Vec3& direction = {0, 0, -1}) {
    return common::surface_point_at(scene, {0, 0.3f, 0.3f}, direction).shading_normal;
}

void expect_near(const Vec3& actual, Vec3 expected, float tolerance = 1e-5f) {
    expected.normalize();
    EXPECT_LT((actual - expected).length(), tolerance) << actual << " instead of " << expected;
}

TEST(NormalMap, FlatTexelLeavesTheNormal) {
    expect_near(shading_normal(mapped({128, 128, 255}, upright)), {half_texel, half_texel, 1});
}

TEST(NormalMap, RedPointsAlongUAndGreenUp) {
    expect_near(shading_normal(mapped({230, 128, 200}, upright)),
                {230.0f / 255 * 2 - 1, half_texel, 200.0f / 255 * 2 - 1});
    expect_near(shading_normal(mapped({128, 230, 200}, upright)),
                {half_texel, 230.0f / 255 * 2 - 1, 200.0f / 255 * 2 - 1});
}

TEST(NormalMap, FollowsTheTextureCoordinates) {
    const float red = 200.0f / 255 * 2 - 1, green = 230.0f / 255 * 2 - 1, blue = 200.0f / 255 * 2 - 1;
    const std::array<std::uint8_t, 3> texel = {200, 230, 200};
    expect_near(shading_normal(mapped(texel, upright)), {red, green, blue});
    expect_near(shading_normal(mapped(texel, mirrored)), {-red, green, blue});
    expect_near(shading_normal(mapped(texel, turned)), {-green, red, blue});  // up in the image is -x
    std::vector<Vec2> repeated = upright;
    for (Vec2& uv : repeated) uv = uv * 5.0f - Vec2(3, 1);
    expect_near(shading_normal(mapped(texel, repeated)), {red, green, blue});
}

TEST(NormalMap, AgreesWithTheFilesTangents) {
    const std::array<std::uint8_t, 3> texel = {200, 230, 200};
    struct Case {
        std::vector<Vec2> uv;
        Vec3 tangent;
        float sign;
    };
    for (const Case& c :
         {Case{upright, {1, 0, 0}, 1}, Case{mirrored, {-1, 0, 0}, -1}, Case{turned, {0, 1, 0}, 1}}) {
        const Scene derived = mapped(texel, c.uv);
        Scene given = derived;
        add_tangents(given, c.tangent, c.sign);
        expect_near(shading_normal(given), shading_normal(derived));
    }
}

TEST(NormalMap, FollowsAnyChart) {
    // Compares with the derivatives of position by texture coordinate, for randomly rotated, sheared and
    // mirrored charts.
    constexpr unsigned seed = 1;
    std::mt19937 engine(seed);
    std::uniform_real_distribution<float> uniform(-1, 1);
    for (int i = 0; i < 1000; ++i) {
        const Vec2 u_of_xy(uniform(engine), uniform(engine)), v_of_xy(uniform(engine), uniform(engine));
        const float determinant = u_of_xy.x * v_of_xy.y - u_of_xy.y * v_of_xy.x;
        if (std::abs(determinant) < 0.01f) continue;
        std::vector<Vec2> uv;
        for (const Vec2& p : {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)})
            uv.emplace_back(u_of_xy.dot(p), v_of_xy.dot(p));
        const Vec3 along_u = Vec3(v_of_xy.y, -v_of_xy.x, 0) / determinant;
        const Vec3 along_v = Vec3(-u_of_xy.y, u_of_xy.x, 0) / determinant;
        const Vec3 red = shading_normal(mapped({230, 128, 200}, uv)),
                   green = shading_normal(mapped({128, 230, 200}, uv));
        // The texel's other channel is not exactly 0, but 0.004.
        EXPECT_GT(Vec3(red.x, red.y, 0).normalized().dot(along_u.normalized()), 0.9999f) << "seed " << seed;
        EXPECT_LT(green.dot(along_v), 0) << "green points to decreasing v, seed " << seed;
    }
}

TEST(NormalMap, FollowsMovedTextureCoordinates) {
    const std::array<std::uint8_t, 3> texel = {200, 230, 200};
    const common::TexcoordTransform none, quarter{{0, 1}, {0, -1}, {1, 0}}, flipped{{1, 0}, {-1, 0}, {0, 1}},
        stretched{{3, 4}, {5, 0}, {0, 0.5f}}, all{{0.5f, 2}, {0.6f, 1.6f}, {2.4f, -0.9f}};
    for (const common::TexcoordTransform& transform : {none, quarter, flipped, stretched, all}) {
        Scene scene = mapped(texel, turned);
        scene.material[0].normal_texture.transform = transform;
        std::vector<Vec2> moved = turned;
        for (Vec2& uv : moved) uv = transform(uv);
        expect_near(shading_normal(scene), shading_normal(mapped(texel, moved)));
    }
    Scene scene = mapped(texel, upright);
    scene.material[0].normal_texture.transform = quarter;
    const float red = 200.0f / 255 * 2 - 1, green = 230.0f / 255 * 2 - 1;
    expect_near(shading_normal(scene), {green, -red, red});  // the image rotated clockwise: up in it is +x
    add_tangents(scene, {1, 0, 0}, 1);
    expect_near(shading_normal(scene), {red, green, red});  // the file's tangents replace that
}

TEST(NormalMap, ScalesTheTilt) {
    const float red = 230.0f / 255 * 2 - 1, blue = 200.0f / 255 * 2 - 1;
    expect_near(shading_normal(mapped({230, 128, 200}, upright, 0.5f)),
                {0.5f * red, 0.5f * half_texel, blue});
    expect_near(shading_normal(mapped({230, 128, 200}, upright, 0)), {0, 0, 1});
}

TEST(NormalMap, BackIsTheFrontTurnedRound) {
    const Scene scene = mapped({200, 230, 200}, upright);
    const auto front = common::surface_point_at(scene, {0, 0.3f, 0.3f}, {0, 0, -1});
    const auto back = common::surface_point_at(scene, {0, 0.3f, 0.3f}, {0, 0, 1});
    EXPECT_TRUE(front.front);
    EXPECT_FALSE(back.front);
    EXPECT_EQ(back.geometric_normal, Vec3(0, 0, -1));
    EXPECT_EQ(back.shading_normal, -front.shading_normal);
    EXPECT_EQ(back.position, front.position);
}

TEST(NormalMap, NeverPointsIntoTheSurface) {
    expect_near(shading_normal(mapped({255, 128, 0}, upright)), {0, 0, 1});
}

TEST(NormalMap, StandsOnTheSmoothNormal) {
    Scene scene = mapped({230, 128, 200}, upright);
    const Vec3 smooth = Vec3(0.3f, 0, 1).normalized();
    std::fill(scene.normal.begin(), scene.normal.end(), smooth);
    const float red = 230.0f / 255 * 2 - 1, blue = 200.0f / 255 * 2 - 1;
    const Vec3 tangent = Vec3(1, 0, -0.3f).normalized();  // u, made perpendicular to the normal
    expect_near(shading_normal(scene), tangent * red + Vec3(0, 1, 0) * half_texel + smooth * blue);
}

TEST(NormalMap, WithoutUsableTextureCoordinatesKeepsTheNormal) {
    expect_near(shading_normal(mapped({230, 128, 200}, {{0, 0}, {0, 0}, {0, 0}, {0, 0}})), {0, 0, 1});
}

TEST(SurfacePoint, SmoothNormalInterpolatesAndStaysInFront) {
    Scene scene;
    add(scene, quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), diffuse(Rgb(1, 1, 1)));
    const auto [a, b, c] = scene.triangle[0];
    scene.normal[a] = Vec3(1, 0, 1).normalized();
    scene.normal[b] = Vec3(-1, 0, 1).normalized();
    scene.normal[c] = Vec3(0, 1, 1).normalized();
    expect_near(common::smooth_normal_at(scene, {0, 0.5f, 0}), {0, 0, 1});
    expect_near(common::smooth_normal_at(scene, {0, 0, 1}), {0, 1, 1});
    for (Vec3& n : scene.normal) n = {0, 0, -1};
    expect_near(common::smooth_normal_at(scene, {0, 0.2f, 0.2f}), {0, 0, 1});
    expect_near(shading_normal(scene, Vec3(0, 1, 1).normalized()), {0, 0, -1});
}

}  // namespace
