// Tests vertex colours in glTF files.
#include "common/scene/surface_point.h"
#include "tests/support/load_gltf.h"

namespace {

using namespace gltf_text;

using LoadGltfColors = LoadGltf;

/// Makes one triangle whose COLOR_0 holds these numbers.
template <class T>
GltfFile colored_triangle(const std::vector<T>& values, int component_type, const std::string& type,
                          bool normalized) {
    GltfFile file = one_triangle();
    const int color = file.add_accessor<T>(values, component_type, type);
    if (normalized) file.accessor(color)["normalized"] = true;
    file.primitive()["attributes"]["COLOR_0"] = color;
    return file;
}

GltfFile floats(const std::vector<float>& values, const std::string& type = "VEC3") {
    return colored_triangle(values, f32, type, false);
}

TEST_F(LoadGltfColors, MultiplyTheBaseColor) {
    GltfFile file = floats({1, 0.5f, 0.25f, 0, 1, 1, 0.5f, 0.5f, 0.5f});
    file.material() = {
        {"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 1, 0.5, 1}}, {"metallicFactor", 0}}}};
    const Scene scene = load(file);
    EXPECT_TRUE(scene.warnings.empty());
    EXPECT_EQ(scene.color, (std::vector<Rgb>{{1, 0.5f, 0.25f}, {0, 1, 1}, {0.5f, 0.5f, 0.5f}}));
    EXPECT_EQ(scene.alpha, (std::vector<float>{1, 1, 1}));
    expect_near(common::base_color_at(scene, {0, 0, 0}), {0.5f, 0.5f, 0.125f});
    expect_near(common::base_color_at(scene, {0, 0.5f, 0.25f}), {0.1875f, 0.75f, 0.34375f});
}

TEST_F(LoadGltfColors, ReadTheTypesThatAreAllowed) {
    const std::vector<Rgb> expected = {{1, 0, 0.2f}, {0.2f, 0.4f, 0.6f}, {0, 0, 0}};
    const std::vector<float> three = {1, 0, 0.2f, 0.2f, 0.4f, 0.6f, 0, 0, 0},
                             four = {1, 0, 0.2f, 1, 0.2f, 0.4f, 0.6f, 0.8f, 0, 0, 0, 0.4f};
    for (const auto& [values, type] : {std::pair(three, "VEC3"), std::pair(four, "VEC4")}) {
        std::vector<std::uint8_t> bytes;
        std::vector<std::uint16_t> shorts;
        for (const float value : values) {
            bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * value)));
            shorts.push_back(static_cast<std::uint16_t>(std::lround(65535 * value)));
        }
        GltfFile from_bytes = colored_triangle(bytes, u8, type, true);
        if (values.size() == 9) {  // elements begin at multiples of four bytes
            from_bytes = one_triangle();
            std::vector<std::uint8_t> padded;
            for (std::size_t i = 0; i < 9; i += 3)
                padded.insert(padded.end(), {bytes[i], bytes[i + 1], bytes[i + 2], 77});
            const int color = from_bytes.add_accessor<std::uint8_t>(padded, u8, "VEC4");
            from_bytes.accessor(color).update({{"type", "VEC3"}, {"normalized", true}});
            from_bytes.view(from_bytes.accessor(color)["bufferView"])["byteStride"] = 4;
            from_bytes.primitive()["attributes"]["COLOR_0"] = color;
        }
        for (const GltfFile& file :
             {floats(values, type), from_bytes, colored_triangle(shorts, u16, type, true)}) {
            const Scene scene = load(file);
            EXPECT_TRUE(scene.warnings.empty());
            ASSERT_EQ(scene.color.size(), 3u);
            for (std::size_t i = 0; i < 3; ++i) {
                expect_near(scene.color[i], expected[i], 1e-5f);
                EXPECT_NEAR(scene.alpha[i], values.size() == 9 ? 1 : four[4 * i + 3], 1e-5f);
            }
        }
    }
}

TEST_F(LoadGltfColors, AreNotKeptWhereTheyChangeNothing) {
    for (const char* type : {"VEC3", "VEC4"}) {
        const Scene scene = load(floats(std::vector<float>(type[3] == '3' ? 9 : 12, 1), type));
        EXPECT_TRUE(scene.color.empty());
        EXPECT_TRUE(scene.alpha.empty());
    }
    // The alpha of an opaque material has no effect either.
    const std::vector<float> white = {1, 1, 1, 0.5f, 1, 1, 1, 0, 1, 1, 1, 1};
    EXPECT_TRUE(load(floats(white, "VEC4")).color.empty());
    EXPECT_TRUE(load(one_triangle()).color.empty());
}

