// Changes to a glTF file that leave it one: most changes of bytes alone end at the parser.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace fuzz {

/// The file with one value of its JSON replaced, removed or copied elsewhere, chosen by `seed`. A GLB stays a
/// GLB. Nothing where there is no JSON in it.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> mutated_gltf(std::span<const std::uint8_t> file,
                                                                    unsigned seed);

}  // namespace fuzz
