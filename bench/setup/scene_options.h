// The options that every command on a scene takes, and the scene they give.
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

/// A scene ready to trace and to look at. Its parts point at each other, so it stays where it is.
struct LoadedScene {
    std::string name;  ///< of the file, without folder and extension
    common::Scene scene;
    common::RayScene rays;
    common::Camera camera;

    LoadedScene(const std::string& file, const SceneOptions& options);
    LoadedScene(const LoadedScene&) = delete;
    LoadedScene& operator=(const LoadedScene&) = delete;
};

/// Numbers separated by commas. Throws InputError, naming the option, unless there are `count` of them, all
/// finite.
[[nodiscard]] std::vector<float> parse_numbers(const std::string& option, const std::string& text,
                                               std::size_t count);

/// "1e6", "250000". Throws InputError, naming the option, unless it is a whole number from 1 to 1e15.
[[nodiscard]] std::uint64_t parse_count(const std::string& option, const std::string& text);

/// "60s", "5min", "1h". Throws InputError, naming the option, for anything else.
[[nodiscard]] double parse_seconds(const std::string& option, const std::string& text);

/// "0.1%" is 0.001. Throws InputError, naming the option, unless it is more than 0 % and less than 100 %.
[[nodiscard]] double parse_percentage(const std::string& option, const std::string& text);

/// Several of them, ascending, each once.
[[nodiscard]] std::vector<std::uint64_t> parse_sizes(const std::string& option,
                                                     const std::vector<std::string>& texts);

/// Rows, charts and images go by a scene's name: throws InputError where two files have the same.
void require_different_names(const std::vector<std::string>& files);

/// "20GiB", "512MiB", "1000000". Throws InputError, naming the option, for anything else.
[[nodiscard]] std::size_t parse_bytes(const std::string& option, const std::string& text);

}  // namespace bench
