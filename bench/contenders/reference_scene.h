// A scene with the points of its reference and the irradiance there.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <span>

#include "bench/contenders/contender.h"
#include "common/image/image.h"
#include "common/reference/reference_image.h"
#include "common/tracer/photon_source.h"

namespace bench {

/// Which of the camera's pixels see another point than a reference does: rounding may occasionally send a ray
/// past an edge. Throws InputError, naming both files, where more than a hundredth do: the reference belongs
/// to another camera or scene.
[[nodiscard]] std::vector<bool> pixels_elsewhere(std::span<const common::VisibleSurface> seen,
                                                 const common::reference::ReferenceImage& reference,
                                                 const common::Scene& scene, const std::string& scene_file,
                                                 const std::string& reference_file);

/// Its members refer to each other, so it is not movable.
class ReferenceScene {
  public:
    /// Throws InputError where the reference belongs to another camera or scene. A small difference of the
    /// scene only causes a warning on stderr.
    ReferenceScene(const std::filesystem::path& file, const std::filesystem::path& reference_file,
                   const SceneOptions& options, const ContenderSettings& settings);

    [[nodiscard]] const std::string& name() const { return loaded_.name; }
    [[nodiscard]] const LoadedScene& loaded() const { return loaded_; }
    [[nodiscard]] const common::PhotonSource& source() const { return source_; }
    [[nodiscard]] PreparedScene& prepared() { return prepared_; }

    /// Returns the surface points behind the reference's pixels, in image order, without pixels that see
    /// none.
    [[nodiscard]] std::span<const common::SurfacePoint> points() const { return points_; }

    /// Returns the reference's irradiance at the points, W/m^2.
    [[nodiscard]] std::span<const common::Rgb> truth() const { return truth_; }

    /// Returns the relative RMS error of the reference, which is part of every measured error.
    [[nodiscard]] double reference_error() const { return reference_error_; }

    /// Writes the reference's data at the points: reference.f32, variance.f32 (points x 3), tilt.f32 (degrees
    /// between shading and geometric normal), pixel.u32 (row by row), all little-endian, and reference.png.
    void write_reference(const std::filesystem::path& folder) const;

    /// Returns an entry for a table of results.
    [[nodiscard]] nlohmann::ordered_json facts() const;

    /// Returns the visible error of the answers per pixel (common::flip_map).
    [[nodiscard]] std::vector<float> flip(std::span<const common::Rgb> answers) const;

    /// Writes a picture of the answers, HITS.png, and one of their visible error, HITS-flip.png. Returns the
    /// mean visible error.
    double write_pictures(const std::filesystem::path& folder, std::uint64_t hits,
                          std::span<const common::Rgb> answers) const;

  private:
    /// Places the points' colours in their pixels; pixels without a point are black.
    [[nodiscard]] std::vector<common::Rgb> pixels_of(std::span<const common::Rgb> values) const;
    [[nodiscard]] common::Image image_of(std::span<const common::Rgb> pixels) const;

    LoadedScene loaded_;
    common::PhotonSource source_;
    PreparedScene prepared_;
    std::string fingerprint_;
    int width_ = 0, height_ = 0;
    bool same_version_ = false;         ///< the reference was made from exactly this scene
    std::size_t pixels_elsewhere_ = 0;  ///< number of pixels where the reference sees another point
    double reference_error_ = 0;        ///< relative, as computed by shlmbench reference
    std::vector<common::SurfacePoint> points_;
    std::vector<std::uint32_t> pixel_;  ///< of each point
    std::vector<common::Rgb> truth_, variance_;
};

/// Writes values in their memory layout. Throws InputError where that fails.
void write_binary(const std::filesystem::path& file, const void* values, std::size_t bytes);

/// Reads one answer per point from a file of write_binary. Throws InputError unless there are `points` of
/// them.
[[nodiscard]] std::vector<common::Rgb> read_answers(const std::filesystem::path& file, std::size_t points);

}  // namespace bench
