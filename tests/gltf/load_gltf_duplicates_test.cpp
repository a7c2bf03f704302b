// glTF loader: triangles that a file has more than once at the same position.
#include "common/gltf/duplicates.h"
#include "common/tracer/photon_source.h"
#include "tests/support/load_gltf.h"
#include "tests/support/scene_builder.h"

namespace {

using namespace gltf_text;
using tests::diffuse;

using LoadGltfDuplicates = LoadGltf;

/// Makes the triangle of one_triangle() again in a second node, named "again".
GltfFile two_nodes() {
    GltfFile file = one_triangle();
    file.node()["name"] = "once";
    file.document["nodes"].push_back({{"mesh", 0}, {"name", "again"}});
    file.document["scenes"] = {{{"nodes", {0, 1}}}};
    return file;
}

/// Makes one mesh of these triangles.
GltfFile mesh_of(const std::vector<float>& positions) {
    GltfFile file = one_triangle();
    file.primitive()["attributes"]["POSITION"] = file.add_accessor(positions, f32, "VEC3");
    return file;
}

TEST_F(LoadGltfDuplicates, AreLeftOutWithTheirNode) {
    const Scene scene = load(two_nodes());
    ASSERT_EQ(triangles_of(scene),
              (std::vector<std::array<Vec3, 3>>{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}}));
    EXPECT_EQ(scene.geometric_normal.size(), 1u);
    EXPECT_EQ(scene.instance_of, (std::vector<std::uint32_t>{0}));
    ASSERT_EQ(scene.instance.size(), 1u);
    EXPECT_EQ(scene.instance[0].name, "once");
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_TRUE(has_warning(scene, "1 triangles (0.5 m^2)")) << scene.warnings[0];
    EXPECT_TRUE(has_warning(scene, "again")) << scene.warnings[0];
}

TEST_F(LoadGltfDuplicates, AreLeftOutOfOneMeshWhicheverCornerIsFirst) {
    const Scene scene = load(mesh_of({0, 0, 0, 1, 0, 0, 0, 1, 0,  //
                                      0, 0, 5, 1, 0, 5, 0, 1, 5,  //
                                      1, 0, 0, 0, 1, 0, 0, 0, 0,  //
                                      0, 1, 0, 0, 0, 0, 1, 0, 0,  //
                                      0, 0, 6, 1, 0, 6, 0, 1, 6}));
    ASSERT_EQ(scene.triangle.size(), 3u);
    EXPECT_EQ(triangles_of(scene)[1][0], Vec3(0, 0, 5));
    EXPECT_EQ(triangles_of(scene)[2][0], Vec3(0, 0, 6));
    ASSERT_EQ(scene.instance.size(), 1u);
    EXPECT_EQ(scene.instance[0].triangle_count, 3u);
    EXPECT_TRUE(has_warning(scene, "2 triangles (1 m^2)"));
}

TEST_F(LoadGltfDuplicates, MinusZeroIsZero) {
    EXPECT_EQ(load(mesh_of({0, 0, 0, 1, 0, 0, 0, 1, 0,  //
                            -0.0f, 0, -0.0f, 1, -0.0f, 0, 0, 1, -0.0f}))
                  .triangle.size(),
              1u);
}

TEST_F(LoadGltfDuplicates, ReversedMovedAndOtherTrianglesAreNone) {
    const Scene scene = load(mesh_of({0, 0, 0,     1, 0, 0, 0, 1, 0,  //
                                      0, 0, 0,     0, 1, 0, 1, 0, 0,  //
                                      0, 0, 1e-7f, 1, 0, 0, 0, 1, 0,  //
                                      0, 0, 0,     1, 0, 0, 1, 1, 0}));
    EXPECT_EQ(scene.triangle.size(), 4u);
    EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(LoadGltfDuplicates, OfThreeNodesTheWarningNamesOneAndCountsTheOther) {
    GltfFile file = two_nodes();
    file.document["nodes"].push_back({{"mesh", 0}, {"name", "third"}});
    file.document["scenes"] = {{{"nodes", {0, 1, 2}}}};
    const Scene scene = load(file);
    EXPECT_EQ(scene.triangle.size(), 1u);
    EXPECT_TRUE(has_warning(scene, "2 triangles (1 m^2)"));
    EXPECT_TRUE(has_warning(scene, "again and 1 more"));
}

TEST_F(LoadGltfDuplicates, OfACopiedLampOneShines) {
    GltfFile once = one_triangle();
    once.material() = {{"emissiveFactor", {1, 1, 1}}};
    GltfFile twice = two_nodes();
    twice.material() = {{"emissiveFactor", {1, 1, 1}}};
    const Scene lamp = load(once), lamps = load(twice);
    EXPECT_EQ(common::PhotonSource(lamps).power(), common::PhotonSource(lamp).power());
}

// ---- Which one is kept ----

/// Returns what is kept of triangles with these materials at one position.
Scene kept_of(const std::vector<common::Material>& materials) {
    Scene scene;
    tests::Mesh mesh{"triangle", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}, {}, {}, 1, {{0, 1, 2}}};
    for (std::size_t i = 0; i < materials.size(); ++i) {
        mesh.name = std::to_string(i);
        tests::add(scene, mesh, materials[i]);
        scene.instance.back().name = mesh.name;
    }
    common::gltf::Warnings warnings;
    common::gltf::leave_out_duplicates(scene, warnings);
    scene.warnings = warnings.lines();
    return scene;
}

