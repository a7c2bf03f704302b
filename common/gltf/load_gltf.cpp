#include "common/gltf/load_gltf.h"

#include <fmt/format.h>

#include <vector>

#include "common/core/input_error.h"
#include "common/gltf/cameras.h"
#include "common/gltf/document.h"
#include "common/gltf/duplicates.h"
#include "common/gltf/lights.h"
#include "common/gltf/materials.h"
#include "common/gltf/meshes.h"
#include "common/gltf/placed_nodes.h"
#include "common/gltf/warnings.h"

namespace common {
namespace {

Scene read_scene(const std::filesystem::path& file) {
    gltf::Warnings warnings;
    const tinygltf::Model model = gltf::read_document(file, warnings);
    const std::vector<gltf::PlacedNode> nodes = gltf::place_nodes(model);

    Scene scene;
    scene.source = file.string();
    gltf::append_materials(model, scene, warnings);
    gltf::append_meshes(model, nodes, scene, warnings);
    gltf::leave_out_duplicates(scene, warnings);
    gltf::append_lights(model, nodes, scene, warnings);
    gltf::append_cameras(model, nodes, scene, warnings);
    if (scene.triangle.empty()) throw InputError("has no triangles");
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
