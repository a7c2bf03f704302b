// glTF loader: materials, textures, lights and cameras.
#include <cmath>
#include <numbers>

#include "tests/load_gltf.h"

namespace {

using common::SurfaceKind;
using namespace gltf_text;

// ---- Materials ----

TEST_F(LoadGltfMaterials, GivesGltfsDefaultMaterialWhereNoneIsNamed) {
    const Scene scene = load(one_triangle());
    const common::Material& material = scene.material_of(0);
    EXPECT_EQ(material.kind, SurfaceKind::diffuse);
    EXPECT_EQ(material.base_color, Rgb(1, 1, 1));
    EXPECT_FALSE(material.emits());
    EXPECT_FALSE(material.double_sided);
}

TEST_F(LoadGltfMaterials, ReadsADiffuseMaterial) {
    GltfFile file = one_triangle();
    file.material() = {{"name", "wall"},
                       {"doubleSided", true},
                       {"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0.25, 1, 1}}}}};
    const common::Material material = load(file).material_of(0);
    EXPECT_EQ(material.name, "wall");
    EXPECT_EQ(material.kind, SurfaceKind::diffuse);
    EXPECT_EQ(material.base_color, Rgb(0.5f, 0.25f, 1));
    EXPECT_TRUE(material.double_sided);
}

TEST_F(LoadGltfMaterials, ClampsTheBaseColor) {
    GltfFile file = one_triangle();
    file.material()["pbrMetallicRoughness"]["baseColorFactor"] = {2, -1, 0.5, 1};
    const Scene scene = load(file);
    EXPECT_EQ(scene.material[0].base_color, Rgb(1, 0, 0.5f));
    EXPECT_TRUE(has_warning(scene, "clamped"));
}

TEST_F(LoadGltfMaterials, ReadsSmoothMetalAsMirror) {
    GltfFile file = one_triangle();
    Json& pbr = file.material()["pbrMetallicRoughness"];
    pbr = {{"roughnessFactor", 0}};
    EXPECT_EQ(load(file).material[0].kind, SurfaceKind::mirror) << "metallic by default";
    pbr = {{"roughnessFactor", 0.1}};
    EXPECT_EQ(load(file).material[0].kind, SurfaceKind::diffuse);
    pbr = {{"roughnessFactor", 0}, {"metallicFactor", 0.5}};
    EXPECT_EQ(load(file).material[0].kind, SurfaceKind::diffuse);
    file.document["textures"] = {{{"source", 0}}};
    file.document["images"] = {{{"uri", "missing.png"}}};
    pbr = {{"roughnessFactor", 0}, {"metallicRoughnessTexture", {{"index", 0}}}};
    EXPECT_EQ(load(file).material[0].kind, SurfaceKind::diffuse);
}

TEST_F(LoadGltfMaterials, ReadsTransmissionAsDielectric) {
    GltfFile file = one_triangle();
    Json& material = file.material();
    material["pbrMetallicRoughness"] = {{"roughnessFactor", 0}, {"metallicFactor", 0}};
    material["extensions"]["KHR_materials_transmission"] = {{"transmissionFactor", 1}};
    Scene scene = load(file);
    EXPECT_EQ(scene.material[0].kind, SurfaceKind::dielectric);
    EXPECT_EQ(scene.material[0].index_of_refraction, 1.5f);
    EXPECT_TRUE(scene.warnings.empty());

    material["extensions"]["KHR_materials_ior"] = {{"ior", 1.25}};
    EXPECT_EQ(load(file).material[0].index_of_refraction, 1.25f);

    material["extensions"]["KHR_materials_transmission"] = {{"transmissionFactor", 0.75}};
    scene = load(file);
    EXPECT_EQ(scene.material[0].kind, SurfaceKind::dielectric);
    EXPECT_TRUE(has_warning(scene, "transmission"));

    material["extensions"]["KHR_materials_transmission"] = {{"transmissionFactor", 0.25}};
    EXPECT_EQ(load(file).material[0].kind, SurfaceKind::diffuse);
}

TEST_F(LoadGltfMaterials, WarnsAboutRoughGlassAndImpossibleIndices) {
    GltfFile file = one_triangle();
    file.material()["pbrMetallicRoughness"] = {{"roughnessFactor", 0.5}};
    file.material()["extensions"] = {{"KHR_materials_transmission", {{"transmissionFactor", 1}}},
                                     {"KHR_materials_ior", {{"ior", 0}}}};
    const Scene scene = load(file);
    EXPECT_TRUE(has_warning(scene, "rough transmission"));
    EXPECT_TRUE(has_warning(scene, "index of refraction"));
    EXPECT_EQ(scene.material[0].index_of_refraction, 1.5f);
}

TEST_F(LoadGltfMaterials, MultipliesEmissionByItsStrength) {
    GltfFile file = one_triangle();
    file.material()["emissiveFactor"] = {1, 0.5, 0};
    EXPECT_EQ(load(file).material[0].emitted_radiance, Rgb(1, 0.5f, 0));
    file.material()["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", 100}};
    EXPECT_EQ(load(file).material[0].emitted_radiance, Rgb(100, 50, 0));
    file.material()["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", 5e9}};
    EXPECT_EQ(load(file).material[0].emitted_radiance, Rgb(5e9f, 2.5e9f, 0));
}

TEST_F(LoadGltfMaterials, TakesUnlitAsDiffuseThatDoesNotEmit) {
    GltfFile file = one_triangle();
    file.material()["emissiveFactor"] = {1, 1, 1};
    file.material()["extensions"]["KHR_materials_unlit"] = Json::object();
    const Scene scene = load(file);
    EXPECT_EQ(scene.material[0].kind, SurfaceKind::diffuse);
    EXPECT_FALSE(scene.material[0].emits());
    EXPECT_TRUE(has_warning(scene, "unlit"));
}

TEST_F(LoadGltfMaterials, TakesAlphaAsOpaque) {
    GltfFile file = one_triangle();
    file.material()["alphaMode"] = "BLEND";
    EXPECT_TRUE(has_warning(load(file), "opaque"));
}

// ---- Textures ----

TEST_F(LoadGltfTextures, ReadsAllThreeSlots) {
    directory.write("red green.png", red_green_png());
    GltfFile file = textured_triangle();
    file.document["images"][0]["uri"] = "red%20green.png";
    file.material() = {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
                       {"normalTexture", {{"index", 0}, {"scale", 0.5}, {"texCoord", 1}}},
                       {"emissiveTexture", {{"index", 0}, {"texCoord", 1}}},
                       {"emissiveFactor", {1, 1, 1}}};
    const Scene scene = load(file);
    const common::Material& material = scene.material[0];
    EXPECT_EQ(material.base_color_texture.texcoord_set, 0);
    EXPECT_EQ(material.normal_texture.texcoord_set, 1);
    EXPECT_EQ(material.emissive_texture.texcoord_set, 1);
    EXPECT_EQ(material.normal_scale, 0.5f);
    EXPECT_EQ(material.base_color_texture.texture, material.emissive_texture.texture) << "the same colours";
    EXPECT_NE(material.base_color_texture.texture, material.normal_texture.texture) << "colours and data";
    ASSERT_EQ(scene.texture.size(), 2u);
    EXPECT_EQ(scene.texture[0].width(), 2);
    EXPECT_EQ(scene.texture[0].sample({0.25f, 0.5f}), Rgb(1, 0, 0));
    EXPECT_EQ(scene.texture[0].sample({0.75f, 0.5f}), Rgb(0, 1, 0));
    EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(LoadGltfTextures, ReadsImagesInBufferViewsWithTheirSampler) {
    GltfFile file = textured_triangle();
    file.document["images"] = {{{"bufferView", file.add_view(red_green_png())}, {"mimeType", "image/png"}}};
    file.document["samplers"] = {{{"wrapS", 33071}}};
    file.document["textures"][0]["sampler"] = 0;
    file.material()["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    const Scene scene = common::load_gltf(directory.write("scene.glb", file.glb()));
    ASSERT_EQ(scene.texture.size(), 1u);
    EXPECT_EQ(scene.texture[0].sample({9, 0.5f}), Rgb(0, 1, 0)) << "clamped to the edge";
}

TEST_F(LoadGltfTextures, Reduces16BitsTo8) {
    directory.write("red green.png", sixteen_bit_png());
    GltfFile file = textured_triangle();
    file.material()["normalTexture"] = {{"index", 0}};
    EXPECT_EQ(load(file).texture[0].sample({0.5f, 0.5f}), Rgb(1, 128.0f / 255, 0));
}

TEST_F(LoadGltfTextures, RefusesNeededImagesThatCannotBeRead) {
    GltfFile file = textured_triangle();
    file.material()["normalTexture"] = {{"index", 0}};
    expect_error(file, "image 'red green.png' cannot be read");
    directory.write("red green.png", std::string("not a picture"));
    expect_error(file, "image 'red green.png' cannot be decoded");
    file.document["textures"][0]["source"] = 1;
    expect_error(file, "textures/0");
    file.document["textures"][0].erase("source");
    expect_error(file, "textures/0");
}

TEST_F(LoadGltfTextures, IgnoresBrokenImagesThatNothingReads) {
    GltfFile file = textured_triangle();
    file.document["images"] = {
        {{"uri", "data:image/png;base64,!"}}, Json::object(), {{"uri", "missing.png"}}};
    file.document["textures"] = {{{"source", 2}}, {{"source", 99}}};
    file.material()["occlusionTexture"] = {{"index", 0}};
    file.material()["emissiveTexture"] = {{"index", 0}};  // with emissiveFactor 0
    EXPECT_TRUE(load(file).texture.empty());
}

TEST_F(LoadGltfTextures, WarnsAboutWhatItCannotHonour) {
    directory.write("red green.png", red_green_png());
    GltfFile file = textured_triangle();
    file.primitive()["attributes"].erase("TEXCOORD_0");
    file.material()["normalTexture"] = {{"index", 0}, {"texCoord", 2}};
    file.material()["pbrMetallicRoughness"]["baseColorTexture"] = {
        {"index", 0}, {"extensions", {{"KHR_texture_transform", {{"offset", {0.5, 0}}}}}}};
    const Scene scene = load(file);
    EXPECT_EQ(scene.material[0].normal_texture.texture, common::no_texture);
    EXPECT_TRUE(has_warning(scene, "TEXCOORD_2"));
    EXPECT_TRUE(has_warning(scene, "KHR_texture_transform"));
    EXPECT_TRUE(has_warning(scene, "TEXCOORD_0, which is missing"));
}

TEST_F(LoadGltfTextures, DoesNotWarnAboutATransformThatDoesNothing) {
    directory.write("red green.png", red_green_png());
    GltfFile file = textured_triangle();
    const Json identity = {{"offset", {0, 0}}, {"scale", {1, 1}}, {"rotation", 0}};
    file.material()["normalTexture"] = {{"index", 0}, {"extensions", {{"KHR_texture_transform", identity}}}};
    EXPECT_TRUE(load(file).warnings.empty());
}

// ---- Lights ----

GltfFile lit_triangle(const Json& light, const Json& transform) {
    GltfFile file = one_triangle();
    file.document["extensionsUsed"] = {"KHR_lights_punctual"};
    file.document["extensions"]["KHR_lights_punctual"]["lights"] = {light};
    Json node = transform;
    node["extensions"]["KHR_lights_punctual"] = {{"light", 0}};
    file.document["nodes"].push_back(node);
    file.document["scenes"][0]["nodes"] = {0, 1};
    return file;
}

TEST_F(LoadGltfLights, ReadsPointLights) {
    const Json light = {{"type", "point"}, {"color", {1, 0.5, 0}}, {"intensity", 10}};
    const Scene scene = load(lit_triangle(light, {{"translation", {1, 2, 3}}, {"scale", {5, 5, 5}}}));
    ASSERT_EQ(scene.point_light.size(), 1u);
    EXPECT_EQ(scene.point_light[0].position, Vec3(1, 2, 3));
    EXPECT_EQ(scene.point_light[0].intensity, Rgb(10, 5, 0));
    EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(LoadGltfLights, ReadsSpotLights) {
    const double half = std::numbers::sqrt2 / 2;
    // A quarter turn about x makes -z into +y.
    const Json pose = {{"rotation", {half, 0, 0, half}}, {"translation", {1, 2, 3}}};
    const Json cones = {{"innerConeAngle", 0.25}, {"outerConeAngle", 0.5}};
    Scene scene = load(lit_triangle({{"type", "spot"}, {"spot", cones}, {"intensity", 2}}, pose));
    ASSERT_EQ(scene.spot_light.size(), 1u);
    expect_near(scene.spot_light[0].axis, {0, 1, 0});
    EXPECT_EQ(scene.spot_light[0].position, Vec3(1, 2, 3));
    EXPECT_EQ(scene.spot_light[0].intensity, Rgb(2, 2, 2)) << "white by default";
    EXPECT_EQ(scene.spot_light[0].cos_inner_angle, static_cast<float>(std::cos(0.25)));
    EXPECT_EQ(scene.spot_light[0].cos_outer_angle, static_cast<float>(std::cos(0.5)));

    scene = load(lit_triangle({{"type", "spot"}, {"spot", Json::object()}}, pose));
    EXPECT_EQ(scene.spot_light[0].intensity, Rgb(1, 1, 1));
    EXPECT_EQ(scene.spot_light[0].cos_inner_angle, 1);
    EXPECT_EQ(scene.spot_light[0].cos_outer_angle, static_cast<float>(half));

    scene = load(
        lit_triangle({{"type", "spot"}, {"spot", {{"innerConeAngle", 2}, {"outerConeAngle", 1}}}}, pose));
    EXPECT_EQ(scene.spot_light[0].cos_inner_angle, scene.spot_light[0].cos_outer_angle);
    EXPECT_TRUE(has_warning(scene, "cone angles"));
}

TEST_F(LoadGltfLights, KeepsTheDigitsOfNarrowSpots) {
    for (const double angle : {1e-5, 3e-4, 0.05}) {
        const Json cones = {{"innerConeAngle", angle / 2}, {"outerConeAngle", angle}};
        const Scene scene = load(lit_triangle({{"type", "spot"}, {"spot", cones}, {"name", "pointer"}}, {}));
        const double inner = 1 - scene.spot_light[0].cos_inner_angle,
                     outer = 1 - scene.spot_light[0].cos_outer_angle;
        EXPECT_NEAR(outer, angle * angle / 2, 1e-3 * outer);
        EXPECT_NEAR(inner, outer / 4, 1e-3 * outer);
        EXPECT_EQ(scene.spot_light[0].name, "light 'pointer'");
    }
}

TEST_F(LoadGltfLights, ReadsDirectionalLights) {
    const Scene scene =
        load(lit_triangle({{"type", "directional"}, {"intensity", 3}}, {{"scale", {1, 1, 7}}}));
    ASSERT_EQ(scene.directional_light.size(), 1u);
    EXPECT_EQ(scene.directional_light[0].direction, Vec3(0, 0, -1));
    EXPECT_EQ(scene.directional_light[0].irradiance, Rgb(3, 3, 3));
}

TEST_F(LoadGltfLights, RefusesWhatIsNoLight) {
    const Json pose = Json::object();
    expect_error(lit_triangle({{"type", "laser"}}, pose), "laser");
    expect_error(lit_triangle({{"type", "point"}, {"intensity", -1}}, pose), "negative");
    expect_error(lit_triangle({{"type", "point"}, {"color", {1, 1}}}, pose), "color");
    expect_error(lit_triangle({{"type", "point"}, {"intensity", 1e38}, {"color", {10, 1, 1}}}, pose),
                 "not finite");
    expect_error(lit_triangle({{"type", "directional"}}, {{"scale", {1, 1, 0}}}), "direction");
    GltfFile dangling = lit_triangle({{"type", "point"}}, pose);
    dangling.node(1)["extensions"]["KHR_lights_punctual"]["light"] = 1;
    expect_error(dangling, "light is 1");
}

// ---- Cameras ----

TEST_F(LoadGltfCameras, ReadsPerspectiveCamerasWithoutScale) {
    GltfFile file = one_triangle();
    const double half = std::numbers::sqrt2 / 2;
    file.document["cameras"] = {
        {{"type", "perspective"}, {"name", "eye"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}}}}};
    file.document["nodes"].push_back(
        {{"camera", 0}, {"rotation", {0, half, 0, half}}, {"scale", {2, 3, 4}}, {"translation", {1, 2, 3}}});
    file.document["scenes"][0]["nodes"] = {0, 1};
    const Scene scene = load(file);
    ASSERT_EQ(scene.camera.size(), 1u);
    EXPECT_EQ(scene.camera[0].name, "eye");
    EXPECT_EQ(scene.camera[0].eye, Vec3(1, 2, 3));
    // A quarter turn about y makes -z into -x.
    expect_near(scene.camera[0].forward, {-1, 0, 0});
    expect_near(scene.camera[0].up, {0, 1, 0});
    EXPECT_FLOAT_EQ(scene.camera[0].vertical_fov, 0.5f);
}

TEST_F(LoadGltfCameras, LeavesOutOrthographicCameras) {
    GltfFile file = one_triangle();
    file.document["cameras"] = {
        {{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 0}, {"zfar", 1}}}}};
    file.node()["camera"] = 0;
    const Scene scene = load(file);
    EXPECT_TRUE(scene.camera.empty());
    EXPECT_TRUE(has_warning(scene, "orthographic"));
}

TEST_F(LoadGltfCameras, RefusesImpossibleFieldsOfView) {
    GltfFile file = one_triangle();
    file.node()["camera"] = 0;
    for (const double yfov : {0.0, -1.0, 3.2}) {
        file.document["cameras"] = {
            {{"type", "perspective"}, {"perspective", {{"yfov", yfov}, {"znear", 1}}}}};
        expect_error(file, "field of view");
    }
}

}  // namespace