TEST_F(LoadGltfColors, AreWhiteWhereAMeshHasNone) {
    // Three primitives of three vertices: one of them has colours, at each position in turn.
    for (int with = 0; with < 3; ++with) {
        GltfFile file = floats({0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f});
        const Json colored = file.primitive();
        Json plain = colored;
        plain["attributes"].erase("COLOR_0");
        Json& primitives = file.document["meshes"][0]["primitives"];
        primitives = Json::array();
        for (int i = 0; i < 3; ++i) primitives.push_back(i == with ? colored : plain);
        const Scene scene = load(file);
        ASSERT_EQ(scene.color.size(), scene.position.size());
        ASSERT_EQ(scene.alpha.size(), scene.position.size());
        for (std::uint32_t t = 0; t < 3; ++t)
            for (const std::uint32_t vertex : scene.triangle[t])
                EXPECT_EQ(scene.color[vertex].x, static_cast<int>(t) == with ? 0.5f : 1) << with;
    }
}

TEST_F(LoadGltfColors, FollowTheVerticesOfMirroredNodes) {
    GltfFile file = floats({1, 0, 0, 0, 1, 0, 0, 0, 1});
    file.node()["scale"] = {-1, 1, 1};
    const Scene scene = load(file);
    for (std::size_t vertex = 0; vertex < 3; ++vertex) {
        const Vec3 at = scene.position[vertex];
        EXPECT_EQ(scene.color[vertex], at.x < -0.5f  ? Rgb(0, 1, 0)
                                       : at.y > 0.5f ? Rgb(0, 0, 1)
                                                     : Rgb(1, 0, 0));
    }
}

TEST_F(LoadGltfColors, AreMendedWithAWarning) {
    const Scene bright = load(floats({2, 0.5f, -1, 1, 1, 1, 1, 1, 1}));
    EXPECT_EQ(bright.color[0], Rgb(1, 0.5f, 0));
    EXPECT_TRUE(has_warning(bright, "vertex colours clamped to [0, 1]"));
    const Scene broken = load(floats({nan_value, 0.5f, 1, 1, 1, 1, 1, 1, 1}));
    EXPECT_EQ(broken.color[0], Rgb(1, 0.5f, 1));
    EXPECT_TRUE(has_warning(broken, "vertex colours that are not finite"));
    const Scene forgotten =
        load(colored_triangle<std::uint16_t>({0, 13107, 65535, 0, 0, 0, 0, 0, 0}, u16, "VEC3", false));
    expect_near(forgotten.color[0], {0, 0.2f, 1});
    EXPECT_TRUE(has_warning(forgotten, "vertex colours that are not normalized"));
}

TEST_F(LoadGltfColors, OfOtherSetsAreLeftOutWithAWarningThatNamesThem) {
    GltfFile file = floats({0.5f, 1, 1, 1, 1, 1, 1, 1, 1});
    file.primitive()["attributes"]["COLOR_1"] =
        file.add_accessor<float>({0, 0, 0, 0, 0, 0, 0, 0, 0}, f32, "VEC3");
    const Scene scene = load(file);
    EXPECT_EQ(scene.color[0], Rgb(0.5f, 1, 1));
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_TRUE(has_warning(scene, "COLOR_1"));
    GltfFile alone = one_triangle();
    alone.primitive()["attributes"]["COLOR_1"] =
        alone.add_accessor<float>({0, 0, 0, 0, 0, 0, 0, 0, 0}, f32, "VEC3");
    EXPECT_TRUE(load(alone).color.empty());
    EXPECT_TRUE(has_warning(load(alone), "COLOR_1"));
}

TEST_F(LoadGltfColors, OfWrongShapeAreRefused) {
    expect_error(floats({1, 0, 0, 1, 0, 1}, "VEC2"), "VEC3");
    expect_error(floats({1, 0, 0, 1, 0, 1}), "COLOR_0 has 2 elements, POSITION 3");
    expect_error(colored_triangle<std::uint32_t>(std::vector<std::uint32_t>(9, 1), u32, "VEC3", false),
                 "VEC3");
    GltfFile beyond = floats({1, 0, 0, 1, 0, 1, 0, 0, 0});
    beyond.primitive()["attributes"]["COLOR_0"] = 99;
    expect_error(beyond, "");
}

}  // namespace
