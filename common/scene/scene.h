// The scene as every later step sees it: world-space triangles with materials, lights and cameras.
// A loader fills it in; from then on it is not changed.
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

/// Where texture coordinates are taken to before the texture is read (KHR_texture_transform).
struct TexcoordTransform {
    Vec2 offset{0, 0};                  ///< of the coordinates (0, 0)
    Vec2 along_u{1, 0}, along_v{0, 1};  ///< what a step of 1 along u and along v adds

    [[nodiscard]] Vec2 operator()(const Vec2& texcoord) const {
        return offset + along_u * texcoord.x + along_v * texcoord.y;
    }
    bool operator==(const TexcoordTransform&) const = default;
};

/// Which texture a material reads, through which set of texture coordinates (0 or 1), moved how.
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
                 ///< sides: reflects, or lets light through unbent; stores nothing
};

/// What becomes of a material's alpha (glTF 2.0, section 3.9.4).
enum class AlphaMode {
    opaque,  ///< nothing
    mask,    ///< the surface is there where alpha is at least the cutoff, else there is a hole
    blend    ///< alpha is the part of the surface that is there
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
    float alpha = 1;  ///< times that of the base colour's texture and of the vertices
    float alpha_cutoff = 0.5f;
    bool double_sided =
        false;  ///< both faces emit and each has light of its own; otherwise the front face only

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
    std::string name = "";  ///< as warnings call it: light 'Lamp'
};

/// glTF spot: intensity falls off between the cones as KHR_lights_punctual says.
struct SpotLight {
    Vec3 position;
    Vec3 axis;      ///< unit, the way the light shines
    Rgb intensity;  ///< W/sr on the axis
    // Of half the cones' angles. A laser's differ from 1 in digits that floats do not have.
    double cos_inner_angle = 1;
    double cos_outer_angle = 0.70710678f;
    std::string name = "";  ///< as warnings call it

    /// Whether 1 - its cosines takes more digits than floats have: below 3.6 degrees.
    [[nodiscard]] bool is_narrow() const { return cos_outer_angle > 0.998; }
};

struct DirectionalLight {
    Vec3 direction;         ///< unit, the way the light travels
    Rgb irradiance;         ///< W/m^2 on a surface perpendicular to it
    std::string name = "";  ///< as warnings call it
};

/// Uniform light from everywhere outside.
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

/// All positions are in world units, which glTF says are metres.
struct Scene {
    std::string source;  ///< the file it came from

    // One entry per vertex. Vertices are not shared between mesh instances.
    std::vector<Vec3> position;
    std::vector<Vec3> normal;  ///< unit, world space; the triangle's own where the file gives none
    std::array<std::vector<Vec2>, 2> texcoord;  ///< TEXCOORD_0, TEXCOORD_1; zero where absent
    /// Unit tangent, world space, along increasing u of the normal texture; zero for the triangles' own.
    std::vector<Vec3> tangent;
    std::vector<float> tangent_sign;  ///< glTF's TANGENT.w: the bitangent is sign * cross(normal, tangent)
    // Both empty where no primitive has COLOR_0; otherwise 1 for the vertices of those that have none.
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

    std::vector<std::string> warnings;  ///< what was read but could not be honoured, a line each

    Imath::Box3f bounds;

    /// Where the file has what is at (0, 0, 0) here. Not zero only for scenes so far from their origin that
    /// floats would blur them.
    Imath::V3d origin{0, 0, 0};

    [[nodiscard]] const Material& material_of(std::uint32_t triangle_index) const {
        return material[instance[instance_of[triangle_index]].material];
    }
    /// A length to measure tolerances and radii by.
    [[nodiscard]] float diagonal() const { return (bounds.max - bounds.min).length(); }
};

/// Area of a triangle in square world units.
[[nodiscard]] float triangle_area(const Scene& scene, std::uint32_t triangle);

}  // namespace common
