// Reads files that may come from anybody. Each function returns the line with which the file is refused, or
// nothing if it is sound.
#pragma once

#include <filesystem>
#include <string>

#include "common/core/input_error.h"
#include "common/gltf/load_gltf.h"
#include "common/scene/fingerprint.h"
#include "common/tracer/photon_source.h"
#include "shlm/file/map_file.h"
#include "shlm/layout/prepared_texels.h"

namespace fuzz {

/// Does everything that commands do with a scene before they trace.
inline std::string trouble_of_scene(const std::filesystem::path& file) {
    constexpr std::size_t many = 100'000;  // triangles: more are slow and test nothing new
    try {
        const common::Scene scene = common::load_gltf(file);
        if (scene.triangle.size() > many) return {};
        (void)common::fingerprint(scene);
        const auto uv = shlm::find_lightmap_uv(scene);
        (void)shlm::describe_lightmap_trouble(scene, uv);
        for (const auto placement : {shlm::TexelPlacement::uv, shlm::TexelPlacement::face})
            const shlm::PreparedTexels texels(scene, uv, 64, placement);
        const common::PhotonSource source(scene);
    } catch (const common::InputError& error) {
        return error.what();
    }
    return {};
}

/// Reads the file as a continued run and a merge do.
inline std::string trouble_of_checkpoint(const std::filesystem::path& file) {
    constexpr std::size_t many = 1 << 20;  // pixels
    try {
        shlm::MapFileReader in(file);
        if (in.size().pixels() > many) return {};
        (void)shlm::MapIdentity{}.difference(in.run().identity);
        (void)in.run().report();
        std::vector<std::int64_t> planes(3 * in.size().pixels());
        for (std::uint64_t number = 0; number < in.size().numbers; ++number) in.read_number(planes);
        in.read_hits(std::span(planes).first(in.size().pixels()));
        in.check();
    } catch (const common::InputError& error) {
        return error.what();
    }
    return {};
}

}  // namespace fuzz
