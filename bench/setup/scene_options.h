// Options that every command on a scene takes, and the scene that they describe.
#pragma once

#include <memory>
#include <string>

#include "bench/setup/command.h"
#include "common/tracer/photon_source.h"
#include "common/tracer/ray_scene.h"

namespace bench {

struct SceneOptions {
    std::string sky;     ///< "R,G,B"
    std::string sun;     ///< "X,Y,Z,R,G,B"
    std::string camera;  ///< "EYE,TARGET,FOV" as seven numbers

    void add_to(Command& command);
};

/// A scene ready to trace and to view. Its members refer to each other, so it is not movable.
struct LoadedScene {
    std::string name;  ///< of the file, without folder and extension
    common::Scene scene;
    common::RayScene rays;
    common::Camera camera;

    LoadedScene(const std::string& file, const SceneOptions& options);
    LoadedScene(const LoadedScene&) = delete;
    LoadedScene& operator=(const LoadedScene&) = delete;
};

/// Throws InputError where two files have the same name, since rows, charts and images are identified by it.
void require_different_names(const std::vector<std::string>& files);

}  // namespace bench
