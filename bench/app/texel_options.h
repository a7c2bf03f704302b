// --texels: how many a light map has, and what they are laid out by.
#pragma once

#include <string>

#include "shlm/settings.h"

namespace CLI {
class App;
}

namespace bench {

struct TexelChoice {
    std::size_t count = shlm::default_texels;  ///< in all, as nearly as the layout allows
    shlm::TexelPlacement placement = shlm::TexelPlacement::automatic;
};

/// "auto", "uv" or "face".
[[nodiscard]] std::string name_of(shlm::TexelPlacement placement);

/// "262144", "face", or both as "face,262144": automatic where none is said.
[[nodiscard]] std::string describe(const TexelChoice& texels);

struct TexelOptions {
    std::string texels = describe(TexelChoice{});

    void add_to(CLI::App& command);

    /// Throws InputError, naming the option, for anything else than what `describe` gives.
    [[nodiscard]] TexelChoice choice() const;
};

}  // namespace bench
