#include "common/scene/surface_point.h"

namespace common {
namespace {

struct TangentFrame {
    Vec3 tangent, bitangent;
};

/// Returns tangent and bitangent for the texture coordinates of the normal map: the vertices' own, or else
/// the triangle's derivatives of position by the texture coordinates at which the map is read.
TangentFrame tangent_frame_at(const Scene& scene, const SurfaceId& surface, const Vec3& normal,
                              const TextureUse& use) {
    const auto [a, b, c] = scene.triangle[surface.triangle];
    Vec3 tangent = interpolate(scene.tangent[a], scene.tangent[b], scene.tangent[c], surface.u, surface.v);
    float sign = scene.tangent_sign[a];
    if (tangent.length2() == 0) {
        const MapTangent of_triangle = triangle_tangent(scene, surface.triangle, use);
        if (of_triangle.tangent == Vec3(0, 0, 0)) return {Vec3(0, 0, 0), Vec3(0, 0, 0)};
        tangent = of_triangle.tangent;
        sign = of_triangle.sign;
    }
    tangent = (tangent - normal * normal.dot(tangent)).normalized();
    return {tangent, normal.cross(tangent) * sign};
}

/// Returns `normal` perturbed by the material's normal texture (glTF 2.0, section 3.9.3: texel green points
/// up, towards decreasing v, which is the direction of the bitangent).
Vec3 normal_mapped(const Scene& scene, const SurfaceId& surface, const Material& material,
                   const Vec3& normal) {
    const TextureUse& use = material.normal_texture;
    const Vec3 texel = scene.texture[use.texture].sample(texcoord_at(scene, surface, use));
    const Vec3 bent = {(2 * texel.x - 1) * material.normal_scale, (2 * texel.y - 1) * material.normal_scale,
                       2 * texel.z - 1};
    const auto [tangent, bitangent] = tangent_frame_at(scene, surface, normal, use);
    const Vec3 result = tangent * bent.x + bitangent * bent.y + normal * bent.z;
    return result.length2() > 0 ? result.normalized() : normal;
}

}  // namespace

MapTangent triangle_tangent(const Scene& scene, std::uint32_t triangle, const TextureUse& use) {
    const auto [a, b, c] = scene.triangle[triangle];
    const auto& uv = scene.texcoord[use.texcoord_set];
    const Vec2 uv_a = use.transform(uv[a]);
    const Vec2 duv1 = use.transform(uv[b]) - uv_a, duv2 = use.transform(uv[c]) - uv_a;
    const Vec3 edge1 = scene.position[b] - scene.position[a], edge2 = scene.position[c] - scene.position[a];
    const float determinant = duv1.x * duv2.y - duv1.y * duv2.x;
    if (determinant == 0) return {Vec3(0, 0, 0), 1};
    const float turn = std::copysign(1.0f, determinant);
    return {(edge1 * duv2.y - edge2 * duv1.y) * turn, -turn};  // glTF's v points down, its bitangent up
}

Vec3 position_at(const Scene& scene, const SurfaceId& surface) {
    const auto [a, b, c] = scene.triangle[surface.triangle];
    return interpolate(scene.position[a], scene.position[b], scene.position[c], surface.u, surface.v);
}

Vec2 texcoord_at(const Scene& scene, const SurfaceId& surface, int texcoord_set) {
    const auto [a, b, c] = scene.triangle[surface.triangle];
    const auto& uv = scene.texcoord[texcoord_set];
    return interpolate(uv[a], uv[b], uv[c], surface.u, surface.v);
}

Vec2 texcoord_at(const Scene& scene, const SurfaceId& surface, const TextureUse& use) {
    // Transformed, then interpolated, in the tracer's order (SurfaceTexture): see interpolate().
    const auto [a, b, c] = scene.triangle[surface.triangle];
    const auto& uv = scene.texcoord[use.texcoord_set];
    return interpolate(use.transform(uv[a]), use.transform(uv[b]), use.transform(uv[c]), surface.u,
                       surface.v);
}

Vec3 smooth_normal_at(const Scene& scene, const SurfaceId& surface) {
    const auto [a, b, c] = scene.triangle[surface.triangle];
    const Vec3& geometric = scene.geometric_normal[surface.triangle];
    const Vec3 normal = interpolate(scene.normal[a], scene.normal[b], scene.normal[c], surface.u, surface.v);
    // In some files vertex normals point away from their triangle; such a normal is not used.
    return normal.dot(geometric) > 0 ? normal.normalized() : geometric;
}

Rgb base_color_at(const Scene& scene, const SurfaceId& surface) {
    const Material& material = scene.material_of(surface.triangle);
    const TextureUse& use = material.base_color_texture;
    Rgb color = material.base_color;
    if (use.texture != no_texture)
        color = color * scene.texture[use.texture].sample(texcoord_at(scene, surface, use));
    if (!scene.color.empty()) {
        const auto [a, b, c] = scene.triangle[surface.triangle];
        color = color * interpolate(scene.color[a], scene.color[b], scene.color[c], surface.u, surface.v);
    }
    return color;
}

float alpha_at(const Scene& scene, const SurfaceId& surface) {
    const Material& material = scene.material_of(surface.triangle);
    const TextureUse& use = material.base_color_texture;
    float alpha = material.alpha;
    if (use.texture != no_texture)
        alpha *= scene.texture[use.texture].sample_alpha(texcoord_at(scene, surface, use));
    if (!scene.alpha.empty()) {
        const auto [a, b, c] = scene.triangle[surface.triangle];
        alpha *= interpolate(scene.alpha[a], scene.alpha[b], scene.alpha[c], surface.u, surface.v);
    }
    return alpha;
}

Rgb emitted_radiance_at(const Scene& scene, const SurfaceId& surface) {
    const Material& material = scene.material_of(surface.triangle);
    const TextureUse& use = material.emissive_texture;
    if (use.texture == no_texture) return material.emitted_radiance;
    return material.emitted_radiance * scene.texture[use.texture].sample(texcoord_at(scene, surface, use));
}

SurfacePoint surface_point_at(const Scene& scene, const SurfaceId& surface, const Vec3& direction) {
    const Material& material = scene.material_of(surface.triangle);
    const Vec3& front_normal = scene.geometric_normal[surface.triangle];
    const bool front = direction.dot(front_normal) < 0;

    Vec3 shading = smooth_normal_at(scene, surface);
    if (material.normal_texture.texture != no_texture)
        shading = normal_mapped(scene, surface, material, shading);
    // A map may bend the normal below the horizon. A normal that faces away from its own surface gathers
    // nothing useful.
    if (shading.dot(front_normal) <= 0) shading = front_normal;

    const float side = front ? 1.0f : -1.0f;
    return {surface, position_at(scene, surface), front_normal * side, shading * side, front};
}

}  // namespace common
