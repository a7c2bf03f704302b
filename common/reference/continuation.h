// Continues a reference from where an earlier run left it.
#pragma once

#include <optional>

#include "common/reference/reference_image.h"

namespace common::reference {

/// What two runs must have in common for one to continue the other.
struct ReferenceIdentity {
    std::string fingerprint;  ///< of the scene, see common/scene/fingerprint.h
    std::uint64_t seed;
    int width, height;
    std::string camera;  ///< describe()
};

/// Returns eye, forward, up and vertical field of view as text, exact to the last bit.
[[nodiscard]] std::string describe(const Camera& camera);

/// Returns the notes of a file that a later run can continue.
[[nodiscard]] ImageNotes continuation_notes(const ReferenceIdentity& identity, const ReferenceSums& sums);

/// Returns the sums in `file`; nothing if there is no such file. Throws InputError, saying what differs, if
/// it is not a reference or belongs to another run.
[[nodiscard]] std::optional<ReferenceSums> sums_to_go_on_from(const std::filesystem::path& file,
                                                              const ReferenceIdentity& identity);

}  // namespace common::reference
