#include "common/gltf/meshes.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <tuple>

#include "common/core/input_error.h"
#include "common/gltf/materials.h"
#include "common/gltf/not_drawn.h"
#include "common/gltf/primitive.h"
#include "common/gltf/tangents.h"
#include "common/gltf/world_space.h"

namespace common::gltf {
namespace {

constexpr std::uint32_t not_yet = std::numeric_limits<std::uint32_t>::max();

/// The primitives' name within the scene: the node's or mesh's, numbered where the mesh has several.
std::string instance_name(const tinygltf::Model& model, const tinygltf::Node& node, std::size_t primitive) {
    const tinygltf::Mesh& mesh = model.meshes[static_cast<std::size_t>(node.mesh)];
    std::string name = node.name.empty() ? mesh.name : node.name;
    if (name.empty()) name = fmt::format("meshes/{}", node.mesh);
    return mesh.primitives.size() > 1 ? fmt::format("{}/{}", name, primitive) : name;
}

/// Copies a primitive's triangles, already in world space, to the end of the scene.
class InstanceWriter {
  public:
    InstanceWriter(Scene& scene, const Attributes& attributes)
        : scene_(scene), attributes_(attributes), vertex_of_(attributes.position.size(), not_yet) {}

    void add_triangle(const TriangleVertices& corners, const Vec3& geometric_normal,
                      const CornerTangents* made) {
        TriangleVertices triangle;
        for (std::size_t i = 0; i < 3; ++i) {
            const Tangent tangent = made != nullptr ? (*made)[i] : given_tangent(corners[i]);
            triangle[i] = vertex_for(corners[i], geometric_normal, tangent);
        }
        if (scene_.triangle.size() >= not_yet) throw InputError("has more triangles than 32 bits can count");
        scene_.triangle.push_back(triangle);
        scene_.geometric_normal.push_back(geometric_normal);
        scene_.instance_of.push_back(static_cast<std::uint32_t>(scene_.instance.size()));
    }

  private:
    [[nodiscard]] Tangent given_tangent(std::uint32_t corner) const {
        if (attributes_.tangent.empty()) return {};
        return {attributes_.tangent[corner], attributes_.tangent_sign[corner]};
    }

    /// Index of the scene's vertex. Without normals every triangle gets vertices, hence a flat normal, of its
    /// own.
    std::uint32_t vertex_for(std::uint32_t corner, const Vec3& geometric_normal, const Tangent& tangent) {
        if (attributes_.normal.empty()) return add_vertex(corner, geometric_normal, tangent);
        std::uint32_t* vertex = &vertex_of_[corner];
        if (*vertex != not_yet && !has_tangent(*vertex, tangent)) {
            const Vec3& d = tangent.direction;
            vertex = &twin_of_.try_emplace({corner, d.x, d.y, d.z, tangent.sign}, not_yet).first->second;
        }
        if (*vertex == not_yet) {
            const Vec3& normal = attributes_.normal[corner];
            *vertex = add_vertex(corner, normal == Vec3(0) ? geometric_normal : normal, tangent);
        }
        return *vertex;
    }

    [[nodiscard]] bool has_tangent(std::uint32_t vertex, const Tangent& tangent) const {
        return scene_.tangent[vertex] == tangent.direction && scene_.tangent_sign[vertex] == tangent.sign;
    }

    std::uint32_t add_vertex(std::uint32_t corner, const Vec3& normal, const Tangent& tangent) {
        if (scene_.position.size() >= not_yet) throw InputError("has more vertices than 32 bits can count");
        scene_.position.push_back(attributes_.position[corner]);
        scene_.bounds.extendBy(attributes_.position[corner]);
        scene_.normal.push_back(normal);
        scene_.tangent.push_back(tangent.direction);
        scene_.tangent_sign.push_back(tangent.sign);
        for (std::size_t set = 0; set < 2; ++set) {
            const std::vector<Vec2>& texcoord = attributes_.texcoord[set];
            scene_.texcoord[set].push_back(texcoord.empty() ? Vec2(0) : texcoord[corner]);
        }
        return static_cast<std::uint32_t>(scene_.position.size() - 1);
    }

