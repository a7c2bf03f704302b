// Taking up a reference where an earlier run left it.
#pragma once

#include <optional>

#include "common/reference/reference_image.h"

namespace common::reference {

/// What two runs must share for one to go on from the other.
struct ReferenceIdentity {
    std::string fingerprint;  ///< of the scene, see common/scene/fingerprint.h
    std::uint64_t seed;
    int width, height;
    std::string camera;  ///< describe()
};

/// Eye, forward, up and vertical field of view, to the last bit.
[[nodiscard]] std::string describe(const Camera& camera);

/// The notes that make a file one to go on from.
[[nodiscard]] ImageNotes continuation_notes(const ReferenceIdentity& identity, const ReferenceSums& sums);

/// The sums in `file`; nothing where there is no such file. Throws InputError, saying what differs, where it
/// is not a reference or one of another run.
[[nodiscard]] std::optional<ReferenceSums> sums_to_go_on_from(const std::filesystem::path& file,
                                                              const ReferenceIdentity& identity);

}  // namespace common::reference
