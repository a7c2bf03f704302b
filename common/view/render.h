// Renders an image from a finished map and the surfaces that a camera sees.
#pragma once

#include <oneapi/tbb/parallel_for.h>

#include <numbers>
#include <span>

#include "common/estimator/irradiance_estimator.h"
#include "common/image/image.h"
#include "common/view/visible_surfaces.h"

namespace common {

/// Returns the radiance that reaches the camera, W/(m^2 sr), for the irradiance at the visible surface.
[[nodiscard]] inline Rgb radiance_towards_camera(const VisibleSurface& seen, const Rgb& irradiance) {
    return (seen.reflectance * irradiance / std::numbers::pi_v<float> + seen.emitted) * seen.throughput;
}

/// Performs one gather for each pixel that sees a diffuse surface.
///
/// Channels R, G, B: radiance towards the camera, W/(m^2 sr). A: 1 if a diffuse surface is seen, else 0.
/// irradiance.R, .G, .B: the map's irradiance at that surface, W/m^2; 0 if there is none.
template <IrradianceEstimator Map>
[[nodiscard]] Image render(std::span<const VisibleSurface> pixels, int width, int height, const Map& map) {
    Image image{width, height, {"R", "G", "B", "A", "irradiance.R", "irradiance.G", "irradiance.B"}, {}};
    image.values.resize(image.pixel_count() * image.channels.size());
    tbb::parallel_for(std::size_t{0}, image.pixel_count(), [&](std::size_t p) {
        const VisibleSurface& seen = pixels[p];
        const Rgb irradiance = seen.present ? map.irradiance(seen.point) : Rgb(0, 0, 0);
        const Rgb radiance = radiance_towards_camera(seen, irradiance);
        for (int c = 0; c < 3; ++c) {
            image.at(p, c) = radiance[c];
            image.at(p, 4 + c) = irradiance[c];
        }
        image.at(p, 3) = seen.present ? 1.0f : 0.0f;
    });
    return image;
}

}  // namespace common
