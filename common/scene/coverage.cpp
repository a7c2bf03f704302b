#include "common/scene/coverage.h"

#include <limits>

namespace common {
namespace {

float coverage_of(const Material& material, float alpha) {
    // Filtering may lose some ulp of an alpha that equals the cutoff everywhere.
    constexpr float rounding = 8 * std::numeric_limits<float>::epsilon();
    switch (material.alpha_mode) {
        case AlphaMode::mask:
            return alpha >= material.alpha_cutoff * (1 - rounding) ? 1.0f : 0.0f;
        case AlphaMode::blend:
            return std::clamp(alpha, 0.0f, 1.0f);
        case AlphaMode::opaque:
            break;
    }
    return 1;
}

}  // namespace

float coverage_at(const Scene& scene, const SurfaceId& surface) {
    const Material& material = scene.material_of(surface.triangle);
    if (material.alpha_mode == AlphaMode::opaque) return 1;
    return coverage_of(material, alpha_at(scene, surface));
}

CoverageRange coverage_range(const Scene& scene, std::uint32_t triangle) {
    const Material& material = scene.material_of(triangle);
    if (material.alpha_mode == AlphaMode::opaque) return {};
    float least = material.alpha, most = material.alpha;
    const std::int32_t texture = material.base_color_texture.texture;
    if (texture != no_texture && scene.texture[texture].has_alpha()) least = 0;
    if (!scene.alpha.empty()) {
        const auto [a, b, c] = scene.triangle[triangle];
        const auto [lowest, highest] = std::minmax({scene.alpha[a], scene.alpha[b], scene.alpha[c]});
        least *= lowest;
        most *= highest;
    }
    return {coverage_of(material, least), coverage_of(material, most)};
}

}  // namespace common
