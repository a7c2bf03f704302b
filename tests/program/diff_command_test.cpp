// Tests shlmbench diff from the user's point of view: what is compared, what is refused, and when it fails.
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "common/image/image.h"
#include "tests/support/command.h"

namespace {

using namespace command;
using common::Image;
using Json = nlohmann::json;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

const Words rgb = {"R", "G", "B"};
const Words all_channels = {"R", "G", "B", "A", "irradiance.R", "irradiance.G", "irradiance.B"};

/// Makes an image of 8 x 6 pixels with the same value everywhere, also in A.
Image flat(const Words& channels, float value) {
    Image image{8, 6, channels, {}};
    image.values.resize(image.pixel_count() * channels.size(), value);
    return image;
}

/// Sets one channel of all pixels to another value.
Image with(Image image, const std::string& channel, float value) {
    for (std::size_t p = 0; p < image.pixel_count(); ++p) image.at(p, *image.find_channel(channel)) = value;
    return image;
}

/// Sets one channel of one pixel to another value.
Image with(Image image, int x, int y, const std::string& channel, float value) {
    image.at(static_cast<std::size_t>(y) * image.width + x, *image.find_channel(channel)) = value;
    return image;
}

class Diff : public Command {
  protected:
    /// Compares the two images, written as image.exr and reference.exr.
    [[nodiscard]] Ended run(const Image& image, const Image& reference, const Words& more = {}) const {
        common::write_exr(path("image.exr"), image, {}, common::Precision::single);
        common::write_exr(path("reference.exr"), reference, {}, common::Precision::single);
        return run_on("image.exr", "reference.exr", more);
    }

    [[nodiscard]] Ended run_on(const std::string& image, const std::string& reference,
                               const Words& more = {}) const {
        Words words = {"diff", path(image), path(reference)};
        words.insert(words.end(), more.begin(), more.end());
        return run_command(words, said);
    }

    [[nodiscard]] Json figures(const Image& image, const Image& reference) const {
        const Ended ended = run(image, reference, {"--json"});
        EXPECT_EQ(ended.exit_code, 0) << ended.err;
        EXPECT_EQ(ended.err, "");
        return Json::parse(ended.out);
    }

    /// Expects exit code 2, no figures, no map, and one line that contains all of `fragments`.
    void expect_refusal(const Ended& ended, const Words& fragments) const {
        expect_refused(ended, fragments);
        EXPECT_FALSE(std::filesystem::exists(path("map.png")));
    }

