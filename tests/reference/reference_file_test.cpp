// Tests that a reference is the same on any number of threads, and when it is saved and continued.
#include "common/core/input_error.h"
#include "common/core/threads.h"
#include "common/reference/continuation.h"
#include "common/view/place_camera.h"
#include "tests/support/gltf_text.h"
#include "tests/support/reference_tracing.h"

namespace {

using namespace tests;
using namespace common::reference;
using gltf_text::TemporaryDirectory;

constexpr int width = 16, height = 9;

/// Makes a room with a panel, a lamp, a glass ball and, through the open front, some sky.
Scene room() {
    Scene scene;
    const auto walls = box_walls({-1, -1, -1}, {1, 1, 1});
    for (std::size_t i = 0; i + 1 < walls.size(); ++i) add(scene, walls[i], diffuse(Rgb(0.7f, 0.5f, 0.3f)));
    add(scene, quad({-0.3f, 0.9f, -0.3f}, {0.6f, 0, 0}, {0, 0, 0.6f}), diffuse(Rgb(0, 0, 0), Rgb(5, 4, 3)));
    add(scene, sphere({0.3f, -0.4f, 0}, 0.4f, 2), glass());
    scene.point_light.push_back({{-0.7f, 0, 0}, Rgb(1, 1, 1)});
    scene.sky = common::Sky{Rgb(0.1f, 0.2f, 0.3f)};
    return scene;
}

/// The data of a run, made again for each one, as in a newly started program.
struct View {
    Scene scene = room();
    common::RayScene rays{scene};
    Lights lights{scene};
    common::Camera camera = common::look_at({0, 0.2f, 3}, {0, 0, 0}, 1);
    std::vector<common::VisibleSurface> pixels = common::visible_surfaces(rays, camera, width, height);
    ReferenceIdentity identity{"0123456789abcdef", 7, width, height, describe(camera)};

    void add_passes(ReferenceSums& sums, std::uint64_t until) const {
        while (sums.passes < until)
            add_pass(rays, lights, pixels, identity.seed, sums, [](std::size_t) { return true; });
    }

    [[nodiscard]] ReferenceSums run(std::uint64_t passes) const {
        ReferenceSums sums(pixels.size());
        add_passes(sums, passes);
        return sums;
    }

    [[nodiscard]] common::Image image(const ReferenceSums& sums) const {
        return to_image(pixels, width, height, sums);
    }

