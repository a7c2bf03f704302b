// shlmbench export as its user meets it: what is written, what other readers find in it, and what is refused.
#include <nlohmann/json.hpp>

#include "common/core/input_error.h"
#include "common/gltf/load_gltf.h"
#include "common/image/image.h"
#include "tests/support/command.h"

namespace {

using namespace command;
using child_process::text_of;
using Json = nlohmann::ordered_json;

class Export : public Command {
  protected:
    [[nodiscard]] Words to_folder(const std::string& name, const Words& more = {}) const {
        Words words = {"export", cornell, "--texels", "1500", "--hits", "20000", "--out", path(name)};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }

    [[nodiscard]] Json json_of(const std::string& file) const { return Json::parse(text_of(path(file))); }
};

/// The JSON chunk of a binary glTF file.
Json json_chunk(const std::string& glb) {
    std::uint32_t length = 0;
    std::memcpy(&length, glb.data() + 12, 4);
    return Json::parse(glb.substr(20, length));
}

TEST_F(Export, WritesWhatOthersRead) {
    expect_success(to_folder("out"));
    EXPECT_EQ(files_in(path("out")), (std::set<std::string>{"lit.glb", "lightmap.exr", "lightmap.npy",
                                                            "lightmap.json", "viewer.html"}));

    const Json about = json_of("out/lightmap.json");
    EXPECT_EQ(about["scene"], "cornell");
    EXPECT_GE(about["hits"].get<int>(), 20000);
    const int width = about["atlas"]["width"], height = about["atlas"]["height"];
    const Json& map = about["maps"][0];
    EXPECT_EQ(map["method"], "shlm/L2/normalised/bilinear/half");
    ASSERT_EQ(map["numbers"].size(), 27u);
    EXPECT_EQ(map["numbers"][26], "sh.8.B");

    // The picture: viewers show R, G, B; the numbers have names.
    const common::Image image = common::read_image(path("out/lightmap.exr"));
    EXPECT_EQ(image.width, width);
    EXPECT_EQ(image.height, height);
    for (const char* channel : {"R", "G", "B", "sh.0.R", "sh.8.B", "covered.A", "hits"})
        EXPECT_TRUE(image.find_channel(channel)) << channel;
    double hits = 0, covered = 0;
    for (std::size_t p = 0; p < image.pixel_count(); ++p) {
        hits += image.at(p, *image.find_channel("hits"));
        covered += image.at(p, *image.find_channel("covered.A"));
    }
    EXPECT_EQ(hits, about["hits"].get<double>());
    EXPECT_GT(covered, 1000);
    const common::ImageNotes notes = common::read_notes(path("out/lightmap.exr"));
    for (const char* note :
         {"scene", "fingerprint", "method", "basis", "formula", "unit", "seed", "hits", "commit"})
        EXPECT_TRUE(notes.contains(std::string("shlmbench:") + note)) << note;

    // NumPy's array: its head, and as many halves as it says.
    const std::string npy = text_of(path("out/lightmap.npy"));
    EXPECT_TRUE(npy.starts_with("\x93NUMPY"));
    EXPECT_NE(npy.find("'shape': (" + std::to_string(height) + ", " + std::to_string(width) + ", 27)"),
              std::string::npos);
    const std::size_t head =
        10 + static_cast<unsigned char>(npy[8]) + 256 * static_cast<unsigned char>(npy[9]);
    EXPECT_EQ(head % 64, 0u);
    EXPECT_EQ(npy.size() - head, 2u * 27 * width * height);
}

TEST_F(Export, CountsOfHitsAreNotRounded) {
    expect_success({"export", cornell, "--texels", "64", "--hits", "300001", "--out", path("out")});
    const common::Image image = common::read_image(path("out/lightmap.exr"));
    double hits = 0;
    for (std::size_t p = 0; p < image.pixel_count(); ++p) hits += image.at(p, *image.find_channel("hits"));
    EXPECT_EQ(hits, json_of("out/lightmap.json")["hits"].get<double>()) << "thousands on each texel";
}

TEST_F(Export, TheSceneCanBeReadAgain) {
    expect_success(to_folder("out"));
    const common::Scene before = common::load_gltf(cornell), after = common::load_gltf(path("out/lit.glb"));
    EXPECT_EQ(after.triangle.size(), before.triangle.size());
    EXPECT_NEAR(after.diagonal(), before.diagonal(), 1e-5);
    ASSERT_EQ(after.camera.size(), 1u);
    EXPECT_LT((after.camera[0].eye - before.camera[0].eye).length(), 1e-5f);
    EXPECT_LT((after.camera[0].forward - before.camera[0].forward).length(), 1e-5f);
    float emitted = 0, emitted_before = 0;
    for (const common::Material& material : after.material)
        emitted += common::max_component(material.emitted_radiance);
    for (const common::Material& material : before.material)
        emitted_before += common::max_component(material.emitted_radiance);
    EXPECT_NEAR(emitted, emitted_before, 1e-4 * emitted_before);

    const Json json = json_chunk(text_of(path("out/lit.glb")));
    EXPECT_FALSE(json.contains("extensionsRequired"));
    for (const char* name : {"SHLM_lightmap", "MOZ_lightmap"})
        EXPECT_NE(std::find(json["extensionsUsed"].begin(), json["extensionsUsed"].end(), name),
                  json["extensionsUsed"].end());
    for (const Json& mesh : json["meshes"])
        for (const Json& primitive : mesh["primitives"])
            for (const char* name : {"POSITION", "NORMAL", "TEXCOORD_1", "_LIGHTMAP_RECT"})
                EXPECT_TRUE(primitive["attributes"].contains(name)) << name;
    const Json& extension = json["extensions"]["SHLM_lightmap"];
    const int pixels = extension["atlas"]["width"].get<int>() * extension["atlas"]["height"].get<int>();
    const Json& map = extension["maps"][0];
    EXPECT_EQ(map["layers"], 7);
    EXPECT_EQ(json["bufferViews"][map["bufferView"].get<std::size_t>()]["byteLength"], 8 * 7 * pixels);
    EXPECT_EQ(json["bufferViews"][extension["faces"].get<std::size_t>()]["byteLength"], 16 * pixels);
}

TEST_F(Export, SumsThatWereTracedBeforeGiveTheSameLight) {
    expect_success({"trace", cornell, "--texels", "1500", "--hits", "20000", "--method", "shlm/AD",
                    "--checkpoint", path("map.exr")});
    expect_success(to_folder("traced", {"--method", "shlm/AD/radiance/bilinear"}));
    expect_success({"export", cornell, "--texels", "1500", "--map", path("map.exr"), "--method",
                    "shlm/AD/radiance/bilinear", "--out", path("read")});
    EXPECT_TRUE(text_of(path("read/lightmap.npy")) == text_of(path("traced/lightmap.npy")));
    EXPECT_TRUE(text_of(path("read/lit.glb")) == text_of(path("traced/lit.glb")));
}

TEST_F(Export, SeveralMapsAndPhotonMapsShareARun) {
    expect_success(to_folder(
        "out", {"--method", "shlm/L0/normalised/bilinear,shlm/L4/radiance/bilinear,photonmap/compact"}));
    const Json about = json_of("out/lightmap.json");
    ASSERT_EQ(about["maps"].size(), 2u);
    EXPECT_EQ(about["maps"][1]["basis"], "L4");
    const std::string page = text_of(path("out/viewer.html"));
    EXPECT_NE(page.find("photonmap/compact/k50/disc"), std::string::npos);
}

TEST_F(Export, WritesAdaptiveMapsAsTexelsAndSaysWhatThatCosts) {
    for (const std::string placement : {"uv", "face"}) {
        SCOPED_TRACE(placement);
        expect_success(to_folder(placement, {"--method", "shlm/a10/normalised/bilinear/" + placement}));
        const Json map = json_of(placement + "/lightmap.json")["maps"][0];
        EXPECT_EQ(map["fields"]["basis"], "adaptive");
        EXPECT_EQ(map["basis"], "F2") << "of the texels";
        const Json& expansion = map["expansion"];
        EXPECT_GT(expansion["bytes_of_texels"].get<int>(), 2 * expansion["bytes_of_map"].get<int>());
        // Distant lights of AD are truncated, and blends are followed by straight lines.
        EXPECT_LT(expansion["relative_rms"], 0.05);
        EXPECT_GT(expansion["relative_rms"], 0);
        const common::Image image = common::read_image(path(placement + "/lightmap.exr"));
        double hits = 0;
        for (std::size_t p = 0; p < image.pixel_count(); ++p)
            hits += image.at(p, *image.find_channel("hits"));
        EXPECT_EQ(hits, json_of(placement + "/lightmap.json")["hits"].get<double>());
    }
}

TEST_F(Export, RefusesWhatNoFragmentProgramCanAsk) {
    expect_refusal(to_folder("out", {"--method", "shlm/L2/radiance/surface4"}), {"--method", "bilinear"});
    expect_refusal(to_folder("out", {"--method", "shlm/a5,shlm/L2/radiance/bilinear"}),
                   {"--method", "adaptive", "alone"});
    expect_refusal(to_folder("out", {"--method", "shlm/a5/normalised/own"}), {"--method", "bilinear"});
    expect_refusal(to_folder("out", {"--method", "photonmap/compact"}), {"--method", "light map"});
    expect_refusal(
        to_folder("out", {"--method", "shlm/L2/radiance/bilinear,shlm/L0/normalised/bilinear/t99"}),
        {"--method", "same texels"});
    expect_refusal({"export", cornell, "--out", path("out")}, {"--hits"});
    expect_refusal({"export", cornell, "--out", path("out"), "--map", "map.exr", "--method",
                    "shlm/L2/radiance/bilinear,shlm/L0/normalised/bilinear"},
                   {"--map", "one method"});
}

TEST_F(Export, ReplacesOnlyWhatItMade) {
    fs::create_directory(path("out"));
    std::ofstream(path("out/viewer.html")) << "mine";
    expect_refusal(to_folder("out"), {"viewer.html", "lightmap.json"});
    EXPECT_EQ(text_of(path("out/viewer.html")), "mine");
    fs::remove(path("out/viewer.html"));
    expect_success(to_folder("out"));
    expect_success(to_folder("out"));
}

}  // namespace
