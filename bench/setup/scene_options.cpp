#include "bench/setup/scene_options.h"

#include <fmt/format.h>

#include <filesystem>
#include <numbers>
#include <set>

#include "bench/setup/command.h"
#include "bench/setup/numbers.h"
#include "common/core/input_error.h"
#include "common/gltf/load_gltf.h"
#include "common/view/place_camera.h"

namespace bench {
namespace {

using common::InputError;
using common::Rgb;
using common::Scene;
using common::Vec3;

Scene load_with_lights(const std::string& file, const SceneOptions& options) {
    Scene scene = common::load_gltf(file);
    if (!options.sky.empty()) {
        const auto rgb = parse_numbers("--sky", options.sky, 3);
        if (std::min({rgb[0], rgb[1], rgb[2]}) < 0) throw InputError("--sky: radiance cannot be negative");
        scene.sky = common::Sky{Rgb(Imath::V3d(rgb[0], rgb[1], rgb[2]))};
    }
    if (!options.sun.empty()) {
        const auto n = parse_numbers("--sun", options.sun, 6);
        const Vec3 towards(Imath::V3d(n[0], n[1], n[2]));
        if (towards.length() == 0)
            throw InputError("--sun: X,Y,Z is the direction to the sun and cannot be 0,0,0");
        if (std::min({n[3], n[4], n[5]}) < 0) throw InputError("--sun: irradiance cannot be negative");
        scene.directional_light.push_back(
            {-towards.normalized(), Rgb(Imath::V3d(n[3], n[4], n[5])), "the sun"});
    }
    return scene;
}

common::Camera choose_camera(const common::RayScene& rays, const SceneOptions& options) {
    if (!options.camera.empty()) {
        const auto n = parse_numbers("--camera", options.camera, 7);
        if (!(n[6] > 0 && n[6] < 180)) throw InputError("--camera: FOV must be between 0 and 180 degrees");
        const Imath::V3d& origin = rays.scene().origin;
        const Vec3 eye(Imath::V3d(n[0], n[1], n[2]) - origin), target(Imath::V3d(n[3], n[4], n[5]) - origin);
        if (eye == target) throw InputError("--camera: EYE and TARGET are the same point");
        return common::look_at(eye, target, static_cast<float>(n[6]) * std::numbers::pi_v<float> / 180);
    }
    const auto& cameras = rays.scene().camera;
    return cameras.empty() ? common::place_camera(rays) : cameras.front();
}

}  // namespace

void SceneOptions::add_to(Command& command) {
    command.option("--sky", sky, "Uniform environment: radiance R,G,B in W/(m^2 sr)");
    command.option("--sun", sun, "Parallel light: direction to it X,Y,Z and irradiance R,G,B in W/m^2");
    command.option("--camera", camera,
                   "EYE,TARGET,FOV as X,Y,Z,X,Y,Z,DEGREES in place of the scene's own camera");
}

LoadedScene::LoadedScene(const std::string& file, const SceneOptions& options)
    : name(std::filesystem::path(file).stem().string()),
      scene(load_with_lights(file, options)),
      rays(scene),
      camera(choose_camera(rays, options)) {}

void require_different_names(const std::vector<std::string>& files) {
    std::set<std::string> names;
    for (const std::string& file : files)
        if (const std::string name = std::filesystem::path(file).stem().string(); !names.insert(name).second)
            throw InputError(fmt::format("two scenes have the name {}", name));
}

}  // namespace bench
