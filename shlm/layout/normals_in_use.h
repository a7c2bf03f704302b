// The shading normals for which a light map will be queried.
#pragma once

#include <vector>

#include "shlm/layout/texel_layout.h"

namespace shlm {

/// Cosine of one degree: normals within it count as equal.
inline constexpr float straight_cosine = 0.99985f;

/// The shading normals over one region of the layout.
struct NormalsInUse {
    /// Unit, in a frame whose z is the surface's normal there: samples, each for the same share of the area.
    /// Empty if all are along z: there only the irradiance of the surface itself is needed.
    std::vector<common::Vec3> bent;

    /// Returns the mean squared sine of their angles to z.
    [[nodiscard]] float sine_sq() const {
        float sum = 0;
        for (const common::Vec3& normal : bent) sum += 1 - normal.z * normal.z;
        return bent.empty() ? 0 : sum / static_cast<float>(bent.size());
    }
};

/// Returns one entry per region of the layout.
[[nodiscard]] std::vector<NormalsInUse> normals_in_use(const common::Scene& scene, const TexelLayout& layout);

}  // namespace shlm
