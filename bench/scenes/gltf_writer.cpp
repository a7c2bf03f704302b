#include "bench/scenes/gltf_writer.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <map>
#include <span>

#include "common/core/output_file.h"
#include "common/gltf_writing/model_parts.h"

namespace scenes {
namespace {

using namespace common::gltf_writing;
using common::gltf_writing::to_doubles;  // beside the one for matrices
using tinygltf::Value;

constexpr double aspect_ratio = 16.0 / 9.0;

std::vector<double> to_doubles(const Imath::M44f& m) {
    // Imath's rows of row vectors have the memory layout of glTF's columns of column vectors.
    return {&m[0][0], &m[0][0] + 16};
}

/// Returns the transform of a light or camera, which looks along its own -z axis.
Imath::M44f looking_along(const Vec3& eye, const Vec3& forward, const Vec3& up) {
    const Vec3 right = forward % up;
    return {right.x,    right.y,    right.z,    0, up.x,  up.y,  up.z,  0,
            -forward.x, -forward.y, -forward.z, 0, eye.x, eye.y, eye.z, 1};
}

Vec3 any_perpendicular(const Vec3& v) {
    return (v % (std::abs(v.y) < 0.9f ? Vec3(0, 1, 0) : Vec3(1, 0, 0))).normalized();
}

void add_texture(const Image& image, tinygltf::Model& model) {
    tinygltf::Image out;
    out.name = image.name;
    out.mimeType = "image/png";
    out.width = out.height = image.size;
    out.component = 3;
    out.bits = 8;
    out.pixel_type = TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE;
    out.image = image.rgb;
    tinygltf::Texture texture;
    texture.source = static_cast<int>(model.images.size());
    texture.sampler = 0;
    model.images.push_back(std::move(out));
    model.textures.push_back(std::move(texture));
}

void add_sampler(tinygltf::Model& model) {
    tinygltf::Sampler sampler;
    sampler.magFilter = TINYGLTF_TEXTURE_FILTER_LINEAR;
    sampler.minFilter = TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR;
    sampler.wrapS = sampler.wrapT = TINYGLTF_TEXTURE_WRAP_REPEAT;
    model.samplers.push_back(std::move(sampler));
}

void add_material(const common::Material& in, tinygltf::Model& model) {
    using common::SurfaceKind;
    tinygltf::Material out;
    out.name = in.name;
    out.doubleSided = in.double_sided;
    auto& pbr = out.pbrMetallicRoughness;
    pbr.baseColorFactor = {in.base_color.x, in.base_color.y, in.base_color.z, 1.0};
    pbr.metallicFactor = in.kind == SurfaceKind::mirror ? 1.0 : 0.0;
    pbr.roughnessFactor = in.kind == SurfaceKind::diffuse ? 1.0 : 0.0;
    pbr.baseColorTexture.index = in.base_color_texture.texture;
    out.normalTexture.index = in.normal_texture.texture;
    out.normalTexture.scale = in.normal_scale;
    if (out.normalTexture.index >= 0) {
        // The normal maps are made from heights over u and v, and recorded results were made with these
        // frames.
        Value::Object extras;
        extras["tangents"] = Value(std::string("derivatives"));
        out.normalTexture.extras = Value(std::move(extras));
    }
    if (in.kind == SurfaceKind::dielectric) set_glass(in.index_of_refraction, true, out, model);
    if (in.emits()) set_emission(in.emitted_radiance, out, model);
    model.materials.push_back(std::move(out));
}

tinygltf::Primitive add_geometry(const Mesh& mesh, tinygltf::Model& model) {
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.attributes["POSITION"] = add_positions(mesh.position, model);
    primitive.attributes["NORMAL"] = add_attribute(mesh.normal, model);
    primitive.attributes["TEXCOORD_0"] = add_attribute(mesh.texcoord, model);
    primitive.attributes["TEXCOORD_1"] = add_attribute(mesh.lightmap_texcoord, model);
    primitive.indices = add_indices(mesh.index, model);
    return primitive;
}

tinygltf::Node& add_node(const std::string& name, const Imath::M44f& to_world, tinygltf::Model& model) {
    tinygltf::Node node;
    node.name = name;
    if (to_world != Imath::M44f()) node.matrix = to_doubles(to_world);
    model.scenes.front().nodes.push_back(static_cast<int>(model.nodes.size()));
    model.nodes.push_back(std::move(node));
    return model.nodes.back();
}

/// Adds one glTF mesh per pair of geometry and material; placements of the same pair share it.
void add_placements(const SceneDescription& scene, tinygltf::Model& model) {
    std::vector<tinygltf::Primitive> geometry;
    for (const Mesh& mesh : scene.mesh) geometry.push_back(add_geometry(mesh, model));
    std::map<std::pair<int, int>, int> mesh_of_pair;
    for (const Placement& placement : scene.placement) {
        const auto [found, is_new] = mesh_of_pair.try_emplace({placement.mesh, placement.material},
                                                              static_cast<int>(model.meshes.size()));
        if (is_new) {
            tinygltf::Mesh mesh;
            mesh.name = placement.name;
            mesh.primitives.push_back(geometry[placement.mesh]);
            mesh.primitives.back().material = placement.material;
            model.meshes.push_back(std::move(mesh));
        }
        add_node(placement.name, placement.to_world, model).mesh = found->second;
    }
}

/// Since tinygltf 2.9 a node has a member for its light, and an extension without it is removed on writing.
/// In older versions only the extension exists.
template <class Node>
void refer_to_light(Node& node, int light) {
    Value::Object extension;
    extension["light"] = Value(light);
    node.extensions["KHR_lights_punctual"] = Value(std::move(extension));
    if constexpr (requires { node.light; }) node.light = light;
}

void add_light(const tinygltf::Light& light, const Imath::M44f& to_world, tinygltf::Model& model) {
    refer_to_light(add_node(light.name, to_world, model), static_cast<int>(model.lights.size()));
    model.lights.push_back(light);
    use_extension(model, "KHR_lights_punctual");
}

tinygltf::Light make_light(const std::string& type, std::size_t number, const Rgb& intensity) {
    tinygltf::Light light;
    light.name = fmt::format("{}_light_{}", type, number);
    light.type = type;
    light.intensity = common::max_component(intensity);
    light.color = to_doubles(intensity / common::max_component(intensity));
    return light;
}

void add_lights(const SceneDescription& scene, tinygltf::Model& model) {
    for (const common::PointLight& in : scene.point_light)
        add_light(make_light("point", model.lights.size(), in.intensity), translated(in.position), model);
    for (const common::SpotLight& in : scene.spot_light) {
        tinygltf::Light light = make_light("spot", model.lights.size(), in.intensity);
        light.spot.innerConeAngle = std::acos(static_cast<float>(in.cos_inner_angle));
        light.spot.outerConeAngle = std::acos(static_cast<float>(in.cos_outer_angle));
        add_light(light, looking_along(in.position, in.axis, any_perpendicular(in.axis)), model);
    }
}

void add_cameras(const SceneDescription& scene, tinygltf::Model& model) {
    for (const common::Camera& in : scene.camera) {
        tinygltf::Camera camera;
        camera.name = in.name;
        camera.type = "perspective";
        camera.perspective.aspectRatio = aspect_ratio;
        camera.perspective.yfov = in.vertical_fov;
        camera.perspective.znear = 0.01;
        camera.perspective.zfar = 1000.0;
        add_node(in.name, looking_along(in.eye, in.forward, in.up), model).camera =
            static_cast<int>(model.cameras.size());
        model.cameras.push_back(std::move(camera));
    }
}

tinygltf::Model make_model(const SceneDescription& scene) {
    tinygltf::Model model;
    model.asset.version = "2.0";
    model.asset.generator = "shlmbench_scenes";
    model.buffers.resize(1);
    model.scenes.resize(1);
    model.defaultScene = 0;
    if (!scene.image.empty()) add_sampler(model);
    for (const Image& image : scene.image) add_texture(image, model);
    for (const common::Material& material : scene.material) add_material(material, model);
    add_cameras(scene, model);
    add_placements(scene, model);
    add_lights(scene, model);
    return model;
}

}  // namespace

void write_glb(const SceneDescription& scene, const std::filesystem::path& file) {
    const std::string bytes = glb_bytes(make_model(scene), file.string());
    common::write_whole_file(file, std::as_bytes(std::span(bytes)));
}

}  // namespace scenes
