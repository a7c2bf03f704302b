// glTF loader: materials, textures, lights and cameras.
#include <cmath>
#include <numbers>

#include "tests/support/load_gltf.h"

namespace {

using common::SurfaceKind;
using namespace gltf_text;

// ---- Materials ----

TEST_F(LoadGltfMaterials, GivesGltfsDefaultMaterialWhereNoneIsNamed) {
    GltfFile file = one_triangle();
    file.primitive().erase("material");
    file.document.erase("materials");
    const Scene scene = load(file);
    const common::Material& material = scene.material_of(0);
    EXPECT_EQ(material.kind, SurfaceKind::diffuse);
    EXPECT_EQ(material.base_color, Rgb(1, 1, 1));
    EXPECT_FALSE(material.emits());
    EXPECT_FALSE(material.double_sided);
    EXPECT_TRUE(has_warning(scene, "metal")) << "metallic 1, roughness 1";
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

TEST_F(LoadGltfMaterials, WarnsAboutMetalsThatAreNoMirrors) {
    GltfFile file = one_triangle();
    for (const Json& pbr :
         {Json({{"roughnessFactor", 0.3}}), Json({{"roughnessFactor", 0}, {"metallicFactor", 0.5}}),
          Json({{"roughnessFactor", 0}, {"metallicRoughnessTexture", {{"index", 0}}}}), Json(nullptr)}) {
        file.material() = Json::object();
        if (!pbr.is_null()) file.material()["pbrMetallicRoughness"] = pbr;
        file.document["textures"] = {{{"source", 0}}};
        file.document["images"] = {{{"uri", "missing.png"}}};
        const Scene scene = load(file);
        EXPECT_EQ(scene.material[0].kind, SurfaceKind::diffuse) << pbr;
        ASSERT_EQ(scene.warnings.size(), 1u) << pbr;
        EXPECT_TRUE(has_warning(scene, "metal")) << scene.warnings[0];
    }
    file.material()["pbrMetallicRoughness"] = {{"metallicFactor", 0},
                                               {"metallicRoughnessTexture", {{"index", 0}}}};
    EXPECT_TRUE(load(file).warnings.empty()) << "no metal, whatever the texture says";
    file.material()["pbrMetallicRoughness"] = {{"metallicFactor", 1}, {"roughnessFactor", 0}};
    EXPECT_TRUE(load(file).warnings.empty()) << "a mirror";
}

TEST_F(LoadGltfMaterials, ReadsTransmissionAsGlass) {
    GltfFile file = one_triangle();
    Json& material = file.material();
    material["pbrMetallicRoughness"] = {{"roughnessFactor", 0}, {"metallicFactor", 0}};
    material["extensions"]["KHR_materials_transmission"] = {{"transmissionFactor", 1}};
    Scene scene = load(file);
    EXPECT_EQ(scene.material[0].kind, SurfaceKind::thin_sheet);
    EXPECT_EQ(scene.material[0].index_of_refraction, 1.5f);
    EXPECT_TRUE(scene.warnings.empty());
    material["extensions"]["KHR_materials_volume"] = {{"thicknessFactor", 0}};
    EXPECT_EQ(load(file).material[0].kind, SurfaceKind::thin_sheet);
    material["extensions"]["KHR_materials_volume"] = {{"thicknessFactor", 0.01}};
    EXPECT_EQ(load(file).material[0].kind, SurfaceKind::dielectric);

    material["extensions"]["KHR_materials_ior"] = {{"ior", 1.25}};
    EXPECT_EQ(load(file).material[0].index_of_refraction, 1.25f);

    material["extensions"]["KHR_materials_transmission"] = {{"transmissionFactor", 0.75}};
    scene = load(file);
    EXPECT_EQ(scene.material[0].kind, SurfaceKind::dielectric);
    EXPECT_TRUE(has_warning(scene, "KHR_materials_transmission"));

    material["extensions"]["KHR_materials_transmission"] = {{"transmissionFactor", 0.25}};
    scene = load(file);
    EXPECT_EQ(scene.material[0].kind, SurfaceKind::diffuse);
    EXPECT_TRUE(has_warning(scene, "KHR_materials_transmission"));

    material["extensions"].erase("KHR_materials_ior");
    material["extensions"]["KHR_materials_transmission"] = {{"transmissionFactor", 0}};
    scene = load(file);
    EXPECT_EQ(scene.material[0].kind, SurfaceKind::diffuse);
    EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(LoadGltfMaterials, MetalLetsNothingThrough) {
    GltfFile file = one_triangle();
    file.material() = {{"extensions", {{"KHR_materials_transmission", {{"transmissionFactor", 1}}}}}};
    Scene scene = load(file);
    EXPECT_EQ(scene.material[0].kind, SurfaceKind::diffuse);
    EXPECT_TRUE(has_warning(scene, "metal"));
    file.document["textures"] = {{{"source", 0}}};
    file.document["images"] = {{{"uri", "missing.png"}}};
    file.material()["pbrMetallicRoughness"]["metallicRoughnessTexture"] = {{"index", 0}};
    scene = load(file);
    EXPECT_EQ(scene.material[0].kind, SurfaceKind::thin_sheet) << "the texture may say that it is none";
    EXPECT_TRUE(has_warning(scene, "metal"));
}

TEST_F(LoadGltfMaterials, SaysWhatItReadsOfAVolume) {
    GltfFile file = one_triangle();
    file.document["textures"] = {{{"source", 0}}};
    file.document["images"] = {{{"uri", "missing.png"}}};
    file.material()["pbrMetallicRoughness"]["roughnessFactor"] = 0;
    Json& extensions = file.material()["extensions"];
    extensions["KHR_materials_transmission"] = {{"transmissionFactor", 1}};
    extensions["KHR_materials_volume"] = {{"thicknessFactor", 1}, {"attenuationDistance", 2}};
    EXPECT_TRUE(load(file).warnings.empty()) << "white glass absorbs nothing";
    extensions["KHR_materials_volume"]["attenuationColor"] = {1, 0.5, 1};
    EXPECT_TRUE(has_warning(load(file), "KHR_materials_volume: absorption"));
    extensions["KHR_materials_volume"] = {{"thicknessFactor", 1}, {"attenuationColor", {1, 0.5, 1}}};
    EXPECT_TRUE(load(file).warnings.empty()) << "not within any distance";
    extensions["KHR_materials_volume"]["thicknessTexture"] = {{"index", 0}};
    EXPECT_TRUE(has_warning(load(file), "KHR_materials_volume: thicknessTexture"));
    extensions["KHR_materials_transmission"]["transmissionTexture"] = {{"index", 0}};
    EXPECT_TRUE(has_warning(load(file), "KHR_materials_transmission"));
}

TEST_F(LoadGltfMaterials, WarnsAboutWhatIsNotDrawn) {
    struct Case {
        const char* extension;
        Json neutral, given;
    };
    const Json texture = {{"index", 0}};
    const std::vector<Case> cases = {
        {"KHR_materials_anisotropy", {{"anisotropyStrength", 0}}, {{"anisotropyStrength", 0.5}}},
        {"KHR_materials_clearcoat", {{"clearcoatFactor", 0}}, {{"clearcoatFactor", 1}}},
        {"KHR_materials_diffuse_transmission", Json::object(), {{"diffuseTransmissionFactor", 0.5}}},
        {"KHR_materials_dispersion", {{"dispersion", 0}}, {{"dispersion", 0.1}}},
        {"KHR_materials_ior", {{"ior", 1.5}}, {{"ior", 1.45}}},
        {"KHR_materials_iridescence", {{"iridescenceFactor", 0.0}}, {{"iridescenceFactor", 1}}},
        {"KHR_materials_sheen", {{"sheenColorFactor", {0, 0, 0}}}, {{"sheenColorFactor", {0, 0.5, 0}}}},
        {"KHR_materials_specular", {{"specularFactor", 1}}, {{"specularFactor", 0}}},
        {"KHR_materials_specular", {{"specularColorFactor", {1, 1, 1}}}, {{"specularTexture", texture}}},
        {"KHR_materials_specular",
         Json::object(),
         {{"specularColorFactor", {1, 0, 0}}, {"specularFactor", 0}}},
    };
    for (const Case& c : cases) {
        GltfFile file = one_triangle();
        file.material()["extensions"][c.extension] = c.neutral;
        EXPECT_TRUE(load(file).warnings.empty()) << c.extension << c.neutral;
        file.material()["extensions"][c.extension] = c.given;
        const Scene scene = load(file);
        EXPECT_EQ(scene.warnings.size(), 1u) << c.extension << c.given;
        EXPECT_TRUE(has_warning(scene, c.extension)) << c.given;
    }
    GltfFile file = textured_triangle();
    file.material()["occlusionTexture"] = {{"index", 0}, {"strength", 0}};
    EXPECT_TRUE(load(file).warnings.empty());
    file.material()["occlusionTexture"] = {{"index", 0}};
    EXPECT_TRUE(has_warning(load(file), "occlusionTexture"));
}

TEST_F(LoadGltfMaterials, ReadsTheDiffusePartOfSpecularGlossiness) {
    GltfFile file = one_triangle();
    file.material() = {{"pbrMetallicRoughness", {{"baseColorFactor", {1, 0, 0, 1}}, {"roughnessFactor", 0}}}};
    Json& glossy = file.material()["extensions"]["KHR_materials_pbrSpecularGlossiness"];
    glossy = {{"diffuseFactor", {0.5, 0.25, 1, 0.75}}, {"specularFactor", {0, 0, 0}}};
    Scene scene = load(file);
    EXPECT_EQ(scene.material[0].kind, SurfaceKind::diffuse) << "the mirror is for others";
    EXPECT_EQ(scene.material[0].base_color, Rgb(0.5f, 0.25f, 1));
    EXPECT_EQ(scene.material[0].alpha, 0.75f);
    EXPECT_TRUE(scene.warnings.empty());

    glossy = {{"glossinessFactor", 0.5}};
    scene = load(file);
    EXPECT_EQ(scene.material[0].base_color, Rgb(1, 1, 1));
    EXPECT_EQ(scene.material[0].alpha, 1);
    EXPECT_EQ(scene.warnings.size(), 1u);
    EXPECT_TRUE(has_warning(scene, "KHR_materials_pbrSpecularGlossiness"));
    glossy = {{"diffuseFactor", {0.5, 0.25, 1}}};
    expect_error(file, "KHR_materials_pbrSpecularGlossiness/diffuseFactor");
}

TEST_F(LoadGltfMaterials, ReadsWhatIsSaidOfAlpha) {
    GltfFile file = one_triangle();
    Json& material = file.material();
    material["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, 0.25};
    Scene scene = load(file);
    EXPECT_EQ(scene.material[0].alpha_mode, common::AlphaMode::opaque);
    material["alphaMode"] = "BLEND";
    scene = load(file);
    EXPECT_EQ(scene.material[0].alpha_mode, common::AlphaMode::blend);
    EXPECT_EQ(scene.material[0].alpha, 0.25f);
    material["alphaMode"] = "MASK";
    EXPECT_EQ(load(file).material[0].alpha_mode, common::AlphaMode::mask);
    EXPECT_EQ(load(file).material[0].alpha_cutoff, 0.5f);
    material["alphaCutoff"] = 0.75;
    material["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, 7};
    scene = load(file);
    EXPECT_EQ(scene.material[0].alpha_cutoff, 0.75f);
    EXPECT_EQ(scene.material[0].alpha, 1);
    EXPECT_TRUE(scene.warnings.empty());
    material["alphaMode"] = "GLASS";
    scene = load(file);
    EXPECT_EQ(scene.material[0].alpha_mode, common::AlphaMode::opaque);
    EXPECT_TRUE(has_warning(scene, "alphaMode"));
    material["alphaCutoff"] = "a half";
    expect_error(file, "alphaCutoff");
}

TEST_F(LoadGltfMaterials, WarnsAboutRoughGlassAndImpossibleIndices) {
    GltfFile file = one_triangle();
    file.material()["pbrMetallicRoughness"] = {{"roughnessFactor", 0.5}, {"metallicFactor", 0}};
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
    for (const Json& whole : {Json(3000000000), Json(5000000000), Json(3000000000.0)}) {
        file.material()["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", whole}};
        EXPECT_EQ(load(file).material[0].emitted_radiance.x, whole.get<float>());
    }
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

// ---- Textures ----

TEST_F(LoadGltfTextures, ReadsAllThreeSlots) {
    directory.write("red green.png", red_green_png());
    GltfFile file = textured_triangle();
    file.document["images"][0]["uri"] = "red%20green.png";
    file.material() = {
        {"pbrMetallicRoughness", {{"metallicFactor", 0}, {"baseColorTexture", {{"index", 0}}}}},
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

TEST_F(LoadGltfTextures, Keeps16BitsOfDataAnd8OfColors) {
    directory.write("red green.png", sixteen_bit_png());
    GltfFile file = textured_triangle();
    file.material()["normalTexture"] = {{"index", 0}};
    EXPECT_EQ(load(file).texture[0].sample({0.5f, 0.5f}), Rgb(1, 32800.0f / 65535, 1.0f / 65535));
    file.material().erase("normalTexture");
    file.material()["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    const Scene scene = load(file);
    EXPECT_TRUE(scene.texture[0].rgb_16().empty());
    EXPECT_EQ(std::vector(scene.texture[0].rgb().begin(), scene.texture[0].rgb().end()),
              (std::vector<std::uint8_t>{255, 128, 0}));
}

TEST_F(LoadGltfTextures, TakesTheNearestPixelWhereTheSamplerSaysSo) {
    directory.write("red green.png", red_green_png());
    GltfFile file = textured_triangle();
    file.document["samplers"] = {{{"minFilter", 9728}}};
    file.document["textures"][0]["sampler"] = 0;
    file.material()["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    EXPECT_NE(load(file).texture[0].sample({0.45f, 0.5f}).y, 0) << "what is far away is not drawn coarser";
    file.document["samplers"][0]["magFilter"] = 9728;
    const Scene scene = load(file);
    EXPECT_EQ(scene.texture[0].sample({0.45f, 0.5f}), Rgb(1, 0, 0));
    EXPECT_EQ(scene.texture[0].sample({0.55f, 0.5f}), Rgb(0, 1, 0));
    EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(LoadGltfTextures, KeepsAlphaWhereAMaterialReadsIt) {
    directory.write("red green.png", half_clear_png());
    GltfFile file = textured_triangle();
    file.material()["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    file.document["materials"].push_back(file.material());
    EXPECT_FALSE(load(file).texture[0].has_alpha());
    for (const char* mode : {"MASK", "BLEND"}) {
        file.document["materials"][1]["alphaMode"] = mode;
        const Scene scene = load(file);
        ASSERT_EQ(scene.texture.size(), 1u) << "one for both materials";
        EXPECT_EQ(scene.material[0].base_color_texture.texture, scene.material[1].base_color_texture.texture);
        ASSERT_TRUE(scene.texture[0].has_alpha());
        EXPECT_EQ(scene.texture[0].sample_alpha({0.25f, 0.5f}), 1);
        EXPECT_EQ(scene.texture[0].sample_alpha({0.75f, 0.5f}), 128.0f / 255);
    }
    directory.write("red green.png", red_green_png());
    EXPECT_FALSE(load(file).texture[0].has_alpha()) << "255 everywhere";
}

TEST_F(LoadGltfTextures, ReadsTheDiffuseTextureOfSpecularGlossiness) {
    directory.write("red green.png", red_green_png());
    GltfFile file = textured_triangle();
    Json& glossy = file.material()["extensions"]["KHR_materials_pbrSpecularGlossiness"];
    const Json moved = {{"KHR_texture_transform", {{"offset", {0.5, 0}}}}};
    glossy = {{"diffuseTexture", {{"index", 0}, {"texCoord", 1}, {"extensions", moved}}},
              {"specularFactor", {0, 0, 0}}};
    const Scene scene = load(file);
    const common::TextureUse& use = scene.material[0].base_color_texture;
    ASSERT_EQ(use.texture, 0);
    EXPECT_EQ(use.texcoord_set, 1);
    EXPECT_EQ(use.transform(Vec2(0, 0)), Vec2(0.5f, 0));
    EXPECT_EQ(scene.texture[0].sample({0.25f, 0.5f}), Rgb(1, 0, 0));
    glossy["diffuseTexture"]["index"] = 1;
    expect_error(file, "diffuseTexture/index is 1");
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
    file.document["textures"][0]["extensions"]["EXT_texture_webp"]["source"] = 0;
    expect_error(file, "textures/0 has no PNG or JPEG image, only one of EXT_texture_webp");
}

TEST_F(LoadGltfTextures, NamesNoDataInItsErrors) {
    GltfFile file = textured_triangle();
    file.material()["normalTexture"] = {{"index", 0}};
    file.document["images"][0]["uri"] = "data:image/png;base64,AAAA";
    expect_error(file, "image 'images/0' cannot be decoded");
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
    file.material()["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    const Scene scene = load(file);
    EXPECT_EQ(scene.material[0].normal_texture.texture, common::no_texture);
    EXPECT_TRUE(has_warning(scene, "TEXCOORD_2"));
    EXPECT_TRUE(has_warning(scene, "TEXCOORD_0, which is missing"));
}

/// Makes a textured triangle whose base colour, normal and emissive texture all have this
/// KHR_texture_transform.
GltfFile with_transform(const Json& transform) {
    GltfFile file = textured_triangle();
    const Json info = {{"index", 0}, {"extensions", {{"KHR_texture_transform", transform}}}};
    file.material()["pbrMetallicRoughness"]["baseColorTexture"] = info;
    file.material()["normalTexture"] = info;
    file.material()["emissiveTexture"] = info;
    file.material()["emissiveFactor"] = {1, 1, 1};
    return file;
}

TEST_F(LoadGltfTextures, MovesTextureCoordinates) {
    directory.write("red green.png", red_green_png());
    constexpr double quarter = std::numbers::pi / 2;
    struct Case {
        Json transform;
        Vec2 of_origin, of_u, of_v;  // images of (0, 0), (1, 0) and (0, 1)
    };
    const std::vector<Case> cases = {
        {Json::object(), {0, 0}, {1, 0}, {0, 1}},
        {{{"offset", {0.5, -2}}}, {0.5f, -2}, {1.5f, -2}, {0.5f, -1}},
        {{{"scale", {2, -3}}}, {0, 0}, {2, 0}, {0, -3}},
        // Counter-clockwise with u to the right and v down: u is rotated to -v.
        {{{"rotation", quarter}}, {0, 0}, {0, -1}, {1, 0}},
        {{{"rotation", -quarter}}, {0, 0}, {0, 1}, {-1, 0}},
        {{{"rotation", 2 * quarter}}, {0, 0}, {-1, 0}, {0, -1}},
        // The example in the extension's text: the lower left quarter of the image, rotated clockwise.
        {{{"offset", {0, 1}}, {"rotation", quarter}, {"scale", {0.5, 0.5}}}, {0, 1}, {0, 0.5f}, {0.5f, 1}},
        // Scaling comes before rotation.
        {{{"rotation", quarter}, {"scale", {2, 3}}}, {0, 0}, {0, -2}, {3, 0}},
    };
    for (const Case& c : cases) {
        const Scene scene = load(with_transform(c.transform));
        const common::Material& material = scene.material[0];
        EXPECT_TRUE(scene.warnings.empty()) << c.transform;
        for (const common::TextureUse& use :
             {material.base_color_texture, material.normal_texture, material.emissive_texture}) {
            EXPECT_LT((use.transform(Vec2(0, 0)) - c.of_origin).length(), 1e-6f) << c.transform;
            EXPECT_LT((use.transform(Vec2(1, 0)) - c.of_u).length(), 1e-6f) << c.transform;
            EXPECT_LT((use.transform(Vec2(0, 1)) - c.of_v).length(), 1e-6f) << c.transform;
        }
    }
}

TEST_F(LoadGltfTextures, ATransformThatDoesNothingIsNone) {
    directory.write("red green.png", red_green_png());
    const common::Material material =
        load(with_transform({{"offset", {0, 0}}, {"scale", {1, 1}}, {"rotation", 0}})).material[0];
    EXPECT_EQ(material.base_color_texture.transform, common::TexcoordTransform{});
}

TEST_F(LoadGltfTextures, ATransformMayNameOtherTextureCoordinates) {
    directory.write("red green.png", red_green_png());
    GltfFile file = with_transform({{"texCoord", 1}});
    EXPECT_EQ(load(file).material[0].base_color_texture.texcoord_set, 1);
    EXPECT_EQ(load(file).material[0].normal_texture.texcoord_set, 1);
    EXPECT_EQ(load(file).material[0].emissive_texture.texcoord_set, 1);
    file = with_transform({{"texCoord", 0}});
    file.material()["normalTexture"]["texCoord"] = 2;
    EXPECT_EQ(load(file).material[0].normal_texture.texcoord_set, 0) << "and wins";
    EXPECT_TRUE(has_warning(load(with_transform({{"texCoord", 2}})), "TEXCOORD_2"));
}

TEST_F(LoadGltfTextures, RefusesBrokenTransforms) {
    directory.write("red green.png", red_green_png());
    expect_error(with_transform({{"offset", {0}}}), "KHR_texture_transform/offset");
    expect_error(with_transform({{"scale", {1, 2, 3}}}), "KHR_texture_transform/scale");
    expect_error(with_transform({{"scale", 2}}), "KHR_texture_transform/scale");
    expect_error(with_transform({{"rotation", {1}}}), "KHR_texture_transform/rotation");
    expect_error(with_transform({{"texCoord", -1}}), "KHR_texture_transform/texCoord");
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
    // A quarter turn about x maps -z to +y.
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
    // A quarter turn about y maps -z to -x.
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
