// A light map on its way to other programs.
#pragma once

#include "bench/contenders/light_map.h"
#include "bench/export/light_atlas.h"

namespace bench {

struct ExportedMap {
    Contender method;
    StoredTexels texels;

    [[nodiscard]] const LightBasis& basis() const { return *method.light_map()->setting().basis; }
};

/// What others are told of where a map comes from.
struct ExportedRun {
    std::string scene;        ///< name
    std::string fingerprint;  ///< common::fingerprint of the scene
    std::uint64_t seed = 0, hits = 0, photons = 0;
};

/// Throws InputError, naming the method, where a number is not finite: filtering and exposure would spread it
/// over the whole picture.
void require_finite(const ExportedMap& map);

}  // namespace bench
