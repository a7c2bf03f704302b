#include "bench/contenders/reference_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "bench/setup/output_folder.h"
#include "common/core/input_error.h"
#include "common/core/output_file.h"
#include "common/core/standard_streams.h"
#include "common/difference/error_map.h"
#include "common/difference/error_metrics.h"
#include "common/difference/flip.h"
#include "common/reference/paths_not_found.h"
#include "common/reference/reference_image.h"
#include "common/scene/fingerprint.h"
#include "common/view/visible_surfaces.h"

namespace bench {
namespace {

namespace fs = std::filesystem;
using common::Rgb;

static_assert(std::endian::native == std::endian::little, "raw files are little-endian");

float degrees_between(const common::Vec3& a, const common::Vec3& b) {
    return std::acos(std::clamp(a.dot(b), -1.0f, 1.0f)) * 180 / std::numbers::pi_v<float>;
}

}  // namespace

std::vector<bool> pixels_elsewhere(std::span<const common::VisibleSurface> seen,
                                   const common::reference::ReferenceImage& reference,
                                   const common::Scene& scene, const std::string& scene_file,
                                   const std::string& reference_file) {
    const float tolerance = 1e-4f * scene.diagonal();
    std::vector<bool> elsewhere;
    for (std::size_t p = 0; p < seen.size(); ++p) {
        const common::reference::ReferencePoint& known = reference.pixel[p];
        elsewhere.push_back(
            seen[p].present != known.present ||
            (seen[p].present && (seen[p].point.position - known.position).length() > tolerance));
    }
    if (100 * static_cast<std::size_t>(std::count(elsewhere.begin(), elsewhere.end(), true)) > seen.size())
        throw common::InputError(fmt::format("{}: looks at other points than {}: another scene or camera",
                                             reference_file, scene_file));
    return elsewhere;
}

void write_binary(const fs::path& file, const void* values, std::size_t bytes) {
    common::write_whole_file(file, {static_cast<const std::byte*>(values), bytes});
}

std::vector<Rgb> read_answers(const fs::path& file, std::size_t points) {
    std::vector<Rgb> answers(points);
    std::ifstream in(file, std::ios::binary);
    in.read(reinterpret_cast<char*>(answers.data()), static_cast<std::streamsize>(points * sizeof(Rgb)));
    if (!in || in.peek() != std::ifstream::traits_type::eof())
        throw common::InputError(fmt::format("{}: does not hold {} answers", file.string(), points));
    return answers;
}

ReferenceScene::ReferenceScene(const fs::path& file, const fs::path& reference_file,
                               const SceneOptions& options, const ContenderSettings& settings)
    : loaded_(file.string(), options),
      source_(loaded_.rays, settings.emission),
      prepared_(loaded_, settings),
      fingerprint_(common::fingerprint(loaded_.scene)) {
    const auto reference = common::reference::read_reference(reference_file);
    if (const std::string lost = common::reference::paths_not_found(reference.notes); !lost.empty())
        throw common::InputError(fmt::format("{}: no measure for photons, which find what it lacks: {}",
                                             reference_file.string(), lost));
    width_ = reference.width;
    height_ = reference.height;
    const auto seen = common::visible_surfaces(loaded_.rays, loaded_.camera, width_, height_);
    const std::vector<bool> elsewhere =
        pixels_elsewhere(seen, reference, loaded_.scene, file.string(), reference_file.string());
    for (std::uint32_t p = 0; p < seen.size(); ++p) {
        if (elsewhere[p]) {
            ++pixels_elsewhere_;
        } else if (seen[p].present) {
            points_.push_back(seen[p].point);
            pixel_.push_back(p);
            truth_.push_back(reference.pixel[p].irradiance);
            variance_.push_back(reference.pixel[p].variance);
        }
    }
    const auto note = reference.notes.find("shlmbench:fingerprint");
    same_version_ = note != reference.notes.end() && note->second == fingerprint_;
    if (!same_version_)
        common::say(fmt::format("{}: warning: {} was made from another version of the scene", name(),
                                reference_file.string()));
    if (points_.empty())
        throw common::InputError(fmt::format("{}: shows no surface", reference_file.string()));
    const double epsilon = common::relative_epsilon(truth_);
    for (std::size_t i = 0; i < truth_.size(); ++i)
        for (int c = 0; c < 3; ++c)
            reference_error_ += variance_[i][c] / (double{truth_[i][c]} * truth_[i][c] + epsilon);
    reference_error_ = std::sqrt(reference_error_ / (3.0 * static_cast<double>(truth_.size())));
}

std::vector<Rgb> ReferenceScene::pixels_of(std::span<const Rgb> values) const {
    std::vector<Rgb> pixels(static_cast<std::size_t>(width_) * height_, Rgb(0, 0, 0));
    for (std::size_t i = 0; i < values.size(); ++i) pixels[pixel_[i]] = values[i];
    return pixels;
}

common::Image ReferenceScene::image_of(std::span<const Rgb> pixels) const {
    common::Image image{width_, height_, {"R", "G", "B"}, {}};
    for (const Rgb& pixel : pixels) image.values.insert(image.values.end(), {pixel.x, pixel.y, pixel.z});
    return image;
}

void ReferenceScene::write_reference(const fs::path& folder) const {
    std::vector<float> tilt;
    for (const common::SurfacePoint& point : points_)
        tilt.push_back(degrees_between(point.shading_normal, point.geometric_normal));
    prepare_output_folder("--out", folder);
    write_binary(folder / "reference.f32", truth_.data(), truth_.size() * sizeof(Rgb));
    write_binary(folder / "variance.f32", variance_.data(), variance_.size() * sizeof(Rgb));
    write_binary(folder / "tilt.f32", tilt.data(), tilt.size() * sizeof(float));
    write_binary(folder / "pixel.u32", pixel_.data(), pixel_.size() * sizeof(std::uint32_t));
    const common::Image image = image_of(pixels_of(truth_));
    common::write_png(folder / "reference.png", image, common::middle_grey_exposure(image));
}

nlohmann::ordered_json ReferenceScene::facts() const {
    return {{"file", loaded_.scene.source},
            {"fingerprint", fingerprint_},
            {"triangles", loaded_.scene.triangle.size()},
            {"points", points_.size()},
            {"pixels_left_out", pixels_elsewhere_},
            {"reference_of_same_version", same_version_},
            {"width", width_},
            {"height", height_},
            {"raw", "raw/" + name()},
            {"reference_error", reference_error_}};
}

std::vector<float> ReferenceScene::flip(std::span<const Rgb> answers) const {
    return common::flip_map(pixels_of(answers), pixels_of(truth_), width_, height_,
                            common::exposures_for(truth_));
}

double ReferenceScene::write_pictures(const fs::path& folder, std::uint64_t hits,
                                      std::span<const Rgb> answers) const {
    const std::vector<float> seen = flip(answers);
    common::write_png(folder / fmt::format("{}.png", hits), image_of(pixels_of(answers)),
                      common::middle_grey_exposure(image_of(pixels_of(truth_))));
    common::write_flip_map(folder / fmt::format("{}-flip.png", hits), width_, height_, seen);
    return common::flip_mean(seen);
}

}  // namespace bench
