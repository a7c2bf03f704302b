#include "common/gltf/meshes.h"

#include <fmt/format.h>

#include <limits>
#include <string>

#include "common/core/input_error.h"
#include "common/gltf/materials.h"
#include "common/gltf/primitive.h"
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

    void add_triangle(const TriangleVertices& corners, const Vec3& geometric_normal) {
        TriangleVertices triangle;
        for (std::size_t i = 0; i < 3; ++i) triangle[i] = vertex_for(corners[i], geometric_normal);
        if (scene_.triangle.size() >= not_yet) throw InputError("has more triangles than 32 bits can count");
        scene_.triangle.push_back(triangle);
        scene_.geometric_normal.push_back(geometric_normal);
        scene_.instance_of.push_back(static_cast<std::uint32_t>(scene_.instance.size()));
    }

  private:
    /// Index of the scene's vertex. Without normals every triangle gets vertices, hence a flat normal, of its
    /// own.
    std::uint32_t vertex_for(std::uint32_t corner, const Vec3& geometric_normal) {
        if (attributes_.normal.empty()) return add_vertex(corner, geometric_normal);
        std::uint32_t& vertex = vertex_of_[corner];
        if (vertex == not_yet) {
            const Vec3& normal = attributes_.normal[corner];
            vertex = add_vertex(corner, normal == Vec3(0) ? geometric_normal : normal);
        }
        return vertex;
    }

    std::uint32_t add_vertex(std::uint32_t corner, const Vec3& normal) {
        if (scene_.position.size() >= not_yet) throw InputError("has more vertices than 32 bits can count");
        const bool has_tangent = !attributes_.tangent.empty();
        scene_.position.push_back(attributes_.position[corner]);
        scene_.bounds.extendBy(attributes_.position[corner]);
        scene_.normal.push_back(normal);
        scene_.tangent.push_back(has_tangent ? attributes_.tangent[corner] : Vec3(0));
        scene_.tangent_sign.push_back(has_tangent ? attributes_.tangent_sign[corner] : 1.0f);
        for (std::size_t set = 0; set < 2; ++set) {
            const std::vector<Vec2>& texcoord = attributes_.texcoord[set];
            scene_.texcoord[set].push_back(texcoord.empty() ? Vec2(0) : texcoord[corner]);
        }
        return static_cast<std::uint32_t>(scene_.position.size() - 1);
    }

    Scene& scene_;
    const Attributes& attributes_;
    std::vector<std::uint32_t> vertex_of_;
};

/// What became of triangles.
struct AppendedTriangles {
    std::size_t left_out = 0;  ///< had no area
    Imath::Box3f bounds;       ///< of all, those left out too
};

void append_triangles(std::span<const TriangleVertices> triangles, const Attributes& attributes, Scene& scene,
                      AppendedTriangles& appended) {
    InstanceWriter writer(scene, attributes);
    for (const TriangleVertices& corners : triangles) {
        const auto& position = attributes.position;
        for (const std::uint32_t corner : corners) appended.bounds.extendBy(position[corner]);
        const Vec3 normal = unit_normal(position[corners[0]], position[corners[1]], position[corners[2]]);
        if (normal == Vec3(0)) {
            ++appended.left_out;
        } else {
            writer.add_triangle(corners, normal);
        }
    }
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

void append_instance(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                     const PlacedNode& node, const std::string& name, Scene& scene, Warnings& warnings,
                     AppendedTriangles& appended) {
    Attributes attributes = read_attributes(model, primitive);
    const auto vertex_count = static_cast<std::uint32_t>(attributes.position.size());
    std::vector<TriangleVertices> triangles = read_triangles(model, primitive, vertex_count);
    repair(attributes, name, warnings);
    to_world_space(attributes, triangles, node.to_world);

    MeshInstance instance{name,
                          static_cast<std::uint32_t>(scene.triangle.size()),
                          0,
                          material_index(scene, primitive.material),
                          {!attributes.texcoord[0].empty(), !attributes.texcoord[1].empty()}};
    append_triangles(triangles, attributes, scene, appended);
    instance.triangle_count = static_cast<std::uint32_t>(scene.triangle.size()) - instance.first_triangle;
    if (instance.triangle_count > 0) {
        warn_about_missing_texcoords(scene.material[instance.material], instance, warnings);
        scene.instance.push_back(instance);
    }
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

Imath::Box3f append_meshes(const tinygltf::Model& model, std::span<const PlacedNode> nodes, Scene& scene,
                           Warnings& warnings) {
    AppendedTriangles appended;
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
                append_instance(model, primitives[i], placed, name, scene, warnings, appended);
            } catch (const InputError& error) {
                throw InputError(fmt::format("mesh '{}': {}", name, error.what()));
            }
        }
    }
    if (appended.left_out > 0)
        warnings.add("zero-area triangles left out", std::to_string(appended.left_out));
    return appended.bounds;
}

}  // namespace common::gltf
