// shlmbench_scenes OUT_DIR [NAME...]: writes the project's own scenes as NAME.glb, and room-SEED.glb.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <optional>

#include "bench/scenes/gltf_writer.h"
#include "bench/scenes/scenes.h"
#include "common/core/input_error.h"

namespace {

struct NamedScene {
    std::string name;
    std::function<scenes::SceneDescription()> make;
};

const std::vector<NamedScene>& own_scenes() {
    static const std::vector<NamedScene> list{{"cornell", scenes::make_cornell},
                                              {"bumpy", scenes::make_bumpy},
                                              {"caustic", scenes::make_caustic},
                                              {"atrium", scenes::make_atrium}};
    return list;
}

/// Returns the seed in a name such as room-SEED.
std::optional<std::uint32_t> seed_in(const std::string& name) {
    const std::string prefix = "room-";
    std::uint32_t seed = 0;
    if (!name.starts_with(prefix)) return std::nullopt;
    const char* const end = name.data() + name.size();
    const auto [rest, error] = std::from_chars(name.data() + prefix.size(), end, seed);
    if (error != std::errc() || rest != end || name != fmt::format("{}{}", prefix, seed)) return std::nullopt;
    return seed;
}

NamedScene find_scene(const std::string& name) {
    for (const NamedScene& scene : own_scenes())
        if (scene.name == name) return scene;
    if (const auto seed = seed_in(name)) return {name, [seed] { return scenes::make_random_room(*seed); }};
    throw common::InputError(fmt::format(
        "{}: no such scene; there are cornell, bumpy, caustic, atrium and room-SEED, such as room-17", name));
}

void write_scenes(const std::filesystem::path& directory, const std::vector<std::string>& names) {
    std::vector<NamedScene> wanted;
    for (const std::string& name : names) wanted.push_back(find_scene(name));
    if (wanted.empty()) wanted = own_scenes();

    std::error_code error;
    std::filesystem::create_directories(directory, error);
    if (error)
        throw common::InputError(
            fmt::format("{}: cannot make directory: {}", directory.string(), error.message()));
    for (const NamedScene& scene : wanted) {
        const std::filesystem::path file = directory / (scene.name + ".glb");
        scenes::write_glb(scene.make(), file);
        fmt::print("{}\n", file.string());
    }
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Writes the project's own test scenes as binary glTF.");
    std::string directory;
    std::vector<std::string> names;
    app.add_option("OUT_DIR", directory, "where the files go; made if missing")->required();
    app.add_option(
        "NAME", names,
        "scenes to write: cornell, bumpy, caustic, atrium, all of these if none is named; room-SEED: a "
        "random room");
    try {
        app.parse(argc, argv);
        write_scenes(directory, names);
        return 0;
    } catch (const CLI::CallForHelp& help) {
        return app.exit(help);
    } catch (const std::exception& error) {
        fmt::print(stderr, "shlmbench_scenes: {}\n", error.what());
        return 2;
    }
}
