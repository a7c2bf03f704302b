// A batch of photons on their way.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/core/vec3_array.h"

namespace common {

/// Photons as structure of arrays, so that the compiler vectorises the tracer's loops over them.
struct PhotonBatch {
    std::vector<std::uint32_t> number;  ///< counted from the first photon of the block
    Vec3Array origin;
    Vec3Array direction;  ///< unit, the way the photon travels
    Vec3Array flux;       ///< RGB, as EmittedPhoton::flux

    [[nodiscard]] std::size_t size() const { return number.size(); }

    /// The values of new elements are undefined.
    void resize(std::size_t photons) {
        number.resize(photons);
        origin.resize(photons);
        direction.resize(photons);
        flux.resize(photons);
    }

    /// Copies the photons `order[0]`, `order[1]`, ... of `from` into this batch.
    void gather(const PhotonBatch& from, std::span<const std::uint32_t> order);
};

}  // namespace common
