#include "bench/setup/scene_options.h"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <limits>
#include <numbers>
#include <set>

#include "bench/setup/command.h"
#include "common/core/input_error.h"
#include "common/gltf/load_gltf.h"
#include "common/view/place_camera.h"

namespace bench {
namespace {

using common::InputError;
using common::Scene;
using common::Vec3;

/// The number at the start of `text`, which it is taken off. Throws InputError where there is none.
double take_number(const std::string& option, std::string_view& text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || !std::isfinite(value))
        throw InputError(fmt::format("{}: '{}' is not a number", option, text));
    text.remove_prefix(end - text.data());
    return value;
}

Scene load_with_lights(const std::string& file, const SceneOptions& options) {
    Scene scene = common::load_gltf(file);
    if (!options.sky.empty()) {
        const auto rgb = parse_numbers("--sky", options.sky, 3);
        if (std::min({rgb[0], rgb[1], rgb[2]}) < 0) throw InputError("--sky: radiance cannot be negative");
        scene.sky = common::Sky{{rgb[0], rgb[1], rgb[2]}};
    }
    if (!options.sun.empty()) {
        const auto n = parse_numbers("--sun", options.sun, 6);
        const Vec3 towards(n[0], n[1], n[2]);
        if (towards.length() == 0)
            throw InputError("--sun: X,Y,Z is the direction to the sun and cannot be 0,0,0");
        if (std::min({n[3], n[4], n[5]}) < 0) throw InputError("--sun: irradiance cannot be negative");
        scene.directional_light.push_back({-towards.normalized(), {n[3], n[4], n[5]}, "the sun"});
    }
    return scene;
}

/// As parse_numbers.
std::vector<double> parse_doubles(const std::string& option, const std::string& text, std::size_t count) {
    std::vector<double> numbers;
    std::string_view rest = text;
    while (true) {
        const double number = take_number(option, rest);
        if (std::abs(number) > std::numeric_limits<float>::max())
            throw InputError(fmt::format("{}: '{}' has a number that is too large", option, text));
        numbers.push_back(number);
        if (rest.empty()) break;
        if (rest.front() != ',')
            throw InputError(fmt::format("{}: numbers are separated by commas in '{}'", option, text));
        rest.remove_prefix(1);
    }
    if (numbers.size() != count)
        throw InputError(
            fmt::format("{}: {} numbers are needed, '{}' has {}", option, count, text, numbers.size()));
    return numbers;
}

common::Camera choose_camera(const common::RayScene& rays, const SceneOptions& options) {
    if (!options.camera.empty()) {
        const auto n = parse_doubles("--camera", options.camera, 7);
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

std::vector<float> parse_numbers(const std::string& option, const std::string& text, std::size_t count) {
    const std::vector<double> numbers = parse_doubles(option, text, count);
    std::vector<float> floats(numbers.size());
    std::transform(numbers.begin(), numbers.end(), floats.begin(),
                   [](double number) { return static_cast<float>(number); });
    return floats;
}

std::uint64_t parse_count(const std::string& option, const std::string& text) {
    std::string_view rest = text;
    const double value = take_number(option, rest);
    if (!rest.empty() || !(value >= 1 && value <= 1e15) || value != std::floor(value))
        throw InputError(fmt::format("{}: '{}' is not a whole number from 1 to 1e15", option, text));
    return static_cast<std::uint64_t>(value);
}

double parse_seconds(const std::string& option, const std::string& text) {
    std::string_view rest = text;
    const double value = take_number(option, rest);
    const double unit = rest == "s" ? 1 : rest == "min" ? 60 : rest == "h" ? 3600 : 0;
    if (unit == 0 || !(value >= 0 && value * unit < 1e9))
        throw InputError(fmt::format("{}: '{}' is not a time such as 60s, 5min or 1h", option, text));
    return value * unit;
}

double parse_percentage(const std::string& option, const std::string& text) {
    if (!text.ends_with('%'))
        throw InputError(fmt::format("{}: '{}' is not a percentage such as 0.1%", option, text));
    const double percent = parse_numbers(option, text.substr(0, text.size() - 1), 1).front();
    if (!(percent > 0 && percent < 100))
        throw InputError(fmt::format("{}: more than 0% and less than 100%", option));
    return percent / 100;
}

std::vector<std::uint64_t> parse_sizes(const std::string& option, const std::vector<std::string>& texts) {
    std::set<std::uint64_t> sizes;
    for (const std::string& text : texts) sizes.insert(parse_count(option, text));
    return {sizes.begin(), sizes.end()};
}

void require_different_names(const std::vector<std::string>& files) {
    std::set<std::string> names;
    for (const std::string& file : files)
        if (const std::string name = std::filesystem::path(file).stem().string(); !names.insert(name).second)
            throw InputError(fmt::format("two scenes have the name {}", name));
}

std::size_t parse_bytes(const std::string& option, const std::string& text) {
    std::string_view rest = text;
    const double value = take_number(option, rest);
    const double unit = rest == "GiB" ? 0x1p30 : rest == "MiB" ? 0x1p20 : rest.empty() ? 1 : 0;
    if (unit == 0 || !(value * unit >= 1 && value * unit < 0x1p62))
        throw InputError(fmt::format("{}: '{}' is not a size such as 512MiB or 20GiB", option, text));
    return static_cast<std::size_t>(value * unit);
}

}  // namespace bench