    /// Expects a refusal despite every option that could let it pass or leave a file.
    void expect_refusal(const Image& image, const Image& reference, const Words& fragments) const {
        expect_refusal(
            run(image, reference, {"--fail-relmse", "1e300", "--flip-map", path("map.png"), "--json"}),
            fragments);
    }
};

// What is compared.

TEST_F(Diff, GivesEveryFigure) {
    const Json found = figures(with(flat(rgb, 1), 5, 2, "G", 3), flat(rgb, 1));
    EXPECT_EQ(found["image"], path("image.exr"));
    EXPECT_EQ(found["reference"], path("reference.exr"));
    EXPECT_EQ(found["layer"], "radiance");
    EXPECT_EQ(found["width"], 8);
    EXPECT_EQ(found["height"], 6);
    EXPECT_EQ(found["pixels_compared"], 48);
    EXPECT_EQ(found["pixels_left_out"], 0);
    EXPECT_TRUE(found["coverage_differs"].is_null());
    EXPECT_EQ(found["non_finite"], 0);
    EXPECT_NEAR(found["epsilon"], 0.01, 1e-8);
    EXPECT_NEAR(found["mean_image"], 1 + 2 / 144.0, 1e-9);
    EXPECT_NEAR(found["mean_reference"], 1, 1e-9);
    EXPECT_NEAR(found["relmse"], 4 / 1.01 / 144, 1e-8);
    EXPECT_NEAR(found["relative_rms"], std::sqrt(4 / 1.01 / 144), 1e-8);
    EXPECT_NEAR(found["rmse"], std::sqrt(4 / 144.0), 1e-8);
    EXPECT_NEAR(found["smape"], 4 / 4.1 / 144, 1e-8);
    EXPECT_NEAR(found["bias"], 2 / 144.0, 1e-9);
    EXPECT_NEAR(found["relative_bias"], 2 / 144.0, 1e-9);
    EXPECT_EQ(found["relative_error_p99"], 0);
    EXPECT_NEAR(found["relative_error_max"], 2 / std::sqrt(1.01), 1e-7);
    EXPECT_EQ(found["worst"], (Json{{"x", 5}, {"y", 2}, {"channel", "G"}, {"image", 3}, {"reference", 1}}));
    EXPECT_GT(found["flip"], 0);
    EXPECT_LT(found["flip"], 1);
    EXPECT_NEAR(found["flip_pixels_per_degree"], 67.02, 0.01);
    EXPECT_EQ(found["flip_exposures"]["count"], 2);
}

TEST_F(Diff, IsReadableToo) {
    const Ended ended = run(with(flat(rgb, 1), 5, 2, "G", 3), flat(rgb, 1));
    EXPECT_EQ(ended.exit_code, 0);
    EXPECT_EQ(ended.err, "");
    EXPECT_NE(ended.out.find("\nrelmse                 0.0275028\n"), std::string::npos) << ended.out;
    EXPECT_NE(ended.out.find("\nepsilon                0.01\n"), std::string::npos);
    EXPECT_NE(ended.out.find("x 5, y 2, channel G, image 3, reference 1\n"), std::string::npos);
}

TEST_F(Diff, TakesTheIrradianceWhereBothHaveIt) {
    const Image reference = flat(all_channels, 1);
    const Image image = with(with(reference, "G", 2), "irradiance.B", 4);
    const Json irradiance = figures(image, reference);
    EXPECT_EQ(irradiance["layer"], "irradiance");
    EXPECT_EQ(irradiance["worst"]["channel"], "B");
    EXPECT_EQ(irradiance["worst"]["image"], 4);

    Words fewer = all_channels;
    fewer.pop_back();
    const Json radiance = figures(image, flat(fewer, 1));
    EXPECT_EQ(radiance["layer"], "radiance");
    EXPECT_EQ(radiance["worst"]["channel"], "G");
    EXPECT_EQ(radiance["worst"]["image"], 2);
    EXPECT_EQ(figures(with(flat(fewer, 1), "G", 2), reference)["worst"]["image"], 2);
}

TEST_F(Diff, LeavesOutWhatTheReferenceDoesNotSee) {
    const Image reference = with(with(flat(all_channels, 1), 3, 2, "A", 0), 4, 2, "A", 0);
    const Image image = with(reference, 3, 2, "irradiance.R", 1000);
    const Json found = figures(image, reference);
    EXPECT_EQ(found["pixels_compared"], 46);
    EXPECT_EQ(found["pixels_left_out"], 2);
    EXPECT_EQ(found["coverage_differs"], 0);
    EXPECT_EQ(found["relmse"], 0);
    EXPECT_EQ(found["flip"], 0);

    const Json beside = figures(with(image, 5, 2, "irradiance.R", 2), reference);
    EXPECT_EQ(beside["worst"]["x"], 5);
    EXPECT_EQ(beside["worst"]["y"], 2);
    EXPECT_NEAR(beside["relmse"], 1 / 1.01 / (46 * 3), 1e-8);
}

TEST_F(Diff, CountsWhereOnlyOneHasASurface) {
    const Image full = flat(all_channels, 1), half = with(with(full, 0, 0, "A", 0), 7, 5, "A", 0);
    const Json missing = figures(half, full);
    EXPECT_EQ(missing["coverage_differs"], 2);
    EXPECT_EQ(missing["pixels_compared"], 48);
    const Json added = figures(full, half);
    EXPECT_EQ(added["coverage_differs"], 2);
    EXPECT_EQ(added["pixels_compared"], 46);
    EXPECT_TRUE(figures(flat(rgb, 1), full)["coverage_differs"].is_null());
}

TEST_F(Diff, WritesAMap) {
    const Image reference = flat(rgb, 1);
    EXPECT_EQ(run(reference, reference, {"--flip-map", path("map.png")}).exit_code, 0);
    const Image same = common::read_image(path("map.png"));
    EXPECT_EQ(same.width, 8);
    EXPECT_EQ(same.height, 6);
    EXPECT_EQ(same.at(0, 0), 0);
    EXPECT_NEAR(same.at(0, 2), 4 / 255.0, 1e-6);
    EXPECT_EQ(run(flat(rgb, 0), reference, {"--flip-map", path("map.png")}).exit_code, 0);
    EXPECT_GT(common::read_image(path("map.png")).at(0, 0), 0.9f);
}

// Positions of pixels.

/// A position in a picture, by OpenEXR's windows.
struct Place {
    int x, y;           ///< of the data window, from the display window's corner
    int width, height;  ///< of the display window
    int display_x = 0, display_y = 0;
};

/// Writes the image with these windows.
void write_at(const std::string& file, const Image& image, const Place& place) {
    OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeFloat);
    spec.channelnames = image.channels;
    spec.x = place.display_x + place.x;
    spec.y = place.display_y + place.y;
    spec.full_x = place.display_x;
    spec.full_y = place.display_y;
    spec.full_width = place.width;
    spec.full_height = place.height;
    const auto out = OIIO::ImageOutput::create(file);
    ASSERT_TRUE(out && out->open(file, spec) && out->write_image(OIIO::TypeFloat, image.values.data()) &&
                out->close());
}

