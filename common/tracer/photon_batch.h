// Photons on their way, many at once.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/core/vec3_array.h"

namespace common {

/// Structure of arrays: the loops over it are the tracer's, and the compiler turns them into vector code.
struct PhotonBatch {
    std::vector<std::uint32_t> number;  ///< counted from the first photon of the block
    Vec3Array origin;
    Vec3Array direction;  ///< unit, the way it travels
    Vec3Array flux;       ///< RGB, as EmittedPhoton::flux

    [[nodiscard]] std::size_t size() const { return number.size(); }

    /// What is new has no defined value.
    void resize(std::size_t photons) {
        number.resize(photons);
        origin.resize(photons);
        direction.resize(photons);
        flux.resize(photons);
    }

    /// Becomes `from`'s photons `order[0]`, `order[1]`, ...
    void gather(const PhotonBatch& from, std::span<const std::uint32_t> order);
};

}  // namespace common
