// Names of methods: what they mean, and what is said of names that mean nothing.
#include "bench/app/method.h"

#include <gtest/gtest.h>

#include "common/core/input_error.h"

namespace {

std::string full_name(const std::string& name) {
    return bench::parse_method("--methods", name).name;
}

std::string complaint(const std::string& name) {
    try {
        (void)bench::parse_method("--methods", name);
    } catch (const common::InputError& e) {
        return e.what();
    }
    return "";
}

TEST(MethodName, TakesDefaultsForWhatIsLeftOut) {
    EXPECT_EQ(full_name("shlm"), "shlm/L2/radiance/surface4");
    EXPECT_EQ(full_name("shlm/L1"), "shlm/L1/radiance/surface4");
    EXPECT_EQ(full_name("shlm/L2/flux"), "shlm/L2/flux/surface4");
    EXPECT_EQ(full_name("photonmap"), "photonmap/flann/k50/disc");
    EXPECT_EQ(full_name("photonmap/flann-incremental"), "photonmap/flann-incremental/k50/disc");
    EXPECT_EQ(full_name("photonmap/nanoflann"), "photonmap/nanoflann/k50/disc");
    EXPECT_EQ(full_name("photonmap/grid"), "photonmap/grid/r0.003/disc");
    EXPECT_EQ(full_name("photonmap/compact"), "photonmap/compact/k50/disc");
}

TEST(MethodName, StaysAsItIsWhereItIsFull) {
    for (const char* name :
         {"shlm/L0/normalised/own", "shlm/L4/radiance/bilinear", "shlm/L2/radiance/knn8/t65536", "shlm/L2/radiance/surface8/t65536",
          "shlm/L2/radiance/own/h0", "shlm/L2/radiance/bilinear/t64/h28", "shlm/L2/radiance/knn4/face",
          "shlm/L2/radiance/knn4/uv/t64/h0", "shlm/H4/radiance/own", "shlm/YL2/radiance/own/half",
          "shlm/a2.5/normalised/own/face/t64", "shlm/a2/normalised/bilinear",
          "shlm/L0/normalised/own/uv/t64/h0/half", "photonmap/flann/k200/cone",
          "photonmap/flann/k0.05n23/epanechnikov", "photonmap/flann/r0.003/disc",
          "photonmap/nanoflann/k0.05n23/cone", "photonmap/compact/k50/cone", "photonmap/grid/r0.01/cone"})
        EXPECT_EQ(full_name(name), name);
}

TEST(MethodName, SaysWhatAMethodIs) {
    const bench::Method light_map = bench::parse_method("", "shlm/L1/normalised/knn8/t4096");
    ASSERT_NE(light_map.light_map(), nullptr);
    EXPECT_EQ(light_map.light_map()->basis, bench::LightBasis::L1);
    EXPECT_EQ(light_map.light_map()->weight, shlm::ShWeight::normalised);
    EXPECT_EQ(std::get<shlm::NearestTexels>(light_map.light_map()->gather).count, 8u);
    EXPECT_EQ(light_map.light_map()->texels, 4096u);
    EXPECT_FALSE(light_map.light_map()->placement.has_value()) << "as --texels says";
    EXPECT_EQ(bench::parse_method("", "shlm/L2/radiance/knn4/face").light_map()->placement,
              shlm::TexelPlacement::face);

    const bench::Method photon_map = bench::parse_method("", "photonmap/flann/r0.01/cone");
    ASSERT_NE(photon_map.photon_map(), nullptr);
    EXPECT_EQ(std::get<photonmap::FixedRadius>(photon_map.photon_map()->selection).diagonal_fraction, 0.01);
    EXPECT_EQ(photon_map.photon_map()->kernel, photonmap::Kernel::cone);
}

TEST(MethodName, OneStoreServesMethodsThatAskItDifferently) {
    const auto alike = [](const char* a, const char* b) {
        return bench::fill_alike(bench::parse_method("", a), bench::parse_method("", b));
    };
    EXPECT_TRUE(alike("shlm/L2/radiance/knn4", "shlm/L2/radiance/own"));
    EXPECT_FALSE(alike("shlm/L2/radiance/knn4", "shlm/L1/radiance/knn4"));
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

TEST(MethodName, EveryComplaintNamesTheOptionAndTheChoices) {
    for (const auto& [name, words] : std::initializer_list<std::pair<const char*, std::vector<const char*>>>{
             {"", {"shlm", "photonmap"}},
             {"oak", {"'oak'", "shlm", "photonmap"}},
             {"shlm/L3", {"'L3'", "L0", "L1", "L2", "L4"}},
             {"shlm/L2/power", {"'power'", "radiance", "flux", "normalised"}},
             {"shlm/L2/radiance/knn0", {"'knn0'", "own", "bilinear", "surfaceK", "knnK"}},
             {"shlm/L2/radiance/knn4x", {"'knn4x'"}},
             {"shlm/L2/radiance/own/65536", {"'65536'", "uv", "face", "t65536"}},
             {"shlm/L2/radiance/own/t64/face", {"'face'"}},
             {"shlm/L2/radiance/own/t0", {"'t0'"}},
             {"shlm/L2/radiance/own/t64/", {"''", "h0"}},
             {"shlm/L2/radiance/own/h-1", {"'h-1'", "h0"}},
             {"shlm/L2/radiance/own/h50/t64", {"'t64'", "in this order"}},
             {"shlm/H4/flux", {"'flux'", "radiance, the only weight that H4 has"}},
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
