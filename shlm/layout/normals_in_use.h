// Which normals a light map will be asked for.
#pragma once

#include <vector>

#include "shlm/layout/texel_layout.h"

namespace shlm {

/// Cosine of the degree within which normals count as one.
inline constexpr float straight_cosine = 0.99985f;

/// Shading normals all over one region of the layout.
struct NormalsInUse {
    /// Unit, in a frame whose z is the surface's normal there: some, each for the same share of the area.
    /// Empty where none of them is bent: there the irradiance of the surface itself is all that is asked for.
    std::vector<common::Vec3> bent;

    /// Mean over them.
    [[nodiscard]] float sine_sq() const {
        float sum = 0;
        for (const common::Vec3& normal : bent) sum += 1 - normal.z * normal.z;
        return bent.empty() ? 0 : sum / static_cast<float>(bent.size());
    }
};

/// One entry per region of the layout.
[[nodiscard]] std::vector<NormalsInUse> normals_in_use(const common::Scene& scene, const TexelLayout& layout);

}  // namespace shlm
