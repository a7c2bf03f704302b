#include "bench/setup/texel_options.h"

#include <fmt/format.h>

#include <array>
#include <optional>

#include "bench/setup/command.h"
#include "bench/setup/numbers.h"
#include "common/core/input_error.h"

namespace bench {
namespace {

constexpr std::array<std::pair<const char*, shlm::TexelPlacement>, 3> placements = {
    {{"auto", shlm::TexelPlacement::automatic},
     {"uv", shlm::TexelPlacement::uv},
     {"face", shlm::TexelPlacement::face}}};

std::optional<shlm::TexelPlacement> placement_named(std::string_view text) {
    for (const auto& [name, placement] : placements)
        if (text == name) return placement;
    return std::nullopt;
}

}  // namespace

std::string name_of(shlm::TexelPlacement placement) {
    for (const auto& [name, value] : placements)
        if (value == placement) return name;
    return "";
}

std::string describe(const TexelChoice& texels) {
    if (texels.placement == shlm::TexelPlacement::automatic) return fmt::format("{}", texels.count);
    return fmt::format("{},{}", name_of(texels.placement), texels.count);
}

void TexelOptions::add_to(Command& command) {
    command.option("--texels", texels,
                   "Light maps: texels in all, and what they lie by: uv (lightmap coordinates), face (flat "
                   "pieces of the surface) or auto (uv where valid, else face), as in face,65536");
}

TexelChoice TexelOptions::choice() const {
    const std::size_t comma = texels.find(',');
    const auto placement = placement_named(texels.substr(0, comma));
    if (placement && comma == std::string::npos) return {.placement = *placement};
    const std::string count = placement ? texels.substr(comma + 1) : texels;
    try {
        return {parse_count("--texels", count), placement.value_or(shlm::TexelPlacement::automatic)};
    } catch (const common::InputError&) {
        throw common::InputError(fmt::format(
            "--texels: '{}' is not a whole number from 1 to 1e15, uv, face, auto, or both as in face,65536",
            texels));
    }
}

}  // namespace bench
