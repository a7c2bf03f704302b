// A run of the reference: passes until the target, and the file that stores them.
#pragma once

#include <filesystem>

#include "bench/app/reference_target.h"
#include "bench/setup/scene_options.h"
#include "common/reference/continuation.h"

namespace bench {

/// What all passes have in common. `loaded` must outlive it.
struct ReferenceRun {
    const LoadedScene& loaded;
    std::filesystem::path out;
    common::reference::ReferenceIdentity identity;
    std::vector<common::VisibleSurface> pixels;
    common::reference::Lights lights;
    int most_surfaces;  ///< maximum on a path, the same as in the photon tracer

    ReferenceRun(const LoadedScene& scene, const common::PhotonSource& source, std::uint64_t seed,
                 const std::filesystem::path& file, int width, int height);
};

/// Adds passes until the target is reached or the user interrupts, and saves about once a minute. Returns
/// whether the target was reached. Shows its progress.
[[nodiscard]] bool sample(const ReferenceRun& run, const ReferenceTarget& target,
                          common::reference::ReferenceSums& sums);

/// Writes the image with its notes, and a PNG beside it.
void write(const ReferenceRun& run, const common::reference::ReferenceSums& sums);

/// Returns "FILE: 1024 samples per pixel, relative error 0.5 %".
[[nodiscard]] std::string describe(const ReferenceRun& run, const common::reference::ReferenceSums& sums);

}  // namespace bench
