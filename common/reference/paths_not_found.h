// Light in a scene that the reference does not find.
#pragma once

#include <string>

#include "common/image/image.h"
#include "common/scene/scene.h"

namespace common::reference {

/// Describes light that no path finds: chance cannot hit a light without size, and no straight line leads to
/// it through a mirror or glass, except a thin sheet. Empty if every path is found.
[[nodiscard]] std::string paths_not_found(const Scene& scene);

/// The note of a reference's file with that description, or "none".
inline constexpr const char* paths_not_found_note = "shlmbench:paths_not_found";

/// Returns what a file's notes say is left out; empty if nothing is, or if they do not say. Photons find that
/// light, so such a reference cannot judge a method that includes it.
[[nodiscard]] std::string paths_not_found(const ImageNotes& notes);

}  // namespace common::reference