/// Returns the part at (x, y) of a picture that has a different value in each pixel.
Image part_at(int x, int y, int width, int height) {
    Image image{width, height, rgb, {}};
    for (int row = y; row < y + height; ++row)
        for (int column = x; column < x + width; ++column)
            for (int c = 0; c < 3; ++c)
                image.values.push_back(static_cast<float>(1000 + 100 * row + column + 10 * c));
    return image;
}

class DiffWindows : public Diff {
  protected:
    [[nodiscard]] Json figures_of_files() const {
        const Ended ended = run_on("image.exr", "reference.exr", {"--json"});
        EXPECT_EQ(ended.exit_code, 0) << ended.err;
        return ended.exit_code == 0 ? Json::parse(ended.out) : Json();
    }
};

TEST_F(DiffWindows, TheSamePixelsElsewhereAreNotCompared) {
    const Image part = part_at(0, 0, 8, 6);
    write_at(path("image.exr"), part, {8, 6, 16, 12});
    write_at(path("reference.exr"), part, {0, 0, 16, 12});
    expect_refusal(run_on("image.exr", "reference.exr"), {"image.exr has 8 x 6 at (8, 6) of 16 x 12",
                                                          "reference.exr has 8 x 6 at (0, 0) of 16 x 12"});
    // Neither the whole picture nor another one of the part's size is comparable.
    write_at(path("reference.exr"), part_at(0, 0, 16, 12), {0, 0, 16, 12});
    expect_refusal(run_on("image.exr", "reference.exr"), {"8 x 6 at (8, 6) of 16 x 12", "has 16 x 12"});
    write_at(path("reference.exr"), part, {0, 0, 8, 6});
    expect_refusal(run_on("image.exr", "reference.exr"), {"8 x 6 at (8, 6) of 16 x 12", "has 8 x 6"});
}

TEST_F(DiffWindows, TheSamePartOfAPictureIsCompared) {
    Image other = part_at(8, 6, 8, 6);
    other.values.back() += 1;
    write_at(path("image.exr"), other, {8, 6, 16, 12});
    write_at(path("reference.exr"), part_at(8, 6, 8, 6), {8, 6, 16, 12});
    const Json found = figures_of_files();
    EXPECT_EQ(found["worst"]["x"], 15);
    EXPECT_EQ(found["worst"]["y"], 11);
    EXPECT_EQ(found["width"], 8);
    // The picture's own origin does not matter.
    write_at(path("image.exr"), part_at(8, 6, 8, 6), {8, 6, 16, 12, -100, 50});
    EXPECT_EQ(figures_of_files()["relmse"], 0);
}

