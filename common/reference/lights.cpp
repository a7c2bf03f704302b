#include "common/reference/lights.h"

#include <algorithm>

#include "common/reference/expected_light.h"
#include "common/reference/straight_line.h"
#include "common/scene/coverage.h"

namespace common::reference {

namespace {

/// Returns the limit of cells across for each textured light's grid, lower for many lights to save memory.
int most_cells_across(const Scene& scene) {
    double textured = 1;
    for (std::uint32_t t = 0; t < scene.triangle.size(); ++t)
        textured +=
            scene.material_of(t).emits() && scene.material_of(t).emissive_texture.texture != no_texture;
    constexpr double cells_in_all = 1 << 20, most = 256;
    return static_cast<int>(std::clamp(std::sqrt(cells_in_all / textured), 4.0, most));
}

}  // namespace

Lights::Lights(const Scene& scene)
    : of_triangle_(scene.triangle.size(), -1),
      specular_(specular_bounds(scene)),
      see_through_(has_see_through(scene)) {
    const int across = most_cells_across(scene);
    for (std::uint32_t t = 0; t < scene.triangle.size(); ++t) {
        if (!scene.material_of(t).emits() || coverage_range(scene, t).is_nowhere()) continue;
        of_triangle_[t] = static_cast<std::int32_t>(light_.size());
        light_.emplace_back(area_light(scene, t, across));
    }
    light_.insert(light_.end(), scene.point_light.begin(), scene.point_light.end());
    light_.insert(light_.end(), scene.spot_light.begin(), scene.spot_light.end());
    light_.insert(light_.end(), scene.directional_light.begin(), scene.directional_light.end());
    double sum = 0;
    for (const Light& light : light_)
        cumulative_power_.push_back(sum += power_of(light, 0.5 * static_cast<double>(scene.diagonal())));
}

LightChoice::LightChoice(const Lights& lights, const Receiver& receiver) : count_(lights.light().size()) {
    if (count_ > most_weighed_lights) {
        by_power_ = lights.cumulative_power();
        return;
    }
    double sum = 0;
    for (std::size_t i = 0; i < count_; ++i)
        weighed_[i] = sum += expected_irradiance(lights.light()[i], receiver);
}

std::int32_t LightChoice::choose(double uniform) const {
    const std::span<const double> sums = cumulative();
    if (sums.empty() || !(sums.back() > 0)) return -1;
    const auto found = std::upper_bound(sums.begin(), sums.end(), uniform * sums.back());
    return static_cast<std::int32_t>(std::min<std::ptrdiff_t>(found - sums.begin(), std::ssize(sums) - 1));
}

double LightChoice::probability(std::int32_t light) const {
    const std::span<const double> sums = cumulative();
    if (!(sums.back() > 0)) return 0;
    const double before = light == 0 ? 0.0 : sums[light - 1];
    return (sums[light] - before) / sums.back();
}

}  // namespace common::reference
