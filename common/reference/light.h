// The kinds of light that a point of a surface can be joined to by a straight line.
#pragma once

#include <array>
#include <memory>
#include <variant>

#include "common/reference/bright_places.h"
#include "common/scene/surface_point.h"

namespace common::reference {

/// A triangle that emits with a cosine lobe, from its front or from both faces.
struct AreaLight {
    std::uint32_t triangle;
    bool both_faces;
    double area;
    double mean_radiance;  ///< over triangle, holes and channels: only chooses the light
    std::shared_ptr<const BrightPlaces> places;  ///< to look at, in place_on's square; none: all alike
    std::array<Imath::V3d, 3> corner;
    Imath::V3d normal;  ///< unit, out of the front face
    Imath::V3d center;
    double radius;  ///< from the centre to the farthest corner
};

/// `most_cells_across`: of the grid by which places of a textured one are chosen. Where its texture is black
/// wherever the grid looks, its mean is 0 and it is not chosen: rays that meet it find what else there is.
[[nodiscard]] AreaLight area_light(const Scene& scene, std::uint32_t triangle, int most_cells_across);

/// The place of a triangle that belongs to a point of the unit square, areas in proportion: the square's far
/// half is folded onto the near one.
[[nodiscard]] SurfaceId place_on(std::uint32_t triangle, const std::array<double, 2>& square);

using Light = std::variant<AreaLight, PointLight, SpotLight, DirectionalLight>;

/// Mean over the channels.
[[nodiscard]] inline double mean_channel(const Rgb& c) {
    return (static_cast<double>(c.x) + static_cast<double>(c.y) + static_cast<double>(c.z)) / 3;
}

/// Total flux, W, mean over the channels. A directional light's goes through a disc of radius `scene_radius`.
[[nodiscard]] double power_of(const Light& light, double scene_radius);

}  // namespace common::reference
