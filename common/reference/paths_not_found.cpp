#include "common/reference/paths_not_found.h"

#include <fmt/format.h>

#include <algorithm>

namespace common::reference {

std::string paths_not_found(const Scene& scene) {
    const bool specular = std::ranges::any_of(scene.instance, [&](const MeshInstance& instance) {
        return scene.material[instance.material].kind != SurfaceKind::diffuse;
    });
    if (!specular) return "";
    std::string kinds;
    const auto add = [&](std::size_t count, const char* kind) {
        if (count > 0) kinds += fmt::format("{}{} {}", kinds.empty() ? "" : ", ", count, kind);
    };
    add(scene.point_light.size(), "point");
    add(scene.spot_light.size(), "spot");
    add(scene.directional_light.size(), "directional");
    return kinds.empty() ? "" : fmt::format("light of {} lights by way of mirrors or glass", kinds);
}

std::string paths_not_found(const ImageNotes& notes) {
    const auto note = notes.find(paths_not_found_note);
    return note == notes.end() || note->second == "none" ? "" : note->second;
}

}  // namespace common::reference
