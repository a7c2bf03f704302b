// shlmbench_scenes OUT_DIR [NAME...]: writes the project's own scenes as NAME.glb.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>

#include "bench/scenes/gltf_writer.h"
#include "bench/scenes/scenes.h"
#include "common/core/input_error.h"

namespace {

struct NamedScene {
    std::string name;
    scenes::SceneDescription (*make)();
};

const std::vector<NamedScene>& all_scenes() {
    static const std::vector<NamedScene> list{{"cornell", scenes::make_cornell},
                                              {"bumpy", scenes::make_bumpy},
                                              {"caustic", scenes::make_caustic},
                                              {"atrium", scenes::make_atrium}};
    return list;
}

const NamedScene& find_scene(const std::string& name) {
    for (const NamedScene& scene : all_scenes())
        if (scene.name == name) return scene;
    throw common::InputError(
        fmt::format("{}: no such scene; there are cornell, bumpy, caustic and atrium", name));
}

void write_scenes(const std::filesystem::path& directory, const std::vector<std::string>& names) {
    std::vector<NamedScene> wanted;
    for (const std::string& name : names) wanted.push_back(find_scene(name));
    if (wanted.empty()) wanted = all_scenes();

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
    app.add_option("NAME", names, "scenes to write: cornell, bumpy, caustic, atrium; all if none is named");
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
