#include "bench/scenes/scene_description.h"

#include <numbers>

namespace scenes {
namespace {

float radians(float degrees) {
    return degrees * std::numbers::pi_v<float> / 180.0f;
}

template <class T>
int append(std::vector<T>& list, T item) {
    list.push_back(std::move(item));
    return static_cast<int>(list.size()) - 1;
}

}  // namespace

int SceneDescription::add_mesh(Mesh item) {
    return append(mesh, std::move(item));
}

int SceneDescription::add_material(common::Material item) {
    return append(material, std::move(item));
}

int SceneDescription::add_diffuse(const std::string& name, const Rgb& albedo) {
    common::Material diffuse;
    diffuse.name = name;
    diffuse.base_color = albedo;
    return add_material(std::move(diffuse));
}

int SceneDescription::add_emitter(const std::string& name, const Rgb& radiance) {
    common::Material emitter;
    emitter.name = name;
    emitter.base_color = Rgb(0.7f, 0.7f, 0.7f);
    emitter.emitted_radiance = radiance;
    return add_material(std::move(emitter));
}

int SceneDescription::add_patterned(const std::string& name, const SurfacePattern& pattern, int size) {
    const Rgb white(1, 1, 1);
    const int index =
        pattern.height ? add_bumped(name, white, pattern.height, size) : add_diffuse(name, white);
    material[index].base_color_texture.texture =
        append(image, make_color_image(name + "_color", size, pattern.albedo));
    return index;
}

int SceneDescription::add_bumped(const std::string& name, const Rgb& albedo, const Height& height, int size) {
    const int index = add_diffuse(name, albedo);
    material[index].normal_texture.texture = append(image, make_normal_image(name + "_normal", size, height));
    return index;
}

void SceneDescription::place(const std::string& name, int mesh_index, int material_index,
                             const Imath::M44f& to_world) {
    placement.push_back({name, mesh_index, material_index, to_world});
}

void SceneDescription::place(const std::string& name, const MeshBuilder& builder, int material_index) {
    place(name, add_mesh(builder.finish()), material_index);
}

void SceneDescription::add_point_light(const Vec3& position, const Rgb& intensity) {
    point_light.push_back({position, intensity});
}

void SceneDescription::add_spot_light(const Vec3& position, const Vec3& target, const Rgb& intensity,
                                      float inner_degrees, float outer_degrees) {
    spot_light.push_back({position, (target - position).normalized(), intensity,
                          std::cos(radians(inner_degrees)), std::cos(radians(outer_degrees))});
}

void SceneDescription::add_camera(const std::string& name, const Vec3& eye, const Vec3& target,
                                  float vertical_fov_degrees) {
    const Vec3 forward = (target - eye).normalized();
    const Vec3 right = (forward % Vec3(0, 1, 0)).normalized();
    camera.push_back({name, eye, forward, right % forward, radians(vertical_fov_degrees)});
}

Imath::M44f translated(const Vec3& offset) {
    return turned(0, offset);
}

Imath::M44f turned(float degrees, const Vec3& offset) {
    // Whole quarter turns are exact.
    const float quarter = degrees / 90.0f;
    const bool whole = quarter == std::round(quarter);
    const float s = whole ? std::round(std::sin(radians(degrees))) : std::sin(radians(degrees));
    const float c = whole ? std::round(std::cos(radians(degrees))) : std::cos(radians(degrees));
    return {c, 0, -s, 0, 0, 1, 0, 0, s, 0, c, 0, offset.x, offset.y, offset.z, 1};
}

}  // namespace scenes
