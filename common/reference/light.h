// The kinds of light to which a surface point can be connected by a straight line.
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
    double mean_radiance;  ///< over triangle, holes and channels; only used to choose the light
    std::shared_ptr<const BrightPlaces> places;  ///< samples places, in place_on()'s square; null: uniform
    std::array<Imath::V3d, 3> corner;
    Imath::V3d normal;  ///< unit, out of the front face
    Imath::V3d center;
    double radius;  ///< from the centre to the farthest corner
};

/// `most_cells_across` limits the grid that samples the places of a textured light. If the texture is black
/// at all places that the grid tests, the mean radiance is 0 and the light is never chosen. Rays that hit it
/// still find the rest of its emission.
[[nodiscard]] AreaLight area_light(const Scene& scene, std::uint32_t triangle, int most_cells_across);

/// Maps a point of the unit square to a place on a triangle, with areas in proportion: the far half of the
/// square is folded onto the near one.
[[nodiscard]] SurfaceId place_on(std::uint32_t triangle, const std::array<double, 2>& square);

using Light = std::variant<AreaLight, PointLight, SpotLight, DirectionalLight>;

/// Returns the mean over the channels.
[[nodiscard]] inline double mean_channel(const Rgb& c) {
    return (static_cast<double>(c.x) + static_cast<double>(c.y) + static_cast<double>(c.z)) / 3;
}

/// Returns the total flux, W, mean over the channels. That of a directional light is through a disc of radius
/// `scene_radius`.
[[nodiscard]] double power_of(const Light& light, double scene_radius);

}  // namespace common::reference
