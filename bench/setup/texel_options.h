// --texels: how many a light map has, and what they are laid out by.
#pragma once

#include <string>

#include "bench/setup/command.h"
#include "shlm/layout/texel_placement.h"

namespace bench {

struct TexelChoice {
    std::size_t count = shlm::default_texels;  ///< in all, as nearly as the layout allows
    shlm::TexelPlacement placement = shlm::TexelPlacement::automatic;
};

/// "auto", "uv" or "face".
[[nodiscard]] std::string name_of(shlm::TexelPlacement placement);

/// "262144", or "face,262144" where the placement is not automatic.
[[nodiscard]] std::string describe(const TexelChoice& texels);

struct TexelOptions {
    std::string texels = describe(TexelChoice{});

    void add_to(Command& command);

    /// A number, a placement, or both as in face,65536. Throws InputError, naming the option, for the rest.
    [[nodiscard]] TexelChoice choice() const;
};

}  // namespace bench
