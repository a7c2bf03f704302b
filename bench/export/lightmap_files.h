// The light map alone, in files that other programs read: lightmap.exr, lightmap.npy and lightmap.json.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "bench/export/exported_map.h"

namespace bench {

/// One part. R, G, B: irradiance of the texel's own normal, W/m^2, never negative, which image viewers show:
/// the traditional light map. Then a channel for each number (shlm::Basis::number_name), light in W/m^2;
/// covered.A, 1 where a triangle covers the texel; hits, never rounded. The header has basis, formula, unit
/// and provenance.
void write_lightmap_exr(const std::filesystem::path& file, const ExportedMap& map, const LightAtlas& atlas,
                        const ExportedRun& run);

/// NumPy's format: float16, height x width x numbers, light in the unit that lightmap.json says.
void write_lightmap_npy(const std::filesystem::path& file, const ExportedMap& map, const LightAtlas& atlas);

/// What lightmap.json and the page's data say of a map: method, basis, names of numbers, formula, unit.
[[nodiscard]] nlohmann::ordered_json description_of(const ExportedMap& map);
[[nodiscard]] nlohmann::ordered_json description_of(const LightAtlas& atlas);

}  // namespace bench
