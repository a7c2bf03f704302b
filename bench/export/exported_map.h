// A light map on its way to other programs.
#pragma once

#include "bench/contenders/light_map_names.h"
#include "bench/export/expanded_map.h"
#include "bench/export/light_atlas.h"

namespace bench {

/// What it costs to hand on an adaptive map as texels.
struct Expansion {
    std::size_t bytes_of_map, bytes_of_texels;
    double relative_rms;  ///< of the texels' answers beside the map's own, at the points that the camera sees
};

struct ExportedMap {
    Contender method;
    StoredTexels texels;
    std::optional<Expansion> expansion{};  ///< of an adaptive map

    /// Returns what the texels keep.
    [[nodiscard]] const LightBasis& basis() const {
        return expansion ? basis_named(ExpandedMap::basis) : *method.light_map()->setting().basis;
    }
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
