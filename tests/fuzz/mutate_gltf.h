// Changes to a glTF file that leave it one: most changes of bytes alone end at the parser.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace fuzz {

/// A GLB of the file with a few values of its JSON replaced, removed or copied elsewhere, chosen by `seed`.
/// Throws InputError where it has no JSON.
[[nodiscard]] std::vector<std::uint8_t> mutated_gltf(std::span<const std::uint8_t> file, unsigned seed);

}  // namespace fuzz