TEST_F(DiffWindows, WhatLiesBesideThePictureIsLeftOut) {
    write_at(path("image.exr"), part_at(-2, -3, 13, 11), {-2, -3, 8, 6});
    write_at(path("reference.exr"), part_at(0, 0, 8, 6), {0, 0, 8, 6});
    for (int turn = 0; turn < 2; ++turn) {
        const Json found = figures_of_files();
        EXPECT_EQ(found["relmse"], 0);
        EXPECT_EQ(found["pixels_compared"], 48);
        fs::rename(path("image.exr"), path("swapped.exr"));
        fs::rename(path("reference.exr"), path("image.exr"));
        fs::rename(path("swapped.exr"), path("reference.exr"));
    }
    write_at(path("image.exr"), part_at(20, 0, 8, 6), {20, 0, 8, 6});
    expect_refusal(run_on("image.exr", "reference.exr"), {"image.exr: no pixel lies in the picture"});
}

TEST_F(DiffWindows, APlaceThatIsNotFiniteIsOneOfThePicture) {
    write_at(path("image.exr"), with(part_at(4, 2, 8, 6), 1, 1, "G", nan), {4, 2, 16, 12});
    write_at(path("reference.exr"), part_at(4, 2, 8, 6), {4, 2, 16, 12});
    expect_refusal(run_on("image.exr", "reference.exr"), {"the first of them (5, 3)"});
}

// What is refused.

TEST_F(Diff, RefusesDifferentSizes) {
    Image wide = flat(rgb, 1);
    std::swap(wide.width, wide.height);
    expect_refusal(wide, flat(rgb, 1), {"image.exr has 6 x 8", "reference.exr has 8 x 6"});
}

TEST_F(Diff, RefusesImagesWithoutACommonLayer) {
    const Words irradiance = {"irradiance.R", "irradiance.G", "irradiance.B"};
    expect_refusal(flat(rgb, 1), flat(irradiance, 1),
                   {"image.exr has R,G,B", "reference.exr has irradiance.R,irradiance.G,irradiance.B"});
    expect_refusal(flat({"Y"}, 1), flat(rgb, 1), {"image.exr has Y", "reference.exr has R,G,B"});
}

TEST_F(Diff, RefusesWhatIsNotFinite) {
    const Image good = flat(all_channels, 1);
    const std::string count = ": 2 of 48 pixels are not finite, the first of them (6, 3)";
    for (const float value : {nan, infinity, -infinity}) {
        const Image bad = with(with(good, 6, 3, "irradiance.G", value), 1, 4, "irradiance.B", value);
        expect_refusal(bad, good, {path("image.exr") + count});
        expect_refusal(good, bad, {path("reference.exr") + count});
    }
    const Image bad = with(with(good, 6, 3, "irradiance.G", nan), 1, 4, "irradiance.B", infinity);
    expect_refusal(bad, bad, {path("image.exr") + count, path("reference.exr") + count});
    expect_refusal(with(good, 0, 0, "A", nan), good, {"image.exr: 1 of 48", "(0, 0)"});
    expect_refusal(good, with(good, 0, 0, "A", nan), {"reference.exr: 1 of 48", "(0, 0)"});
}

TEST_F(Diff, NeverPassesAnImageOfNaNs) {
    expect_refusal(flat(rgb, nan), flat(rgb, 1), {"image.exr: 48 of 48 pixels are not finite"});
    expect_refusal(flat(rgb, nan), flat(rgb, nan), {"image.exr: 48 of 48", "reference.exr: 48 of 48"});
    expect_refusal(flat(rgb, 1), flat(rgb, nan), {"reference.exr: 48 of 48 pixels are not finite"});
    expect_refusal(flat(all_channels, nan), flat(all_channels, nan), {"48 of 48"});
}

TEST_F(Diff, RefusesAReferenceThatIsNoMeasure) {
    expect_refusal(flat(rgb, 1), flat(rgb, 0), {"reference.exr", "mean of the reference is 0"});
    expect_refusal(flat(rgb, 0), flat(rgb, 0), {"reference.exr", "mean of the reference is 0"});
    expect_refusal(flat(rgb, 1), flat(rgb, -1), {"reference.exr", "black"});
    expect_refusal(flat(all_channels, 1), with(flat(all_channels, 1), "A", 0), {"reference.exr", "no pixel"});
}