    Scene& scene_;
    const Attributes& attributes_;
    std::vector<std::uint32_t> vertex_of_;
    /// Further vertices of the scene for one of the primitive's, by it and their tangent.
    std::map<std::tuple<std::uint32_t, float, float, float, float>, std::uint32_t> twin_of_;
};

/// Returns how many triangles had no area and were left out.
std::size_t append_triangles(std::span<const TriangleVertices> triangles, const Attributes& attributes,
                             std::span<const CornerTangents> made, Scene& scene) {
    InstanceWriter writer(scene, attributes);
    std::size_t left_out = 0;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const TriangleVertices& corners = triangles[t];
        const auto& position = attributes.position;
        const Vec3 normal = unit_normal(position[corners[0]], position[corners[1]], position[corners[2]]);
        if (normal == Vec3(0)) {
            ++left_out;
        } else {
            writer.add_triangle(corners, normal, made.empty() ? nullptr : &made[t]);
        }
    }
    return left_out;
}

void warn_about_missing_texcoords(const Material& material, const MeshInstance& instance,
                                  Warnings& warnings) {
    for (const TextureUse& use :
         {material.base_color_texture, material.normal_texture, material.emissive_texture}) {
        if (use.texture != no_texture && !instance.has_texcoord[use.texcoord_set])
            warnings.add(fmt::format("material reads TEXCOORD_{}, which is missing", use.texcoord_set),
                         instance.name);
    }
}

/// Whether the file says (in extras) that its normal map, say one made from heights, belongs to the
/// derivatives of each triangle's own texture coordinates.
bool is_normal_map_of_derivatives(const tinygltf::Model& model, int material) {
    if (material < 0) return false;
    const tinygltf::Value& extras = model.materials[static_cast<std::size_t>(material)].normalTexture.extras;
    return extras.Has("tangents") && extras.Get("tangents").IsString() &&
           extras.Get("tangents").Get<std::string>() == "derivatives";
}

/// Tangents for a normal map to which the file gives none (glTF 2.0, section 3.7.2.1); else none.
std::vector<CornerTangents> made_tangents(const Attributes& attributes,
                                          std::span<const TriangleVertices> triangles,
                                          const TextureUse& use) {
    if (use.texture == no_texture || !attributes.tangent.empty()) return {};
    std::vector<Vec2> texcoord = attributes.texcoord[use.texcoord_set];
    if (texcoord.empty() || !std::all_of(attributes.position.begin(), attributes.position.end(),
                                         [](const Vec3& p) { return is_finite(p); }))
        return {};
    for (Vec2& uv : texcoord) {
        uv = use.transform(uv);
        if (!is_finite(uv)) uv = Vec2(0);
    }
    return corner_tangents(attributes, texcoord, triangles);
}

/// Returns how many triangles had no area and were left out.
std::size_t append_instance(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                            const PlacedNode& node, const std::string& name, Scene& scene,
                            Warnings& warnings) {
    Attributes attributes = read_attributes(model, primitive);
    const auto vertex_count = static_cast<std::uint32_t>(attributes.position.size());
    std::vector<TriangleVertices> triangles = read_triangles(model, primitive, vertex_count);
    repair(attributes, name, warnings);
    if (attributes.normal.empty()) attributes.tangent.clear();  // glTF 2.0, section 3.7.2.1
    const std::uint32_t material = material_index(scene, primitive.material);
    std::vector<CornerTangents> tangents;
    if (!is_normal_map_of_derivatives(model, primitive.material))
        tangents = made_tangents(attributes, triangles, scene.material[material].normal_texture);
    to_world_space(attributes, triangles, node.to_world);
    to_world_space(tangents, node.to_world);

    MeshInstance instance{name,
                          static_cast<std::uint32_t>(scene.triangle.size()),
                          0,
                          material,
                          {!attributes.texcoord[0].empty(), !attributes.texcoord[1].empty()}};
    const std::size_t left_out = append_triangles(triangles, attributes, tangents, scene);
    instance.triangle_count = static_cast<std::uint32_t>(scene.triangle.size()) - instance.first_triangle;
    if (instance.triangle_count > 0) {
        if (primitive.material < 0) warnings.add(metal_warning, fmt::format("default material of {}", name));
        warn_about_missing_texcoords(scene.material[instance.material], instance, warnings);
        scene.instance.push_back(instance);
    }
    return left_out;
}

/// Whether there are triangles to read, with a warning where not, and about what they are read without.
bool is_readable(const tinygltf::Primitive& primitive, const std::string& name, Warnings& warnings) {
    if (!is_made_of_triangles(primitive)) {
        warnings.add("points or lines left out", name);
        return false;
    }
    if (!primitive.attributes.contains("POSITION")) {
        warnings.add("primitives without positions left out", name);
        return false;
    }
    if (!primitive.targets.empty()) warnings.add("morph targets ignored", name);
    return true;
}

}  // namespace

void append_meshes(const tinygltf::Model& model, std::span<const PlacedNode> nodes, Scene& scene,
                   Warnings& warnings) {
    std::size_t left_out = 0;
    for (const PlacedNode& placed : nodes) {
        const tinygltf::Node& node = model.nodes[static_cast<std::size_t>(placed.node)];
        if (node.mesh < 0) continue;
        if (node.skin >= 0)
            warnings.add("skin ignored, mesh in its rest pose", node_name(model, placed.node));
        const auto& primitives = model.meshes[static_cast<std::size_t>(node.mesh)].primitives;
        for (std::size_t i = 0; i < primitives.size(); ++i) {
            const std::string name = instance_name(model, node, i);
            if (!is_readable(primitives[i], name, warnings)) continue;
            try {
                left_out += append_instance(model, primitives[i], placed, name, scene, warnings);
            } catch (const InputError& error) {
                throw InputError(fmt::format("mesh '{}': {}", name, error.what()));
            }
        }
    }
    if (left_out > 0) warnings.add("zero-area triangles left out", std::to_string(left_out));
}

}  // namespace common::gltf
