// The scene as all later steps see it: world-space triangles with materials, lights and cameras. A loader
// fills it in; afterwards it does not change.
#pragma once

#include <Imath/ImathBox.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/core/vector.h"
#include "common/scene/texture.h"

namespace common {

inline constexpr std::int32_t no_texture = -1;

/// The transform of texture coordinates before the texture is read (KHR_texture_transform).
struct TexcoordTransform {
    Vec2 offset{0, 0};                  ///< the result for coordinates (0, 0)
    Vec2 along_u{1, 0}, along_v{0, 1};  ///< the change for a step of 1 along u and along v

    [[nodiscard]] Vec2 operator()(const Vec2& texcoord) const {
        return offset + along_u * texcoord.x + along_v * texcoord.y;
    }
    bool operator==(const TexcoordTransform&) const = default;
};

/// The texture that a material reads, the set of texture coordinates (0 or 1) and their transform.
struct TextureUse {
    std::int32_t texture = no_texture;
    int texcoord_set = 0;
    TexcoordTransform transform = {};
};

enum class SurfaceKind {
    diffuse,     ///< Lambertian: stores hits
    mirror,      ///< perfect specular reflection (metallic 1, roughness 0): stores nothing
    dielectric,  ///< boundary of a body of smooth glass (KHR_materials_transmission with
                 ///< KHR_materials_volume, KHR_materials_ior): stores nothing
    thin_sheet   ///< smooth glass without thickness (KHR_materials_transmission alone), seen from both
                 ///< sides: reflects, or transmits without bending; stores nothing
};

/// The use of a material's alpha (glTF 2.0, section 3.9.4).
enum class AlphaMode {
    opaque,  ///< alpha is ignored
    mask,    ///< the surface is present where alpha is at least the cutoff, else there is a hole
    blend    ///< alpha is the fraction of the surface that is present
};

struct Material {
    std::string name;
    SurfaceKind kind = SurfaceKind::diffuse;
    Rgb base_color{1, 1,
                   1};  ///< albedo of a diffuse surface, reflectance of a mirror, tint of glass; in [0, 1]
    TextureUse base_color_texture;
    TextureUse normal_texture;
    float normal_scale = 1.0f;
    Rgb emitted_radiance{0, 0, 0};  ///< W/(m^2 sr): emissiveFactor times emissiveStrength
    TextureUse emissive_texture;    ///< multiplies emitted_radiance
    float index_of_refraction = 1.5f;
    AlphaMode alpha_mode = AlphaMode::opaque;
    float alpha = 1;  ///< factor of the alpha of the base colour's texture and of the vertices
    float alpha_cutoff = 0.5f;
    bool double_sided =
        false;  ///< both faces emit and each has its own irradiance; otherwise only the front face

    [[nodiscard]] bool emits() const { return max_component(emitted_radiance) > 0; }
};

/// Corners of a triangle as indices into the vertex arrays, counter-clockwise seen from the front.
using TriangleVertices = std::array<std::uint32_t, 3>;

/// One glTF primitive under one node: a contiguous range of triangles with one material.
struct MeshInstance {
    std::string name;
    std::uint32_t first_triangle = 0;
    std::uint32_t triangle_count = 0;
    std::uint32_t material = 0;
    bool has_texcoord[2] = {false, false};
};

struct PointLight {
    Vec3 position;
    Rgb intensity;          ///< W/sr
    std::string name = "";  ///< as used in warnings: light 'Lamp'
};

/// glTF spot: intensity falls off between the cones as KHR_lights_punctual says.
struct SpotLight {
    Vec3 position;
    Vec3 axis;      ///< unit, the way the light shines
    Rgb intensity;  ///< W/sr on the axis
    // Cosines of half the cones' angles. For a laser they differ from 1 by less than floats resolve.
    double cos_inner_angle = 1;
    double cos_outer_angle = 0.70710678f;
    std::string name = "";  ///< as used in warnings

    /// Returns whether 1 - its cosines needs more digits than floats have: below 3.6 degrees.
    [[nodiscard]] bool is_narrow() const { return cos_outer_angle > 0.998; }
};

struct DirectionalLight {
    Vec3 direction;         ///< unit, the way the light travels
    Rgb irradiance;         ///< W/m^2 on a surface perpendicular to it
    std::string name = "";  ///< as used in warnings
};

/// Uniform radiance from all directions outside the scene.
struct Sky {
    Rgb radiance;  ///< W/(m^2 sr)
};

struct Camera {
    std::string name;
    Vec3 eye;
    Vec3 forward;                    ///< unit
    Vec3 up;                         ///< unit, perpendicular to forward
    float vertical_fov = 0.785398f;  ///< radians
};

/// All positions are in world units, which are metres in glTF.
struct Scene {
    std::string source;  ///< the file it came from

    // One entry per vertex. Vertices are not shared between mesh instances.
    std::vector<Vec3> position;
    std::vector<Vec3> normal;  ///< unit, world space; the triangle's own where the file gives none
    std::array<std::vector<Vec2>, 2> texcoord;  ///< TEXCOORD_0, TEXCOORD_1; zero where absent
    /// Unit tangent, world space, along increasing u of the normal texture; if zero, the triangle's own is
    /// used.
    std::vector<Vec3> tangent;
    std::vector<float> tangent_sign;  ///< glTF's TANGENT.w: the bitangent is sign * cross(normal, tangent)
    // Both are empty if no primitive has COLOR_0; otherwise 1 for the vertices of primitives without it.
    std::vector<Rgb> color;    ///< linear, in [0, 1]; multiplies the base colour
    std::vector<float> alpha;  ///< in [0, 1]; multiplies the material's

    // One entry per triangle.
    std::vector<TriangleVertices> triangle;
    std::vector<Vec3> geometric_normal;      ///< unit, out of the front face
    std::vector<std::uint32_t> instance_of;  ///< index into `instance`

    std::vector<MeshInstance> instance;
    std::vector<Material> material;
    std::vector<Texture> texture;

    std::vector<PointLight> point_light;
    std::vector<SpotLight> spot_light;
    std::vector<DirectionalLight> directional_light;
    std::optional<Sky> sky;
    std::vector<Camera> camera;

    std::vector<std::string> warnings;  ///< what was read but could not be honoured, one line each

    Imath::Box3f bounds;

    /// The position in the file of what is at (0, 0, 0) here. Not zero only for scenes so far from their
    /// origin that floats would blur them.
    Imath::V3d origin{0, 0, 0};

    [[nodiscard]] const Material& material_of(std::uint32_t triangle_index) const {
        return material[instance[instance_of[triangle_index]].material];
    }
    /// Returns the diagonal of the bounds, the scale of tolerances and radii.
    [[nodiscard]] float diagonal() const { return (bounds.max - bounds.min).length(); }
};

/// Returns the area of a triangle in square world units.
[[nodiscard]] float triangle_area(const Scene& scene, std::uint32_t triangle);

}  // namespace common