TEST_F(Diff, RefusesAReferenceThatLacksLightWhichTheImageMayHave) {
    const common::ImageNotes lacks = {{"shlmbench:paths_not_found", "light of 1 point lights"}};
    const Image image = flat(rgb, 1);
    common::write_exr(path("image.exr"), image, {});
    common::write_exr(path("reference.exr"), image, lacks);
    expect_refusal(run_on("image.exr", "reference.exr"), {"reference.exr", "light of 1 point lights"});
    // A reference that lacks the same light is comparable.
    common::write_exr(path("image.exr"), image, lacks);
    EXPECT_EQ(run_on("image.exr", "reference.exr").exit_code, 0);
    common::write_exr(path("reference.exr"), image, {{"shlmbench:paths_not_found", "none"}});
    EXPECT_EQ(run_on("image.exr", "reference.exr").exit_code, 0);
}

TEST_F(Diff, RefusesFilesThatAreNoLinearImages) {
    const Image good = flat(rgb, 1);
    common::write_exr(path("good.exr"), good, {});
    folder.write("text.exr", "no image");
    const std::string whole = child_process::text_of(path("good.exr"));
    folder.write("cut.exr", whole.substr(0, whole.size() - 10));
    common::write_png(path("picture.png"), good, 1);
    for (const char* name : {"missing.exr", "text.exr", "cut.exr"}) {
        expect_refusal(run_on(name, "good.exr"), {name, "cannot be read"});
        expect_refusal(run_on("good.exr", name), {name, "cannot be read"});
    }
    expect_refusal(run_on("picture.png", "good.exr"), {"picture.png: holds display colours"});
    expect_refusal(run_on("good.exr", "picture.png"), {"picture.png: holds display colours"});
}

TEST_F(Diff, RefusesBadOptions) {
    const Image good = flat(rgb, 1);
    for (const char* bound : {"nan", "inf", "-1", "1e400", "little"})
        expect_refusal(run(good, good, {std::string("--fail-relmse=") + bound}), {"--fail-relmse"});
    expect_refusal(run(good, good, {"--flip-map", path("map.exr")}), {"--flip-map", ".png"});
    expect_refusal(run(good, good, {"--flip-map", path("missing/map.png")}), {"missing/map.png"});
    expect_refusal(run(good, good, {"--colour"}), {"--colour"});
    EXPECT_FALSE(std::filesystem::exists(path("map.exr")));
}

// When it fails.

TEST_F(Diff, FailsBeyondTheBound) {
    const Image image = flat(rgb, 1.1f), reference = flat(rgb, 1);
    const double relmse = std::pow(1.1f - 1, 2) / 1.01;  // 0.0099
    EXPECT_EQ(run(image, reference, {"--fail-relmse", std::to_string(1.01 * relmse)}).exit_code, 0);
    const std::string bound = std::to_string(0.99 * relmse);
    const Ended ended =
        run(image, reference, {"--fail-relmse", bound, "--flip-map", path("map.png"), "--json"});
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_NEAR(Json::parse(ended.out)["relmse"], relmse, 1e-8);
    EXPECT_EQ(ended.err, fmt::format("shlmbench: {}: relMSE {:g} is more than {:g}\n", path("image.exr"),
                                     relmse, std::stod(bound)));
    EXPECT_TRUE(std::filesystem::exists(path("map.png")));
    EXPECT_EQ(run(image, reference).exit_code, 0) << "no bound";
}

TEST_F(Diff, PassesWithABoundOfNothingOnlyWhatIsTheSame) {
    const Image reference = flat(rgb, 1);
    EXPECT_EQ(run(reference, reference, {"--fail-relmse", "0"}).exit_code, 0);
    EXPECT_EQ(run(with(reference, 7, 5, "B", std::nextafter(1.0f, 2.0f)), reference, {"--fail-relmse", "0"})
                  .exit_code,
              1);
}

TEST_F(Diff, FindsAForgottenFactor) {
    const Image reference = flat(all_channels, 1);
    for (const float factor : {2.0f, 0.5f, 3.14159265f, 0.318309886f}) {
        Image image = reference;
        for (const char* channel : {"irradiance.R", "irradiance.G", "irradiance.B"})
            image = with(image, channel, factor);
        const Json found = figures(image, reference);
        EXPECT_NEAR(found["relmse"], std::pow(factor - 1, 2) / 1.01, 1e-6);
        EXPECT_NEAR(found["relative_bias"], factor - 1, 1e-6);
        EXPECT_EQ(run(image, reference, {"--fail-relmse", "0.1"}).exit_code, 1);
    }
}

}  // namespace
