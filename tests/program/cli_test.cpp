// Tests the command line: exit codes, one line for every mistake, and no incomplete files.
#include <OpenImageIO/imageio.h>

#include <cmath>
#include <limits>

#include "common/image/image.h"
#include "tests/support/command.h"

namespace {

using namespace command;
using child_process::text_of;
using Json = nlohmann::json;

/// Returns the arguments of every command for the scene.
std::vector<Words> all_commands(const std::string& scene, const std::string& out) {
    return {{"info", scene},
            {"render", scene, "--method", "photonmap", "--hits", "1000", "--out", out + "/image.exr"},
            {"compare", scene, "--hits", "1000", "--out", out}};
}

// Scenes.

using BadScene = Command;

TEST_F(BadScene, Missing) {
    for (const Words& words : all_commands(path("no-such-scene.glb"), folder.path()))
        expect_refusal(words, {"no-such-scene.glb"});
}

TEST_F(BadScene, MissingBesideAGoodOneStopsACompareBeforeItStarts) {
    expect_refusal({"compare", cornell, path("no-such-scene.glb"), "--hits", "1000", "--out", folder.path()},
                   {"no-such-scene.glb"});
}

TEST_F(BadScene, Truncated) {
    const std::string whole = text_of(cornell);
    for (std::size_t length : {std::size_t{0}, std::size_t{16}, whole.size() - 1}) {
        folder.write("cut.glb", whole.substr(0, length));
        for (const Words& words : all_commands(path("cut.glb"), folder.path()))
            expect_refusal(words, {"cut.glb"});
    }
}

TEST_F(BadScene, AccessorBeyondItsBuffer) {
    GltfFile file = gltf_text::one_triangle();
    file.accessor(0)["count"] = 1000;
    const std::string scene = write(file);
    expect_refusal(render(scene, "photonmap"), {"scene.gltf", "accessor"});
}

TEST_F(BadScene, PositionsThatAreNotNumbers) {
    GltfFile file = gltf_text::one_triangle();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::memcpy(file.buffer.data(), &nan, sizeof nan);
    const std::string scene = write(file);
    expect_refusal(render(scene, "photonmap", {"--sky", "1,1,1"}), {"scene.gltf", "finite"});
}

TEST_F(BadScene, OnlyTrianglesWithoutArea) {
    GltfFile file = gltf_text::one_triangle();
    std::fill(file.buffer.begin(), file.buffer.end(), std::uint8_t{0});
    const std::string scene = write(file);
    expect_refusal(render(scene, "photonmap", {"--sky", "1,1,1"}), {"scene.gltf", "no triangles"});
}

TEST_F(BadScene, NoTriangles) {
    GltfFile file = gltf_text::one_triangle();
    constexpr int points = 0;
    file.primitive()["mode"] = points;
    const std::string scene = write(file);
    expect_refusal(render(scene, "photonmap", {"--sky", "1,1,1"}), {"scene.gltf", "no triangles"});
}

TEST_F(BadScene, NoLight) {
    const std::string scene = write(gltf_text::one_triangle());
    expect_refusal(render(scene, "photonmap"), {"scene.gltf", "light", "--sky", "--sun"});
    expect_refusal(render(scene, "photonmap", {"--sky", "0,0,0"}), {"light"});
    expect_refusal({"compare", scene, "--hits", "1000", "--out", folder.path()}, {"light", "--sky", "--sun"});
}

TEST_F(BadScene, NoLightmapCoordinatesForALightMap) {
    const std::string scene = write(gltf_text::one_triangle());
    const Words fragments = {"scene.gltf", "unwrapping", "TEXCOORD_1", "by face"};
    expect_refusal(render(scene, "shlm", {"--sky", "1,1,1", "--texels", "uv"}), fragments);
    expect_refusal(render(scene, "shlm/L2/flux/knn4/uv", {"--sky", "1,1,1"}), fragments);
}

TEST_F(BadScene, NothingThatTheCameraSees) {
    expect_refusal(
        {"compare", cornell, "--hits", "1000", "--out", folder.path(), "--camera", "0,9,0,0,10,0,40"},
        {"cornell.glb", "--camera"});
}

// Options.

using BadOption = Command;

TEST_F(BadOption, NoSubcommandOrAnUnknownOne) {
    expect_refusal({}, {"subcommand"});
    expect_refusal({"rendre", cornell}, {});
}

TEST_F(BadOption, UnknownOption) {
    expect_refusal(render(cornell, "photonmap", {"--colour", "red"}), {"--colour"});
    expect_refusal({"info", cornell, "--colour"}, {"--colour"});
}

TEST_F(BadOption, UnknownMethod) {
    expect_refusal(render(cornell, "photonmap/oak"),
                   {"--method:", "photonmap/oak", "flann", "flann-incremental", "compact"});
    expect_refusal({"compare", cornell, "--methods", "shlm,oak", "--out", folder.path()},
                   {"--methods:", "oak"});
}

TEST_F(BadOption, NumberOfHits) {
    const Words without = {"render", cornell, "--method", "shlm", "--out", path("image.exr")};
    for (const char* hits : {"0", "-1", "nan", "1e30", "1.5", "text"}) {
        Words words = without;
        words.insert(words.end(), {"--hits", hits});
        expect_refusal(words, {"--hits", hits});
    }
    expect_refusal({"compare", cornell, "--out", folder.path(), "--hits", "1e3,inf"}, {"--hits", "inf"});
    expect_refusal(without, {"--hits", "--photons"});
    expect_refusal(render(cornell, "shlm", {"--photons", "1e3"}), {"--hits", "--photons"});
}

TEST_F(BadOption, MoreThanFitsInMemory) {
    const Words start = {"render", cornell, "--out", path("image.exr"), "--method"};
    const auto with = [&](const Words& more) {
        Words words = start;
        words.insert(words.end(), more.begin(), more.end());
        return words;
    };
    expect_refusal(with({"photonmap", "--hits", "1e13"}),
                   {"photonmap/flann/k50/disc: needs", "GiB are free"});
    expect_refusal(with({"photonmap", "--photons", "1e13"}),
                   {"photonmap/flann/k50/disc: needs", "GiB are free"});
    expect_refusal(with({"photonmap/flann-incremental", "--hits", "1e13"}), {"needs", "GiB are free"});
    expect_refusal(with({"shlm", "--hits", "1e3", "--texels", "4e12"}),
                   {"shlm/L2/radiance/surface4: needs", "GiB are free"});
    expect_refusal({"info", cornell, "--texels", "4e12"},
                   {"shlm/L2/radiance/surface4: needs", "GiB are free"});
}

TEST_F(BadOption, PlaceToWriteTo) {
    folder.write("file", "");
    fs::create_directory(path("folder.exr"));
    const Words start = {"render", cornell, "--method", "photonmap", "--hits", "1000", "--out"};
    const auto to = [&](const std::string& out) {
        Words words = start;
        words.push_back(path(out));
        return words;
    };
    expect_refusal(to("missing/image.exr"), {"--out", "missing"});
    expect_refusal(to("file/image.exr"), {"--out", "file"});
    expect_refusal(to("folder.exr"), {"--out", "folder.exr"});
    expect_refusal(to("image.png"), {"--out", ".exr"});
    expect_refusal(to("image"), {"--out", ".exr"});
    expect_refusal(to(std::string(5000, 'x') + "/image.exr"), {"--out"});
    expect_refusal({"compare", cornell, "--hits", "1000", "--out", path("file/results")}, {"--out", "file"});
    expect_refusal({"compare", cornell, "--hits", "1000", "--out", path("file")}, {"--out", "file"});
}

TEST_F(BadOption, Camera) {
    for (const char* camera : {"1", "text", "0,0,0,0,0,0,60", "0,0,0,0,0,1,0", "0,0,0,0,0,1,60,3",
                               "0,0,0,0,0,nan,60", "0,0,0,0,0,1e99,60"})
        expect_refusal(render(cornell, "photonmap", {"--camera", camera}), {"--camera"});
}

TEST_F(BadOption, Light) {
    for (const char* sky : {"1", "-1,0,0", "nan,1,1", "1e99,1,1", "blue", "1,1,"})
        expect_refusal(render(cornell, "photonmap", {std::string("--sky=") + sky}), {"--sky"});
    for (const char* sun : {"1,1,1", "0,0,0,1,1,1", "0,1,0,-1,1,1", "0,1,0,1,1,nan", "noon"})
        expect_refusal(render(cornell, "photonmap", {std::string("--sun=") + sun}), {"--sun"});
}

TEST_F(BadOption, Numbers) {
    const std::vector<std::pair<std::string, Words>> bad = {
        {"--threads", {"-1", "1025", "many", "", "0x2", "+1", "1 ", "4294967297"}},
        {"--seed", {"-1", "1.5", "text", "1e30", "", "18446744073709551616", "0x10", "1_000", "1'000", " 1"}},
        {"--texels", {"-1", "0", "nan", "1e30", "faces", "face,", "uv,0", "64,face", ""}},
        {"--max-radius", {"-1", "nan", "inf", "", "0x1p-3", "0,5", "1e400", "1 m"}},
        {"--width", {"0", "-5", "16385", "1e2", "0x40", "64.0", "4294967312", ""}},
        {"--height", {"0", "-5", "16385", "1e2", "0x40", "64.0", "4294967312", ""}},
        {"--camera", {""}},
        {"--sky", {""}},
        {"--sun", {""}},
    };
    for (const auto& [option, values] : bad)
        for (const std::string& value : values)
            expect_refusal(render(cornell, "shlm", {option + "=" + value}), {option});
    const Words compare = {"compare", cornell, "--hits", "1000", "--out", folder.path()};
    for (const char* option :
         {"--repetitions=0", "--repetitions=-1", "--repetitions=0x2", "--repetitions=18446744073709551617",
          "--seconds-per-size=-1", "--seconds-per-size=nan", "--seconds-per-size=0x1", "--max-memory=little",
          "--max-memory=-1GiB", "--max-memory=nanGiB", "--max-memory=0.5", "--max-memory="}) {
        Words words = compare;
        words.emplace_back(option);
        expect_refusal(words, {std::string(option).substr(0, std::string(option).find('='))});
    }
    expect_refusal(
        {"render", cornell, "--method", "shlm", "--hits", "1000", "--out", path("image.exr"), "--width", "0"},
        {"--width"});
}

TEST_F(BadOption, EmptyPlacesInLists) {
    const auto refuse = [&](Words words, const std::string& option, const Words& lists) {
        for (const std::string& list : lists) {
            Words all = words;
            all.insert(all.end(), {option, list, "--out", path("out")});
            expect_refusal(all, {option});
        }
    };
    const Words numbers = {"1e4,,1e5", "1e4,", ",1e4", ",", "", "1e4, ,1e5", "1e4;1e5"};
    refuse({"compare", cornell}, "--hits", numbers);
    refuse({"compare", cornell}, "--methods", {"shlm,,photonmap", "shlm,", ",", ""});
    refuse({"study", cornell}, "--hits", numbers);
    refuse({"study", cornell}, "--methods", {"shlm,,photonmap", "shlm,", ",", ""});
    refuse({"fit", cornell}, "--target", {"10%,,5%", "10%,", ",", ""});
    refuse({"fit", cornell, "--target", "5%"}, "--least", {"time,,bytes", "time,", ",", ""});
}

TEST_F(BadOption, NumbersOfOtherCommands) {
    for (const char* option :
         {"--environments=0x10", "--environments=1e2", "--environments=", "--seed=18446744073709551616"})
        expect_refusal({"bases", "--out", path("out"), option}, {std::string(option).substr(0, 6)});
    for (const char* option : {"--repeat=0x3", "--repeat=4294967299", "--repeat=", "--seed=0x1", "--hits="})
        expect_refusal({"limit", cornell, option}, {std::string(option).substr(0, 6)});
    for (const char* option : {"--seeds=0x2", "--seeds=18446744073709551617", "--seeds=", "--threads=0x1"})
        expect_refusal({"study", cornell, "--out", path("out"), option}, {std::string(option).substr(0, 7)});
    for (const char* option :
         {"--seeds=0x2", "--time=", "--budget-bytes=", "--max-memory=0.5", "--verify=", "--out="})
        expect_refusal({"fit", cornell, "--target", "5%", option}, {std::string(option).substr(0, 5)});
    for (const char* option : {"--threads=0x1", "--threads=", "--threads=1025"})
        expect_refusal({"stability", "dim-light", "--short", "--out", path("out"), option}, {"--threads"});
    for (const char* option :
         {"--first-photon=", "--first-photon=-0", "--first-photon=0x1", "--photons=", "--resume="})
        expect_refusal({"trace", cornell, "--hits", "1000", option}, {std::string(option).substr(0, 8)});
}

TEST_F(BadOption, TheLargestSeedIsOne) {
    expect_success(render(cornell, "photonmap", {"--seed", "18446744073709551615"}));
    EXPECT_EQ(common::read_notes(path("image.exr")).at("shlmbench:seed"), "18446744073709551615");
    // Numbers are decimal, even with a leading zero.
    expect_success(render(cornell, "photonmap", {"--seed", "010"}));
    EXPECT_EQ(common::read_notes(path("image.exr")).at("shlmbench:seed"), "10");
}

// info.

using Info = Command;

TEST_F(Info, PrintsJson) {
    const Ended ended = run({"info", "--json", cornell});
    ASSERT_EQ(ended.exit_code, 0) << ended.err;
    const Json facts = Json::parse(ended.out);
    for (const char* key :
         {"triangles", "instances", "lights", "cameras", "lightmap_uv", "texels", "warnings"})
        EXPECT_TRUE(facts.contains(key)) << key;
    EXPECT_EQ(facts["cameras"], 1);
    EXPECT_TRUE(facts["lightmap_uv"]["usable"]);
    EXPECT_NEAR(facts["texels"]["total"], 262144, 2621);
}

TEST_F(Info, TellsWhatASceneLacks) {
    const std::string scene = write(gltf_text::one_triangle());
    const Ended ended = run({"info", "--json", "--texels", "uv", scene});
    ASSERT_EQ(ended.exit_code, 0) << ended.err;
    const Json facts = Json::parse(ended.out);
    EXPECT_EQ(facts["triangles"], 1);
    EXPECT_EQ(facts["cameras"], 0);
    EXPECT_EQ(facts["camera"]["name"], "automatic");
    EXPECT_FALSE(facts["lightmap_uv"]["usable"]);
    EXPECT_TRUE(facts["texels"].is_null());
    EXPECT_NE(facts["warnings"].dump().find("TEXCOORD_1"), std::string::npos);
}

TEST_F(Info, ATriangleWithoutCoordinatesHasTexelsByItsFace) {
    const Ended ended = run({"info", "--json", "--texels", "100", write(gltf_text::one_triangle())});
    ASSERT_EQ(ended.exit_code, 0) << ended.err;
    const Json facts = Json::parse(ended.out);
    EXPECT_EQ(facts["texels"]["instances_by_face"], 1);
    EXPECT_EQ(facts["texels"]["charts"], 1);
    EXPECT_NEAR(facts["texels"]["total"], 100, 10);
    EXPECT_TRUE(facts["warnings"].empty()) << facts["warnings"];
}

// render.

using Render = Command;

TEST_F(Render, WritesHalfFloatsWithTheirOriginAndAPicture) {
    expect_success(render(cornell, "shlm/L2/flux", {"--seed", "7"}));
    EXPECT_EQ(files_in(folder.path()), (std::set<std::string>{"image.exr", "image.png"}));
    const auto exr = OIIO::ImageInput::open(path("image.exr"));
    ASSERT_TRUE(exr);
    const OIIO::ImageSpec& spec = exr->spec();
    EXPECT_EQ(spec.format, OIIO::TypeHalf);
    EXPECT_EQ(spec.width, 32);
    EXPECT_EQ(spec.height, 18);
    EXPECT_EQ(spec.channelnames.size(), 7u);
    EXPECT_EQ(spec.get_string_attribute("shlmbench:scene"), "cornell");
    EXPECT_EQ(spec.get_string_attribute("shlmbench:method"), "shlm/L2/flux/surface4");
    EXPECT_EQ(spec.get_string_attribute("shlmbench:seed"), "7");
    EXPECT_NE(spec.get_string_attribute("shlmbench:settings").find("texels=262144"), std::string::npos);
    EXPECT_GE(std::stod(std::string(spec.get_string_attribute("shlmbench:hits"))), 2000);
    for (const char* name : {"photons_emitted", "machine", "instruction_set", "compiler", "flags",
                             "libraries", "commit", "date"})
        EXPECT_NE(spec.get_string_attribute(std::string("shlmbench:") + name), "") << name;
    const auto png = OIIO::ImageInput::open(path("image.png"));
    ASSERT_TRUE(png);
    EXPECT_EQ(png->spec().width, 32);
    EXPECT_EQ(png->spec().nchannels, 3);
}

TEST_F(Render, IsTheSamePictureByStarlight) {
    const auto picture_by = [&](const std::string& sky) {
        expect_success(
            render(write(gltf_text::one_triangle()), "photonmap", {"--sky", sky, "--max-radius=0.3"}));
        return common::read_image(path("image.exr"));
    };
    const common::Image day = picture_by("1,1,1"), night = picture_by("1e-9,1e-9,1e-9");
    ASSERT_EQ(day.values.size(), night.values.size());
    const std::size_t irradiance = *day.find_channel("irradiance.G");
    float brightest = 0;
    for (std::size_t p = 0; p < day.pixel_count(); ++p)
        brightest = std::max(brightest, day.at(p, irradiance));
    for (std::size_t p = 0; p < day.pixel_count(); ++p)  // day is in half floats
        EXPECT_NEAR(1e9f * night.at(p, irradiance), day.at(p, irradiance), 1e-3f * brightest);
}

TEST_F(Render, IsTheSameForAnyNumberOfThreads) {
    // photonmap/flann-incremental is excluded: FLANN shuffles its points with std::random_device, and its
    // search is not exact.
    for (const char* method : {"photonmap", "shlm"}) {
        expect_success(render(cornell, method, {"--threads", "1"}));
        const common::Image one = common::read_image(path("image.exr"));
        expect_success(render(cornell, method, {"--threads", "2"}));
        const common::Image two = common::read_image(path("image.exr"));
        ASSERT_EQ(one.values.size(), two.values.size());
        EXPECT_EQ(std::memcmp(one.values.data(), two.values.data(), one.values.size() * sizeof(float)), 0)
            << method;
        expect_success(render(cornell, method, {"--seed", "2"}));
        EXPECT_NE(common::read_image(path("image.exr")).values, one.values) << method;
    }
}

/// Returns the fraction of pixels that show a surface.
double coverage(const common::Image& image) {
    double sum = 0;
    for (std::size_t p = 0; p < image.pixel_count(); ++p) sum += image.at(p, 3);
    return sum / static_cast<double>(image.pixel_count());
}

double brightest(const common::Image& image) {
    float most = 0;
    for (std::size_t p = 0; p < image.pixel_count(); ++p) most = std::max(most, image.at(p, 0));
    return most;
}

TEST_F(Render, TakesItsLightFromTheOptionsAndPlacesACamera) {
    const std::string scene = write(gltf_text::one_triangle());
    for (const char* light : {"--sky=1,1,1", "--sun=0,0,1,1,1,1"}) {
        expect_success(render(scene, "photonmap", {light, "--max-radius=0.3"}));
        const common::Image image = common::read_image(path("image.exr"));
        EXPECT_GT(coverage(image), 0.02) << light;
        EXPECT_GT(brightest(image), 0.1) << light;
    }
}

TEST_F(Render, LooksWhereItIsTold) {
    const std::string scene = write(gltf_text::one_triangle());
    const auto from = [&](const std::string& camera) {
        expect_success(render(scene, "photonmap", {"--sky=1,1,1", "--camera", camera}));
        return coverage(common::read_image(path("image.exr")));
    };
    EXPECT_EQ(from("0.2,0.2,0.1,0.2,0.2,0,20"), 1.0);
    EXPECT_EQ(from("0.2,0.2,0.1,0.2,0.2,1,20"), 0.0);
}

/// Makes a triangle that faces +z, with a bulb named 'bulb' in front of or behind it.
GltfFile lit_triangle(double z) {
    GltfFile file = gltf_text::one_triangle();
    file.document["extensionsUsed"] = {"KHR_lights_punctual"};
    file.document["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}, {"name", "bulb"}}};
    file.document["nodes"].push_back(
        {{"translation", {0.3, 0.3, z}}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    file.document["scenes"][0]["nodes"] = {0, 1};
    return file;
}

TEST_F(Render, TellsThatLightFallsOnBacks) {
    const std::string behind = write(lit_triangle(-0.05));
    for (const char* method : {"shlm", "photonmap"}) {
        const Ended ended = run(render(behind, method));
        EXPECT_EQ(ended.exit_code, 0);
        EXPECT_NE(ended.err.find("warning: light 'bulb': 100 % of its light"), std::string::npos)
            << ended.err;
        EXPECT_NE(ended.err.find("backs of single-sided surfaces"), std::string::npos) << ended.err;
        EXPECT_EQ(ended.err.find("100 % of the hits are rejected") != std::string::npos,
                  std::string(method) == "shlm")
            << ended.err;
    }
    for (const Words& words :
         {Words{"trace", behind, "--hits", "2000", "--json"}, Words{"info", behind, "--json"}}) {
        const Ended ended = run(words);
        ASSERT_EQ(ended.exit_code, 0) << ended.err;
        EXPECT_NE(Json::parse(ended.out)["warnings"].dump().find("'bulb'"), std::string::npos) << ended.out;
    }
}

TEST_F(Render, SaysNothingOfLightThatArrives) {
    expect_success(render(write(lit_triangle(0.05)), "shlm"));
}

TEST_F(Render, TellsThatLightMissesAll) {
    const Ended ended = run(render(write(lit_triangle(0.9)), "photonmap"));
    EXPECT_EQ(ended.exit_code, 0);
    EXPECT_NE(ended.err.find("'bulb'"), std::string::npos) << ended.err;
    EXPECT_NE(ended.err.find("meets no surface"), std::string::npos) << ended.err;
}

/// Makes a closed box of glTF's default colour, white, with a bulb.
GltfFile white_furnace() {
    GltfFile file = lit_triangle(0.5);
    std::vector<float> corners;
    for (int i = 0; i < 8; ++i)
        for (int axis = 0; axis < 3; ++axis) corners.push_back(static_cast<float>(i >> axis & 1));
    const std::vector<std::uint16_t> inwards = {0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3, 0, 4, 5, 0, 5, 1,
                                                2, 3, 7, 2, 7, 6, 0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5};
    file.primitive()["attributes"]["POSITION"] = file.add_accessor<float>(corners, gltf_text::f32, "VEC3");
    file.primitive()["indices"] = file.add_accessor<std::uint16_t>(inwards, gltf_text::u16, "SCALAR");
    return file;
}

TEST_F(Render, EndsWhereLightDoesNot) {
    const std::string scene = write(white_furnace());
    for (const Words& words :
         {render(scene, "photonmap"), Words{"reference", scene, "--out", path("reference.exr"), "--spp",
                                            "128", "--width", "4", "--height", "3"}}) {
        const Ended ended = run(words);
        EXPECT_EQ(ended.exit_code, 0) << ended.err;
        EXPECT_NE(ended.err.find("warning: light does not die out"), std::string::npos) << ended.err;
    }
}

TEST_F(Render, LooksWhereItIsToldInMapCoordinates) {
    GltfFile file = gltf_text::one_triangle();
    file.node()["translation"] = {500'000.5, 0, -5'600'000.25};
    const std::string scene = write(file);
    expect_success(
        render(scene, "photonmap",
               {"--sky=1,1,1", "--camera", "500000.7,0.2,-5600000.15,500000.7,0.2,-5600000.25,20"}));
    EXPECT_EQ(coverage(common::read_image(path("image.exr"))), 1.0);

    const Ended ended = run({"info", scene, "--json"});
    ASSERT_EQ(ended.exit_code, 0) << ended.err;
    const Json facts = Json::parse(ended.out);
    EXPECT_EQ(facts["bounds"][1], Json({500'001.5, 1.0, -5'600'000.25}));
    EXPECT_NEAR(facts["origin"][2].get<double>(), -5'600'000, 2);
}

// Ctrl-C.

using Interrupt = Command;

TEST_F(Interrupt, EndsARenderWithoutAnImage) {
    Child child(build_folder + "/shlmbench",
                {"render", cornell, "--method", "shlm", "--hits", "1e14", "--out", path("image.exr")},
                said.path());
    ASSERT_TRUE(child_process::wait_until([&] { return child.catches(SIGINT); }));
    child.send(SIGINT);
    const Ended ended = child.wait();
    EXPECT_EQ(ended.exit_code, 130);
    EXPECT_EQ(ended.err, "shlmbench: render stopped: no image is written\n");
    EXPECT_TRUE(files_in(folder.path()).empty());
}

}  // namespace
