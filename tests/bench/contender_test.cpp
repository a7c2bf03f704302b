// Tests the parsing of methods' names and the errors for invalid names.
#include "bench/contenders/contender.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "bench/contenders/family.h"
#include "bench/contenders/light_map.h"
#include "bench/contenders/photon_map.h"
#include "common/core/input_error.h"

namespace {

std::string full_name(const std::string& name) {
    return bench::parse_contender("--methods", name).name;
}

std::string complaint(const std::string& name) {
    try {
        (void)bench::parse_contender("--methods", name);
    } catch (const common::InputError& e) {
        return e.what();
    }
    return "";
}

TEST(ContenderName, TakesDefaultsForWhatIsLeftOut) {
    EXPECT_EQ(full_name("shlm"), "shlm/L2/radiance/surface4");
    EXPECT_EQ(full_name("shlm/F1"), "shlm/F1/radiance/surface4");
    EXPECT_EQ(full_name("shlm/L2/flux"), "shlm/L2/flux/surface4");
    EXPECT_EQ(full_name("photonmap"), "photonmap/flann/k50/disc");
    EXPECT_EQ(full_name("photonmap/flann-incremental"), "photonmap/flann-incremental/k50/disc");
    EXPECT_EQ(full_name("photonmap/nanoflann"), "photonmap/nanoflann/k50/disc");
    EXPECT_EQ(full_name("photonmap/grid"), "photonmap/grid/r0.003/disc");
    EXPECT_EQ(full_name("photonmap/compact"), "photonmap/compact/k50/disc");
}

TEST(ContenderName, StaysAsItIsWhereItIsFull) {
    for (const char* name :
         {"shlm/L0/normalised/own", "shlm/L4/radiance/bilinear", "shlm/L2/radiance/knn8/t65536",
          "shlm/L2/radiance/surface8/t65536", "shlm/L2/radiance/own/h0", "shlm/L2/radiance/bilinear/t64/h28",
          "shlm/L2/radiance/knn4/face", "shlm/L2/radiance/knn4/uv/t64/h0", "shlm/F1/radiance/own",
          "shlm/YF2/radiance/own/half", "shlm/a2.5/normalised/own/face/t64", "shlm/a2/normalised/bilinear",
          "shlm/L0/normalised/own/uv/t64/h0/half", "photonmap/flann/k200/cone",
          "photonmap/flann/k0.05n23/epanechnikov", "photonmap/flann/r0.003/disc",
          "photonmap/nanoflann/k0.05n23/cone", "photonmap/compact/k50/cone", "photonmap/grid/r0.01/cone"})
        EXPECT_EQ(full_name(name), name);
}

TEST(ContenderName, SaysWhatAContenderIs) {
    const bench::Contender light_map = bench::parse_contender("", "shlm/L4/normalised/knn8/t4096");
    ASSERT_NE(light_map.light_map(), nullptr);
    const bench::TexelSetting& setting = light_map.light_map()->setting();
    EXPECT_EQ(setting.basis->name, "L4");
    EXPECT_EQ(setting.weight, shlm::ShWeight::normalised);
    EXPECT_EQ(std::get<shlm::NearestTexels>(setting.gather).count, 8u);
    EXPECT_EQ(setting.texels, 4096u);
    EXPECT_FALSE(setting.placement.has_value()) << "as --texels says";
    EXPECT_EQ(bench::parse_contender("", "shlm/L2/radiance/knn4/face").light_map()->setting().placement,
              shlm::TexelPlacement::face);
    EXPECT_EQ(light_map.photon_map(), nullptr);

    const bench::Contender photon_map = bench::parse_contender("", "photonmap/flann/r0.01/cone");
    ASSERT_NE(photon_map.photon_map(), nullptr);
    EXPECT_EQ(std::get<photonmap::FixedRadius>(photon_map.photon_map()->selection()).diagonal_fraction, 0.01);
    EXPECT_EQ(photon_map.photon_map()->kernel(), photonmap::Kernel::cone);
    EXPECT_EQ(photon_map.light_map(), nullptr);
}

TEST(ContenderFields, SayWhatTheNameSays) {
    using Json = nlohmann::ordered_json;
    const auto fields = [](const char* name) { return bench::parse_contender("", name)->fields(); };
    EXPECT_EQ(fields("shlm"), (Json{{"family", "shlm"},
                                    {"basis", "L2"},
                                    {"weight", "radiance"},
                                    {"gather", "surface4"},
                                    {"summed_order", 2},
                                    {"least_hits", 100},
                                    {"half", false}}));
    EXPECT_EQ(fields("shlm/AD/radiance/own/face/t64/h0/half"), (Json{{"family", "shlm"},
                                                                     {"basis", "AD"},
                                                                     {"weight", "radiance"},
                                                                     {"gather", "own"},
                                                                     {"placement", "face"},
                                                                     {"texels", 64},
                                                                     {"summed_order", 1},
                                                                     {"least_hits", 0},
                                                                     {"half", true}}));
    EXPECT_EQ(fields("shlm/a5"), (Json{{"family", "shlm"},
                                       {"basis", "adaptive"},
                                       {"wanted_error_percent", 5.0},
                                       {"weight", "normalised"},
                                       {"gather", "bilinear"},
                                       {"summed_order", 2}}));
    EXPECT_EQ(fields("photonmap/compact/k0.1n23/cone"), (Json{{"family", "photonmap"},
                                                              {"engine", "compact"},
                                                              {"selection", "k0.1n23"},
                                                              {"kernel", "cone"},
                                                              {"growing_factor", 0.1}}));
    EXPECT_EQ(fields("photonmap")["nearest"], 50);
    EXPECT_EQ(fields("photonmap/grid")["diagonal_fraction"], 0.003);
}

TEST(Families, ListWhatTheyHaveByNamesOfTheirOwn) {
    ASSERT_EQ(bench::all_families().size(), 2u);
    std::set<std::pair<std::string, std::string>> styles;
    for (const auto& [name, family] : bench::all_families()) {
        EXPECT_FALSE(family.fields().empty()) << name;
        for (const std::string& short_name : family.names()) {
            const bench::Contender contender = bench::parse_contender("", short_name);
            EXPECT_TRUE(contender.name.starts_with(short_name)) << contender.name;
            EXPECT_EQ(full_name(contender.name), contender.name);
            const bench::ChartStyle style = contender->style();
            EXPECT_EQ(style.colour.size(), 7u) << contender.name;
            EXPECT_TRUE(styles.emplace(style.colour, style.marker).second) << contender.name;
        }
    }
    EXPECT_EQ(styles.size(), 5u + 10u);
}

TEST(ContenderName, OneStoreServesContendersThatAskItDifferently) {
    const auto alike = [](const char* a, const char* b) {
        return bench::share_store(bench::parse_contender("", a), bench::parse_contender("", b));
    };
    EXPECT_TRUE(alike("shlm/L2/radiance/knn4", "shlm/L2/radiance/own"));
    EXPECT_FALSE(alike("shlm/L2/radiance/knn4", "shlm/F1/radiance/knn4"));
    EXPECT_FALSE(alike("shlm/L2/radiance/knn4", "shlm/L2/flux/knn4"));
    EXPECT_FALSE(alike("shlm/L2/radiance/knn4", "shlm/L2/radiance/knn4/t64"));
    EXPECT_FALSE(alike("shlm/L2/radiance/knn4", "shlm/L2/radiance/knn4/face"));
    EXPECT_TRUE(alike("photonmap/flann/k50/disc", "photonmap/flann/r0.01/cone"));
    EXPECT_FALSE(alike("photonmap/flann", "photonmap/flann-incremental"));
    EXPECT_FALSE(alike("photonmap/flann", "photonmap/nanoflann"));
    EXPECT_TRUE(alike("photonmap/grid/r0.01/disc", "photonmap/grid/r0.01/cone"));
    EXPECT_FALSE(alike("photonmap/grid/r0.01", "photonmap/grid/r0.02")) << "a grid is made for its radius";
    EXPECT_FALSE(alike("photonmap/flann", "photonmap/compact"));
    EXPECT_FALSE(alike("photonmap", "shlm"));
}

TEST(ContenderName, EveryComplaintNamesTheOptionAndTheChoices) {
    for (const auto& [name, words] : std::initializer_list<std::pair<const char*, std::vector<const char*>>>{
             {"", {"shlm", "photonmap"}},
             {"oak", {"'oak'", "shlm", "photonmap"}},
             {"shlm/L3", {"'L3'", "L0", "L2", "L4", "F2"}},
             {"shlm/L2/power", {"'power'", "radiance", "flux", "normalised"}},
             {"shlm/L2/radiance/knn0", {"'knn0'", "own", "bilinear", "surfaceK", "knnK"}},
             {"shlm/L2/radiance/knn4x", {"'knn4x'"}},
             {"shlm/L2/radiance/own/65536", {"'65536'", "uv", "face", "t65536"}},
             {"shlm/L2/radiance/own/t64/face", {"'face'"}},
             {"shlm/L2/radiance/own/t0", {"'t0'"}},
             {"shlm/L2/radiance/own/t64/", {"''", "h0"}},
             {"shlm/L2/radiance/own/h-1", {"'h-1'", "h0"}},
             {"shlm/L2/radiance/own/h50/t64", {"'t64'", "in this order"}},
             {"shlm/F2/flux", {"'flux'", "radiance, the only weight that F2 has"}},
             {"shlm/a0", {"'a0'", "L2"}},
             {"shlm/a2/radiance", {"'radiance'", "normalised"}},
             {"shlm/a2/normalised/knn4", {"'knn4'", "bilinear or own"}},
             {"shlm/a2/normalised/own/h5", {"'h5'", "t65536"}},
             {"photonmap/oak", {"'oak'", "flann", "flann-incremental", "compact"}},
             {"photonmap/flann/k1", {"'k1'", "one photon has no density"}},
             {"photonmap/flann/k2.5", {"'k2.5'"}},
             {"photonmap/flann/k2n23", {"'k2n23'", "kCn23"}},
             {"photonmap/flann/k-1n23", {"'k-1n23'"}},
             {"photonmap/flann/r0", {"'r0'", "rF"}},
             {"photonmap/flann/rnan", {"'rnan'"}},
             {"photonmap/oak", {"nanoflann", "grid"}},
             {"photonmap/grid/k50", {"'k50'", "a grid knows no other selection"}},
             {"photonmap/grid/k0.1n23", {"'k0.1n23'", "a grid knows no other selection"}},
             {"photonmap/grid/r2", {"'r2'", "from 1e-6 to 1"}},
             {"photonmap/flann/k50/gauss", {"'gauss'", "disc", "cone", "epanechnikov"}},
             {"photonmap/flann/k50/disc/t64", {"'t64'", "expected after a whole name"}}}) {
        const std::string line = complaint(name);
        EXPECT_TRUE(line.starts_with("--methods: ")) << name << ": " << line;
        for (const char* word : words) EXPECT_NE(line.find(word), std::string::npos) << word << ": " << line;
    }
}

}  // namespace
