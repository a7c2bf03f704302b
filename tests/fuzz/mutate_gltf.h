// Changes a glTF file so that it remains one, since most changes of single bytes are stopped by the parser.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace fuzz {

/// Returns a GLB of the file in which a few values of its JSON, chosen by `seed`, are replaced, removed or
/// copied elsewhere. Throws InputError if the file has no JSON.
[[nodiscard]] std::vector<std::uint8_t> mutated_gltf(std::span<const std::uint8_t> file, unsigned seed);

}  // namespace fuzz