    void write(const std::filesystem::path& file, const ReferenceSums& sums) const {
        common::write_exr(file, image(sums), continuation_notes(identity, sums), common::Precision::single);
    }
};

bool same_bits(const common::Image& a, const common::Image& b) {
    return a.channels == b.channels && a.values.size() == b.values.size() &&
           std::memcmp(a.values.data(), b.values.data(), a.values.size() * sizeof(float)) == 0;
}

TEST(ReferenceRun, IsTheSameOnAnyNumberOfThreads) {
    const auto image_on = [](int threads) {
        common::ThreadPool pool(threads);
        return pool.run([] {
            const View view;
            return view.image(view.run(3));
        });
    };
    const common::Image one = image_on(1);
    EXPECT_TRUE(same_bits(one, image_on(3)));
    View other;
    other.identity.seed = 8;
    EXPECT_FALSE(same_bits(one, other.image(other.run(3))));
}

TEST(ReferenceRun, GoesOnAsIfItHadNeverStopped) {
    const TemporaryDirectory folder;
    const auto file = folder.path() / "reference.exr";
    for (const std::uint64_t passes : {2, 3, 5}) {
        const View view;
        auto sums = sums_to_go_on_from(file, view.identity).value_or(ReferenceSums(view.pixels.size()));
        view.add_passes(sums, passes);
        view.write(file, sums);
    }
    const View view;
    const auto stopped = sums_to_go_on_from(file, view.identity);
    ASSERT_TRUE(stopped);
    EXPECT_EQ(stopped->passes, 5u);
    EXPECT_TRUE(same_bits(view.image(*stopped), view.image(view.run(5))));
}

TEST(ReferenceRun, GivenUpInAPassKeepsTheWholeOnes) {
    const View view;
    ReferenceSums sums = view.run(2);
    const common::Image before = view.image(sums);
    EXPECT_FALSE(add_pass(view.rays, view.lights, view.pixels, 7, sums, [](std::size_t) { return false; }));
    EXPECT_EQ(sums.passes, 2u);
    EXPECT_TRUE(same_bits(view.image(sums), before));
}

TEST(ReferenceRun, RelativeErrorIsThatOfItsPoints) {
    const View view;
    ReferenceSums sums(view.pixels.size());
    EXPECT_EQ(relative_error(view.pixels, sums), 0);
    // All points have the value 2 with a standard error of 0.1: 0.1 / sqrt(4 + 0.01 * 4).
    sums.passes = 2;
    for (auto& pixel : sums.pixel) pixel.fill({rounded_pair(2), rounded_pair(0.01)});
    EXPECT_NEAR(relative_error(view.pixels, sums), 0.1 / std::sqrt(4.04), 1e-6);
}

TEST(ReferenceFile, IsReadAsItWasWritten) {
    const TemporaryDirectory folder;
    const auto file = folder.path() / "reference.exr";
    const View view;
    const ReferenceSums sums = view.run(2);
    view.write(file, sums);
    const ReferenceImage read = read_reference(file);
    ASSERT_EQ(read.width, width);
    ASSERT_EQ(read.height, height);
    EXPECT_EQ(read.notes.at("shlmbench:passes"), "2");
    std::size_t present = 0;
    for (std::size_t p = 0; p < view.pixels.size(); ++p) {
        const ReferencePoint& point = read.pixel[p];
        ASSERT_EQ(point.present, view.pixels[p].present);
        if (!point.present) {
            EXPECT_EQ(point.irradiance, Rgb(0, 0, 0));
            continue;
        }
        ++present;
        EXPECT_EQ(point.position, view.pixels[p].point.position);
        EXPECT_EQ(point.normal, view.pixels[p].point.shading_normal);
        EXPECT_EQ(point.geometric_normal, view.pixels[p].point.geometric_normal);
        for (int c = 0; c < 3; ++c) {
            EXPECT_EQ(point.irradiance[c], static_cast<float>(estimate(sums, p, c)));
            EXPECT_EQ(point.variance[c], static_cast<float>(variance(sums, p, c)));
            EXPECT_GT(point.irradiance[c], 0);
        }
    }
    EXPECT_GT(present, 20u);
    EXPECT_LT(present, read.pixel.size());
}

/// Writes a reference of one pixel whose channels are all 1, after `spoil` has changed the image.
std::filesystem::path write_spoilt(const TemporaryDirectory& folder,
                                   const std::function<void(common::Image&)>& spoil) {
    const std::vector<common::VisibleSurface> pixels(1);
    common::Image image = to_image(pixels, 1, 1, ReferenceSums(1));
    std::fill(image.values.begin(), image.values.end(), 1.0f);
    spoil(image);
    common::write_exr(folder.path() / "spoilt.exr", image, {}, common::Precision::single);
    return folder.path() / "spoilt.exr";
}

std::string complaint(const std::filesystem::path& file) {
    try {
        (void)read_reference(file);
        return "";
    } catch (const common::InputError& e) {
        return e.what();
    }
}

TEST(ReferenceFile, WithoutAChannelIsNone) {
    const TemporaryDirectory folder;
    const auto rename = [](const std::string& name) {
        return [name](common::Image& image) { image.channels[*image.find_channel(name)] = "other"; };
    };
    EXPECT_EQ(complaint(write_spoilt(folder, [](common::Image&) {})), "");
    for (const char* name : {"variance.G", "irradiance.R", "normal.Z", "variance_low.B", "A"})
        EXPECT_NE(complaint(write_spoilt(folder, rename(name))).find(name), std::string::npos) << name;
}

TEST(ReferenceFile, WithNonsenseInItIsRefused) {
    const TemporaryDirectory folder;
    const auto set = [](const std::string& name, float value) {
        return [=](common::Image& image) { image.at(0, *image.find_channel(name)) = value; };
    };
    const float nan = std::numeric_limits<float>::quiet_NaN(),
                infinite = std::numeric_limits<float>::infinity();
    EXPECT_NE(complaint(write_spoilt(folder, set("position.Y", nan))).find("position.Y"), std::string::npos);
    EXPECT_NE(complaint(write_spoilt(folder, set("irradiance.B", infinite))).find("irradiance.B"),
              std::string::npos);
    EXPECT_NE(complaint(write_spoilt(folder, set("variance.R", -1))).find("variance"), std::string::npos);
    EXPECT_NE(complaint(folder.path() / "none.exr").find("none.exr"), std::string::npos);
}

}  // namespace
