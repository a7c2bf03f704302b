// A scene before it becomes glTF: meshes that may be placed many times, with materials, lights and cameras.
#pragma once

#include <Imath/ImathMatrix.h>

#include <string>
#include <vector>

#include "bench/scenes/mesh_builder.h"
#include "bench/scenes/procedural_texture.h"
#include "bench/scenes/surface_patterns.h"
#include "common/scene/scene.h"

namespace scenes {

/// One node: a placed mesh with a material.
struct Placement {
    std::string name;
    int mesh;
    int material;
    Imath::M44f to_world;  ///< Imath's convention: row vectors, translation in the last row
};

class SceneDescription {
  public:
    /// These functions return the index of what they add.
    int add_mesh(Mesh mesh);
    int add_material(common::Material material);
    int add_diffuse(const std::string& name, const Rgb& albedo);
    int add_emitter(const std::string& name, const Rgb& radiance);  ///< W/(m^2 sr)

    /// Adds a diffuse material with textures of `size` pixels' width: base colour and, unless the pattern is
    /// flat, normals.
    int add_patterned(const std::string& name, const SurfacePattern& pattern, int size);
    /// Adds the same with a plain colour and only the normal texture.
    int add_bumped(const std::string& name, const Rgb& albedo, const Height& height, int size);

    void place(const std::string& name, int mesh, int material, const Imath::M44f& to_world = {});
    void place(const std::string& name, const MeshBuilder& builder, int material);

    void add_point_light(const Vec3& position, const Rgb& intensity);  ///< W/sr
    void add_spot_light(const Vec3& position, const Vec3& target, const Rgb& intensity, float inner_degrees,
                        float outer_degrees);  ///< W/sr on the axis; half angles of the cones
    void add_camera(const std::string& name, const Vec3& eye, const Vec3& target, float vertical_fov_degrees);

    std::vector<Image> image;  ///< the materials' TextureUse::texture is an index into it
    std::vector<common::Material> material;
    std::vector<Mesh> mesh;
    std::vector<Placement> placement;
    std::vector<common::PointLight> point_light;
    std::vector<common::SpotLight> spot_light;
    std::vector<common::Camera> camera;
};

[[nodiscard]] Imath::M44f translated(const Vec3& offset);

/// Rotates about the y axis, then translates. Positive angles rotate +z towards +x.
[[nodiscard]] Imath::M44f turned(float degrees, const Vec3& offset);

}  // namespace scenes
