#include "common/gltf/meshes.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "common/core/input_error.h"
#include "common/core/memory_use.h"
#include "common/gltf/compression.h"
#include "common/gltf/materials.h"
#include "common/gltf/mesh_instances.h"
#include "common/gltf/morph_targets.h"
#include "common/gltf/not_drawn.h"
#include "common/gltf/primitive.h"
#include "common/gltf/skins.h"
#include "common/gltf/tangents.h"
#include "common/gltf/vertex_colors.h"
#include "common/gltf/world_space.h"

namespace common::gltf {
namespace {

constexpr std::uint32_t not_yet = std::numeric_limits<std::uint32_t>::max();

/// Returns a primitive's name in the scene: the node's or mesh's, numbered if the mesh has several.
std::string instance_name(const tinygltf::Model& model, const tinygltf::Node& node, std::size_t primitive) {
    const tinygltf::Mesh& mesh = model.meshes[static_cast<std::size_t>(node.mesh)];
    std::string name = node.name.empty() ? mesh.name : node.name;
    if (name.empty()) name = fmt::format("meshes/{}", node.mesh);
    return mesh.primitives.size() > 1 ? fmt::format("{}/{}", name, primitive) : name;
}

/// Copies a primitive's triangles, already in world space, to the end of the scene.
class InstanceWriter {
  public:
    InstanceWriter(Scene& scene, const Attributes& attributes, const VertexColors& colors)
        : scene_(scene),
          attributes_(attributes),
          colors_(colors),
          writes_colors_(!colors.color.empty() || !scene.color.empty()),
          vertex_of_(attributes.position.size(), not_yet) {
        if (!writes_colors_ || !scene.color.empty()) return;
        // These are the scene's first colours: all earlier vertices are white.
        scene.color.assign(scene.position.size(), Rgb(1, 1, 1));
        scene.alpha.assign(scene.position.size(), 1.0f);
    }

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

    /// Returns the index of the vertex in the scene. Without normals in the file, every triangle gets its own
    /// vertices, and thus a flat normal.
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
        if (writes_colors_) {
            const bool has_color = !colors_.color.empty();
            scene_.color.push_back(has_color ? colors_.color[corner] : Rgb(1, 1, 1));
            scene_.alpha.push_back(has_color ? colors_.alpha[corner] : 1.0f);
        }
        return static_cast<std::uint32_t>(scene_.position.size() - 1);
    }

