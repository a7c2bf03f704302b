#include "common/tracer/photon_surfaces.h"

#include "common/scene/coverage.h"

namespace common {
namespace {

bool is_colored(const Scene& scene, std::uint32_t triangle) {
    if (scene.color.empty()) return false;
    const Rgb white(1, 1, 1);
    return std::ranges::any_of(scene.triangle[triangle],
                               [&](std::uint32_t vertex) { return scene.color[vertex] != white; });
}

PhotonSurface::Kind kind_of(const Scene& scene, std::uint32_t triangle) {
    const Material& material = scene.material_of(triangle);
    const CoverageRange coverage = coverage_range(scene, triangle);
    if (material.kind != SurfaceKind::diffuse || coverage.is_nowhere()) return PhotonSurface::specular;
    if (coverage.has_holes()) return PhotonSurface::perforated_diffuse;
    const bool textured = material.base_color_texture.texture != no_texture;
    if (is_colored(scene, triangle))
        return textured ? PhotonSurface::textured_colored_diffuse : PhotonSurface::colored_diffuse;
    return textured ? PhotonSurface::textured_diffuse : PhotonSurface::diffuse;
}

SurfaceTexture texture_of(const Scene& scene, std::uint32_t triangle) {
    const TextureUse& use = scene.material_of(triangle).base_color_texture;
    const auto [a, b, c] = scene.triangle[triangle];
    const auto at = [&](std::uint32_t vertex) {
        return use.transform(scene.texcoord[use.texcoord_set][vertex]);
    };
    return {at(a), at(b) - at(a), at(c) - at(a), &scene.texture[use.texture]};
}

SurfaceColors colors_of(const Scene& scene, std::uint32_t triangle) {
    const auto [a, b, c] = scene.triangle[triangle];
    return {scene.color[a], scene.color[b] - scene.color[a], scene.color[c] - scene.color[a]};
}

}  // namespace

PhotonSurfaces::PhotonSurfaces(const Scene& scene) : surfaces_(scene.triangle.size()) {
    for (std::uint32_t t = 0; t < surfaces_.size(); ++t) {
        const auto [a, b, c] = scene.triangle[t];
        const Vec3& corner = scene.position[a];
        const Material& material = scene.material_of(t);
        surfaces_[t] = {corner,
                        scene.position[b] - corner,
                        scene.position[c] - corner,
                        scene.geometric_normal[t],
                        material.base_color,
                        kind_of(scene, t)};
        if (surfaces_[t].is_textured()) {
            if (textures_.empty()) textures_.resize(surfaces_.size());
            textures_[t] = texture_of(scene, t);
        }
        if (surfaces_[t].is_colored()) {
            if (colors_.empty()) colors_.resize(surfaces_.size());
            colors_[t] = colors_of(scene, t);
        }
    }
}

}  // namespace common