std::vector<std::string> names_kept(const std::vector<common::Material>& materials) {
    std::vector<std::string> names;
    for (const common::MeshInstance& instance : kept_of(materials).instance) names.push_back(instance.name);
    return names;
}

using Names = std::vector<std::string>;

common::Material with_alpha(common::AlphaMode mode) {
    common::Material material = diffuse(Rgb(1, 1, 1));
    material.alpha_mode = mode;
    return material;
}

const common::Material light = diffuse(Rgb(0.9f, 0.9f, 0.9f)), dark = diffuse(Rgb(0.1f, 0.1f, 0.1f)),
                       lamp = diffuse(Rgb(0, 0, 0), Rgb(1, 1, 1)), glass = tests::glass(),
                       mask = with_alpha(common::AlphaMode::mask),
                       blend = with_alpha(common::AlphaMode::blend);

TEST(DuplicateKept, IsTheFirstOfTheSameKind) {
    EXPECT_EQ(names_kept({light, dark}), Names{"0"});
    EXPECT_EQ(kept_of({light, dark}).material_of(0).base_color, light.base_color);
    EXPECT_EQ(kept_of({dark, light}).material_of(0).base_color, dark.base_color);
    EXPECT_EQ(names_kept({dark, tests::mirror(), light}), Names{"0"});
}

TEST(DuplicateKept, LetsNoLightThroughIfOneDoes) {
    EXPECT_EQ(names_kept({mask, light}), Names{"1"});
    EXPECT_EQ(names_kept({blend, mask, glass, dark, light}), Names{"3"});
    EXPECT_EQ(names_kept({light, blend}), Names{"0"});
    EXPECT_EQ(names_kept({glass, tests::mirror()}), Names{"1"});
}

TEST(DuplicateKept, AreAllThatHaveHoles) {
    EXPECT_EQ(names_kept({mask, mask}), (Names{"0", "1"}));
    EXPECT_EQ(names_kept({mask, blend, mask}), (Names{"0", "1", "2"}));
    EXPECT_EQ(names_kept({mask, glass, blend, glass}), (Names{"0", "1", "2"}));
}

TEST(DuplicateKept, EmitsAndHasTwoSidesIfOneDoes) {
    EXPECT_EQ(names_kept({light, lamp}), Names{"1"});
    EXPECT_EQ(names_kept({lamp, light}), Names{"0"});
    EXPECT_EQ(names_kept({lamp, tests::double_sided(light)}), Names{"0"});
    EXPECT_EQ(names_kept({light, tests::double_sided(dark)}), Names{"1"});
}

TEST(DuplicateKept, IsSaidToHaveAnotherMaterial) {
    const auto says_so = [](const std::vector<common::Material>& materials) {
        return has_warning(kept_of(materials), "1 of the triangles left out have another material");
    };
    EXPECT_TRUE(says_so({light, dark}));
    Scene scene;
    const tests::Mesh quad = tests::quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    tests::add(scene, quad, light);
    tests::add(scene, quad, light);
    scene.instance[1].material = scene.instance[0].material;
    common::gltf::Warnings warnings;
    common::gltf::leave_out_duplicates(scene, warnings);
    ASSERT_EQ(warnings.lines().size(), 1u);
    EXPECT_NE(warnings.lines()[0].find("2 triangles (1 m^2)"), std::string::npos);
}

TEST(DuplicateKept, LeavesOtherTrianglesOfItsInstanceWhereTheyAre) {
    Scene scene;
    const tests::Mesh a = tests::quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}),
                      b = tests::quad({0, 0, 1}, {1, 0, 0}, {0, 1, 0});
    tests::add(scene, a, light);
    tests::add(scene, tests::joined(a, b), dark);
    tests::add(scene, b, lamp);
    common::gltf::Warnings warnings;
    common::gltf::leave_out_duplicates(scene, warnings);
    ASSERT_EQ(scene.instance.size(), 2u) << "the second has nothing left";
    for (std::uint32_t i = 0; i < 2; ++i) {
        EXPECT_EQ(scene.instance[i].first_triangle, 2 * i);
        EXPECT_EQ(scene.instance[i].triangle_count, 2u);
        EXPECT_EQ(scene.instance_of[2 * i], i);
        EXPECT_EQ(scene.instance_of[2 * i + 1], i);
    }
    EXPECT_TRUE(scene.material_of(2).emits());
    EXPECT_EQ(scene.triangle.size(), 4u);
}

}  // namespace
