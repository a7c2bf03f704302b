#include "common/reference/paths_not_found.h"

#include <fmt/format.h>

namespace common::reference {

std::string paths_not_found(const Scene& scene) {
    bool specular = false, bent = false;
    for (const MeshInstance& instance : scene.instance) {
        const SurfaceKind kind = scene.material[instance.material].kind;
        specular |= kind != SurfaceKind::diffuse;
        bent |= kind == SurfaceKind::mirror || kind == SurfaceKind::dielectric;
    }
    if (!specular) return "";
    std::string kinds;
    const auto add = [&](std::size_t count, const char* kind) {
        if (count > 0) kinds += fmt::format("{}{} {}", kinds.empty() ? "" : ", ", count, kind);
    };
    add(scene.point_light.size(), "point");
    add(scene.spot_light.size(), "spot");
    add(scene.directional_light.size(), "directional");
    return kinds.empty() ? ""
                         : fmt::format("light of {} lights by way of {}", kinds,
                                       bent ? "mirrors or glass" : "reflections in thin glass");
}

std::string paths_not_found(const ImageNotes& notes) {
    const auto note = notes.find(paths_not_found_note);
    return note == notes.end() || note->second == "none" ? "" : note->second;
}

}  // namespace common::reference
