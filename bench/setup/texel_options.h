// --texels: the number of a light map's texels, and their placement.
#pragma once

#include <string>

#include "bench/setup/command.h"
#include "shlm/layout/texel_placement.h"

namespace bench {

struct TexelChoice {
    std::size_t count = shlm::default_texels;  ///< in total, as nearly as the layout allows
    shlm::TexelPlacement placement = shlm::TexelPlacement::automatic;
};

/// Returns "auto", "uv" or "face".
[[nodiscard]] std::string name_of(shlm::TexelPlacement placement);

/// Returns "262144", or "face,262144" where the placement is not automatic.
[[nodiscard]] std::string describe(const TexelChoice& texels);

struct TexelOptions {
    std::string texels = describe(TexelChoice{});

    void add_to(Command& command);

    /// Parses a number, a placement, or both as in face,65536. Throws InputError, naming the option, for
    /// anything else.
    [[nodiscard]] TexelChoice choice() const;
};

}  // namespace bench
