#include "common/tracer/photon_surfaces.h"

namespace common {
namespace {

PhotonSurface::Kind kind_of(const Material& material) {
    if (material.kind != SurfaceKind::diffuse) return PhotonSurface::specular;
    return material.base_color_texture.texture == no_texture ? PhotonSurface::diffuse
                                                             : PhotonSurface::textured_diffuse;
}

SurfaceTexture texture_of(const Scene& scene, std::uint32_t triangle) {
    const TextureUse& use = scene.material_of(triangle).base_color_texture;
    const auto [a, b, c] = scene.triangle[triangle];
    const auto& uv = scene.texcoord[use.texcoord_set];
    const Vec2 corner = use.transform(uv[a]);
    return {corner, use.transform(uv[b]) - corner, use.transform(uv[c]) - corner,
            &scene.texture[use.texture]};
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
                        kind_of(material)};
        if (surfaces_[t].kind != PhotonSurface::textured_diffuse) continue;
        if (textures_.empty()) textures_.resize(surfaces_.size());
        textures_[t] = texture_of(scene, t);
    }
}

}  // namespace common
