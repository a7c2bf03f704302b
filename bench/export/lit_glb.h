// lit.glb: the scene as shlmbench sees it, with its light map, for other programs and for the viewer.
#pragma once

#include <span>
#include <string>

#include "bench/export/exported_map.h"
#include "bench/export/lit_mesh.h"

namespace bench {

/// What lit.glb has beside plain glTF, by name. Files list it as used, never as required.
inline constexpr const char* lightmap_extension = "SHLM_lightmap";

struct LitScene {
    const LoadedScene& loaded;
    const LightAtlas& atlas;
    std::span<const LitPrimitive> primitives;
    std::span<const ExportedMap> maps;  ///< of the atlas's texels, at least one; the first is the light map
    const ExportedRun& run;
};

/// Binary glTF 2.0. Each front and back is a primitive of its own, in world space: POSITION, NORMAL, TANGENT
/// with normal maps, TEXCOORD_0 (base colour; further sets are TEXCOORD_2 and 3 where a material's textures
/// are read elsewhere), TEXCOORD_1 (the light map), _LIGHTMAP_RECT (LitPrimitive::light_rectangle), COLOR_0.
/// Lit materials have MOZ_lightmap: irradiance of the texel's own normal, linear, 8 bits, its largest value
/// as intensity. Lights are left out, as the map has their light.
///
/// The extension at the top has the place in the file's coordinates that is (0, 0, 0) here
/// (common::Scene::origin), and the maps' numbers: buffer views of RGBA halves, layer by layer as many as
/// hold a texel's numbers, rows from the top; "faces", RGBA floats: unit normal and covered area, 0 where no
/// triangle covers the texel; "hits", floats.
///
/// Throws InputError where tinygltf cannot write it.
[[nodiscard]] std::string lit_glb(const LitScene& scene);

}  // namespace bench
