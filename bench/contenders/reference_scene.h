// A scene with the points that its reference has, and what the answers there should be.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <span>

#include "bench/contenders/contender.h"
#include "common/image/image.h"
#include "common/tracer/photon_source.h"

namespace bench {

/// Its parts point at each other, so it stays where it is.
class ReferenceScene {
  public:
    /// Throws InputError where the reference is of another camera or scene; a small difference in the scene
    /// only brings a warning on stderr.
    ReferenceScene(const std::filesystem::path& file, const std::filesystem::path& reference_file,
                   const SceneOptions& options, const ContenderSettings& settings);

    [[nodiscard]] const std::string& name() const { return loaded_.name; }
    [[nodiscard]] const LoadedScene& loaded() const { return loaded_; }
    [[nodiscard]] const common::PhotonSource& source() const { return source_; }
    [[nodiscard]] PreparedScene& prepared() { return prepared_; }

    /// Surface points behind the reference's pixels, in image order, without pixels that see none.
    [[nodiscard]] std::span<const common::SurfacePoint> points() const { return points_; }

    /// The reference's irradiance at the points, W/m^2.
    [[nodiscard]] std::span<const common::Rgb> truth() const { return truth_; }

    /// Of the reference, relative RMS: what a measured error owes to it.
    [[nodiscard]] double reference_error() const { return reference_error_; }

    /// Writes what the reference says of the points: reference.f32, variance.f32 (points x 3), tilt.f32
    /// (degrees between shading and geometric normal), pixel.u32 (row by row), little-endian, and
    /// reference.png.
    void write_reference(const std::filesystem::path& folder) const;

    /// An entry for a table of results.
    [[nodiscard]] nlohmann::ordered_json facts() const;

    /// What a viewer sees of the answers' error, pixel by pixel (common::flip_map).
    [[nodiscard]] std::vector<float> flip(std::span<const common::Rgb> answers) const;

    /// Writes the picture of some answers, HITS.png, and what a viewer sees of their error, HITS-flip.png.
    /// Returns the mean of the latter.
    double write_pictures(const std::filesystem::path& folder, std::uint64_t hits,
                          std::span<const common::Rgb> answers) const;

  private:
    /// Colours of points where their pixels are; pixels without a point are black.
    [[nodiscard]] std::vector<common::Rgb> pixels_of(std::span<const common::Rgb> values) const;
    [[nodiscard]] common::Image image_of(std::span<const common::Rgb> pixels) const;

    LoadedScene loaded_;
    common::PhotonSource source_;
    PreparedScene prepared_;
    std::string fingerprint_;
    int width_ = 0, height_ = 0;
    bool same_version_ = false;         ///< the reference was made from exactly this scene
    std::size_t pixels_elsewhere_ = 0;  ///< where the reference looks at another point
    double reference_error_ = 0;        ///< relative, as shlmbench reference has it
    std::vector<common::SurfacePoint> points_;
    std::vector<std::uint32_t> pixel_;  ///< of each point
    std::vector<common::Rgb> truth_, variance_;
};

/// Writes values as they lie in memory. Throws InputError where that fails.
void write_binary(const std::filesystem::path& file, const void* values, std::size_t bytes);

/// What write_binary wrote of an answer per point. Throws InputError unless there are `points` of them.
[[nodiscard]] std::vector<common::Rgb> read_answers(const std::filesystem::path& file, std::size_t points);

}  // namespace bench
