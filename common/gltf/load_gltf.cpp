#include "common/gltf/load_gltf.h"

#include <fmt/format.h>

#include <vector>

#include "common/core/input_error.h"
#include "common/gltf/cameras.h"
#include "common/gltf/document.h"
#include "common/gltf/duplicates.h"
#include "common/gltf/far_places.h"
#include "common/gltf/lights.h"
#include "common/gltf/materials.h"
#include "common/gltf/meshes.h"
#include "common/gltf/placed_nodes.h"
#include "common/gltf/warnings.h"

namespace common {
namespace {

/// Appends the meshes. If they lie far from the origin, moves the nodes to another origin and appends them
/// again. This works as nodes are placed in double; only the stored geometry is in float.
void append_meshes_near_origin(const tinygltf::Model& model, std::vector<gltf::PlacedNode>& nodes,
                               Scene& scene, gltf::Warnings& warnings) {
    const gltf::Warnings before = warnings;
    const Imath::V3d origin = gltf::origin_for(gltf::append_meshes(model, nodes, scene, warnings));
    if (origin == Imath::V3d(0)) return;
    Scene moved;
    moved.source = scene.source;
    moved.material = std::move(scene.material);
    moved.texture = std::move(scene.texture);
    moved.origin = origin;
    scene = std::move(moved);
    warnings = before;
    gltf::move_origin(origin, nodes);
    (void)gltf::append_meshes(model, nodes, scene, warnings);
}

Scene read_scene(const std::filesystem::path& file) {
    gltf::Warnings warnings;
    const tinygltf::Model model = gltf::read_document(file, warnings);
    std::vector<gltf::PlacedNode> nodes = gltf::place_nodes(model);

    Scene scene;
    scene.source = file.string();
    gltf::append_materials(model, scene, warnings);
    append_meshes_near_origin(model, nodes, scene, warnings);
    gltf::leave_out_duplicates(scene, warnings);
    gltf::append_lights(model, nodes, scene, warnings);
    gltf::append_cameras(model, nodes, scene, warnings);
    if (scene.triangle.empty()) throw InputError("has no triangles");
    gltf::warn_about_far_instances(scene, warnings);
    scene.warnings = warnings.lines();
    return scene;
}

}  // namespace

Scene load_gltf(const std::filesystem::path& file) {
    try {
        return read_scene(file);
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", file.string(), gltf::one_line(error.what())));
    } catch (const std::bad_alloc&) {
        throw InputError(fmt::format("{}: needs more memory than there is", file.string()));
    }
}

}  // namespace common