    Scene& scene_;
    const Attributes& attributes_;
    const VertexColors& colors_;
    bool writes_colors_;
    std::vector<std::uint32_t> vertex_of_;
    /// Further scene vertices of the same primitive vertex, by that vertex and their tangent.
    std::map<std::tuple<std::uint32_t, float, float, float, float>, std::uint32_t> twin_of_;
};

/// The result of appending triangles.
struct AppendedTriangles {
    std::size_t left_out = 0;  ///< number of triangles without area
    Imath::Box3f bounds;       ///< of all triangles, including those left out
};

void append_triangles(std::span<const TriangleVertices> triangles, const Attributes& attributes,
                      std::span<const CornerTangents> made, const VertexColors& colors, Scene& scene,
                      AppendedTriangles& appended) {
    InstanceWriter writer(scene, attributes, colors);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const TriangleVertices& corners = triangles[t];
        const auto& position = attributes.position;
        for (const std::uint32_t corner : corners) appended.bounds.extendBy(position[corner]);
        const Vec3 normal = unit_normal(position[corners[0]], position[corners[1]], position[corners[2]]);
        if (normal == Vec3(0)) {
            ++appended.left_out;
        } else {
            writer.add_triangle(corners, normal, made.empty() ? nullptr : &made[t]);
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

/// Returns whether the file states (in extras) that its normal map refers to the derivatives of each
/// triangle's own texture coordinates, as a map made from heights does.
bool is_normal_map_of_derivatives(const tinygltf::Model& model, int material) {
    if (material < 0) return false;
    const tinygltf::Value& extras = model.materials[static_cast<std::size_t>(material)].normalTexture.extras;
    return extras.Has("tangents") && extras.Get("tangents").IsString() &&
           extras.Get("tangents").Get<std::string>() == "derivatives";
}

/// Returns tangents for a normal map whose file gives none (glTF 2.0, section 3.7.2.1), else nothing.
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

/// A primitive as the file has it: its triangles, and the vertices that they use, in the space of the node.
struct PrimitiveGeometry {
    std::string name;
    PrimitiveTriangles triangles;
    Attributes attributes;
    std::vector<CornerTangents> tangents;  ///< made for its normal map, one per triangle; or none
    VertexColors colors;
    std::uint32_t material;
};

/// Appends the meshes of one model to one scene.
class MeshAppender {
  public:
    MeshAppender(const tinygltf::Model& model, std::span<const PlacedNode> nodes, Scene& scene,
                 Warnings& warnings)
        : model_(model),
          scene_(scene),
          warnings_(warnings),
          triangles_(accessors_),
          skins_(model, nodes, accessors_) {}

    void append_mesh(const PlacedNode& placed) {
        const tinygltf::Node& node = model_.nodes[static_cast<std::size_t>(placed.node)];
        const tinygltf::Mesh& mesh = model_.meshes[static_cast<std::size_t>(node.mesh)];
        for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
            const std::string name = instance_name(model_, node, i);
            try {
                if (is_readable(mesh.primitives[i], name))
                    append_primitive(mesh.primitives[i], rest_weights(mesh, node), placed, name);
            } catch (const InputError& error) {
                throw InputError(fmt::format("mesh '{}': {}", name, error.what()));
            }
        }
    }

    [[nodiscard]] const AppendedTriangles& appended() const { return appended_; }

  private:
    /// Returns whether there are triangles to read; warns if not.
    [[nodiscard]] bool is_readable(const tinygltf::Primitive& primitive, const std::string& name) {
        check_compression(model_, primitive);
        if (!is_made_of_triangles(primitive)) {
            warnings_.add("points or lines left out", name);
            return false;
        }
        if (!primitive.attributes.contains("POSITION")) {
            warnings_.add("primitives without positions left out", name);
            return false;
        }
        return true;
    }

    void append_primitive(const tinygltf::Primitive& primitive, std::span<const double> weights,
                          const PlacedNode& placed, const std::string& name) {
        PrimitiveGeometry geometry{
            name, triangles_.read(primitive), {}, {}, {}, material_index(scene_, primitive.material)};
        if (geometry.triangles.triangle.empty()) return;
        const std::vector<std::uint32_t>& vertices = geometry.triangles.vertex;
        geometry.attributes = read_attributes(accessors_, primitive, vertices);
        morph(accessors_, primitive, weights, vertices, geometry.attributes, name, warnings_);
        repair(geometry.attributes, name, warnings_);
        if (geometry.attributes.normal.empty())
            geometry.attributes.tangent.clear();  // as glTF 2.0, section 3.7.2.1, requires

        geometry.colors = read_vertex_colors(accessors_, model_, primitive,
                                             scene_.material[geometry.material], vertices, name, warnings_);

        const MeshInstances instances(model_, placed, accessors_, warnings_);
        if (append_skinned(primitive, placed, geometry)) {
            if (instances.are_listed()) warnings_.add("instances of a mesh with a skin drawn as one", name);
            return;
        }
        make_tangents(primitive, geometry);
        check_room(geometry, instances.count());
        for (std::size_t i = 0; i < instances.count(); ++i) {
            PrimitiveGeometry instance = i + 1 == instances.count() ? std::move(geometry) : geometry;
            if (instances.are_listed()) instance.name = fmt::format("{}[{}]", name, i);
            to_world_space(instance.attributes, instance.triangles.triangle, instances.to_world(i));
            to_world_space(instance.tangents, instances.to_world(i));
            append(instance);
        }
    }

    /// Returns false if the node has no skin, or one that cannot be used.
    [[nodiscard]] bool append_skinned(const tinygltf::Primitive& primitive, const PlacedNode& placed,
                                      PrimitiveGeometry& geometry) {
        const int skin = model_.nodes[static_cast<std::size_t>(placed.node)].skin;
        if (skin < 0) return false;
        const std::vector<Imath::M44d> joints = skins_.joints_to_world(skin);
        if (joints.empty() || !has_joints(primitive)) {
            warnings_.add("skins ignored whose joints are not in the scene or move no vertex", geometry.name);
            return false;
        }
        to_world_space(geometry.attributes, geometry.triangles.triangle,
                       vertices_to_world(accessors_, primitive, joints, geometry.triangles.vertex,
                                         geometry.name, warnings_));
        make_tangents(primitive, geometry);
        append(geometry);
        return true;
    }

    void make_tangents(const tinygltf::Primitive& primitive, PrimitiveGeometry& geometry) const {
        if (!is_normal_map_of_derivatives(model_, primitive.material))
            geometry.tangents = made_tangents(geometry.attributes, geometry.triangles.triangle,
                                              scene_.material[geometry.material].normal_texture);
    }

    /// Checks that the instances fit, before any memory is allocated: a short file can ask for very many.
    void check_room(const PrimitiveGeometry& geometry, std::size_t instances) const {
        const std::size_t triangles = geometry.triangles.triangle.size();
        if (instances == 1 || triangles == 0) return;
        // An upper estimate: 56 bytes per vertex, 28 per triangle, some hundred per instance; lists double as
        // they grow.
        const double needed = static_cast<double>(instances) * (500.0 * static_cast<double>(triangles) + 500);
        if (needed > static_cast<double>(available_bytes()))
            throw InputError(fmt::format("{} instances of {} triangles need more memory than there is",
                                         instances, triangles));
    }

    /// Appends geometry that is in world space.
    void append(const PrimitiveGeometry& geometry) {
        const Attributes& attributes = geometry.attributes;
        MeshInstance instance{geometry.name,
                              static_cast<std::uint32_t>(scene_.triangle.size()),
                              0,
                              geometry.material,
                              {!attributes.texcoord[0].empty(), !attributes.texcoord[1].empty()}};
        append_triangles(geometry.triangles.triangle, attributes, geometry.tangents, geometry.colors, scene_,
                         appended_);
        instance.triangle_count =
            static_cast<std::uint32_t>(scene_.triangle.size()) - instance.first_triangle;
        if (instance.triangle_count == 0) return;
        if (geometry.material == material_index(scene_, -1))
            warnings_.add(metal_warning, fmt::format("default material of {}", geometry.name));
        warn_about_missing_texcoords(scene_.material[instance.material], instance, warnings_);
        scene_.instance.push_back(instance);
    }

    const tinygltf::Model& model_;
    Scene& scene_;
    Warnings& warnings_;
    AccessorReader accessors_{model_};
    TriangleReader triangles_;
    Skins skins_;
    AppendedTriangles appended_;
};

}  // namespace

Imath::Box3f append_meshes(const tinygltf::Model& model, std::span<const PlacedNode> nodes, Scene& scene,
                           Warnings& warnings) {
    MeshAppender appender(model, nodes, scene, warnings);
    for (const PlacedNode& placed : nodes) {
        if (placed.is_visible && model.nodes[static_cast<std::size_t>(placed.node)].mesh >= 0)
            appender.append_mesh(placed);
    }
    const AppendedTriangles& appended = appender.appended();
    if (appended.left_out > 0)
        warnings.add("zero-area triangles left out", std::to_string(appended.left_out));
    return appended.bounds;
}

}  // namespace common::gltf
