// What a photon asks of the triangle that it has hit.
#pragma once

#include <cstdint>

#include "common/core/huge_pages.h"
#include "common/scene/scene.h"

namespace common {

/// All on one cache line: a photon's triangle is anywhere in memory, and fetching it is most of the cost of
/// a reflection.
struct alignas(64) PhotonSurface {
    enum Kind : std::uint32_t {
        diffuse,           ///< Lambertian, one colour
        textured_diffuse,  ///< Lambertian, colour from a texture
        specular           ///< mirror or glass: stores nothing
    };

    Vec3 corner, edge_u, edge_v;  ///< world units: position = corner + u edge_u + v edge_v
    Vec3 normal;                  ///< unit, geometric, front
    Rgb base_color;               ///< of the diffuse kind
    Kind kind;

    [[nodiscard]] Vec3 position(float u, float v) const { return corner + edge_u * u + edge_v * v; }
};

/// How a textured triangle's base color is found.
struct alignas(32) SurfaceTexture {
    Vec2 corner, edge_u, edge_v;       ///< texture coordinates, as in PhotonSurface
    const Texture* texture = nullptr;  ///< times PhotonSurface::base_color

    [[nodiscard]] Vec2 texcoord(float u, float v) const { return corner + edge_u * u + edge_v * v; }
};

class PhotonSurfaces {
  public:
    /// `scene` must outlive this object.
    explicit PhotonSurfaces(const Scene& scene);

    [[nodiscard]] const PhotonSurface& operator[](std::uint32_t triangle) const {
        return surfaces_[triangle];
    }

    /// Of a textured_diffuse triangle.
    [[nodiscard]] const SurfaceTexture& texture(std::uint32_t triangle) const { return textures_[triangle]; }

  private:
    HugePageVector<PhotonSurface> surfaces_;   ///< one per triangle
    HugePageVector<SurfaceTexture> textures_;  ///< one per triangle; none where nothing is textured
};

}  // namespace common
