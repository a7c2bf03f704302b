// What the reference leaves out of a scene's light.
#pragma once

#include <string>

#include "common/image/image.h"
#include "common/scene/scene.h"

namespace common::reference {

/// Light that no path finds, in words: a light without size cannot be met by chance, and no straight line
/// leads to it by a mirror or glass, but for one through a thin sheet. Empty where every path is found.
[[nodiscard]] std::string paths_not_found(const Scene& scene);

/// The note of a reference's file that says so: the words, or "none".
inline constexpr const char* paths_not_found_note = "shlmbench:paths_not_found";

/// What a file's notes say is left out; empty where that is nothing, or nothing is said. Photons find that
/// light: such a reference is no measure for a method that has it.
[[nodiscard]] std::string paths_not_found(const ImageNotes& notes);

}  // namespace common::reference
