// Makes texels by lightmap coordinates, for scenes that have them.
#pragma once

#include "shlm/layout/prepared_texels.h"

namespace tests {

inline shlm::PreparedTexels texels_of(const common::Scene& scene, std::size_t count) {
    return {scene, shlm::find_lightmap_uv(scene), count};
}

}  // namespace tests
