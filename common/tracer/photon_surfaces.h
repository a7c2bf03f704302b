// What the photon tracer needs about a triangle that a photon has hit.
#pragma once

#include <cstdint>

#include "common/core/huge_pages.h"
#include "common/scene/scene.h"

namespace common {

/// Fits into one cache line. A photon's triangle is anywhere in memory, and fetching it is most of the cost
/// of a reflection.
struct alignas(64) PhotonSurface {
    enum Kind : std::uint32_t {
        diffuse,                   ///< Lambertian, one colour
        textured_diffuse,          ///< Lambertian, colour from a texture
        colored_diffuse,           ///< Lambertian, colour from the vertices
        textured_colored_diffuse,  ///< Lambertian, the product of both
        perforated_diffuse,        ///< Lambertian with holes
        specular                   ///< mirror, glass, or coverage 0 everywhere: stores nothing
    };

    Vec3 corner, edge_u, edge_v;  ///< world units: position = corner + u edge_u + v edge_v
    Vec3 normal;                  ///< unit, geometric, front
    Rgb base_color;               ///< of the diffuse kind
    Kind kind;

    [[nodiscard]] Vec3 position(float u, float v) const { return corner + edge_u * u + edge_v * v; }

    /// Returns whether photons that arrive here are recorded as hits. Those that pass through a hole are
    /// recorded too, as the irradiance at a place does not depend on its coverage.
    [[nodiscard]] bool stores() const { return kind != specular; }
    [[nodiscard]] bool is_textured() const {
        return kind == textured_diffuse || kind == textured_colored_diffuse;
    }
    [[nodiscard]] bool is_colored() const {
        return kind == colored_diffuse || kind == textured_colored_diffuse;
    }
    /// Returns whether `base_color`, with texture and vertex colours, determines the reflection. If not,
    /// scatter() must be called.
    [[nodiscard]] bool is_simple() const { return kind < perforated_diffuse; }
};

/// The texture of a triangle's base colour.
struct alignas(32) SurfaceTexture {
    Vec2 corner, edge_u, edge_v;       ///< texture coordinates, as in PhotonSurface
    const Texture* texture = nullptr;  ///< factor of PhotonSurface::base_color

    [[nodiscard]] Vec2 texcoord(float u, float v) const { return corner + edge_u * u + edge_v * v; }
};

/// The vertex colours of a triangle, laid out as in PhotonSurface: factors of its base colour and texture.
struct alignas(64) SurfaceColors {
    Rgb corner, edge_u, edge_v;

    [[nodiscard]] Rgb color(float u, float v) const { return corner + edge_u * u + edge_v * v; }
};

class PhotonSurfaces {
  public:
    /// `scene` must outlive this object.
    explicit PhotonSurfaces(const Scene& scene);

    [[nodiscard]] const PhotonSurface& operator[](std::uint32_t triangle) const {
        return surfaces_[triangle];
    }

    /// Valid only for a triangle that is_textured().
    [[nodiscard]] const SurfaceTexture& texture(std::uint32_t triangle) const { return textures_[triangle]; }

    /// Valid only for a triangle that is_colored().
    [[nodiscard]] const SurfaceColors& colors(std::uint32_t triangle) const { return colors_[triangle]; }

  private:
    HugePageVector<PhotonSurface> surfaces_;   ///< one per triangle
    HugePageVector<SurfaceTexture> textures_;  ///< one per triangle; none if no triangle is textured
    HugePageVector<SurfaceColors> colors_;     ///< one per triangle; none if no triangle is colored
};

}  // namespace common
