// The parts of light maps' names that all kinds have.
#pragma once

#include "bench/contenders/light_map.h"
#include "bench/contenders/name_parts.h"

namespace bench {

[[nodiscard]] const LightBasis& basis_named(const std::string& name);

[[nodiscard]] std::string name_of(const shlm::Gather& gather);

/// What may follow a gather: uv or face, then tTEXELS.
void take_texels(NameParts& parts, TexelSetting& setting);

/// Reads a kind of light map from its first part on, or gives null where the part is not its.
using ParseLightMap = std::shared_ptr<const Technique> (*)(NameParts&);

/// A kind of light map beside the uniform ones, whose first part is not a basis.
struct LightMapKind {
    std::string form;     ///< of that part: "aPERCENT"
    std::string example;  ///< a name
    ParseLightMap parse;
};

[[nodiscard]] const std::vector<LightMapKind>& light_map_kinds();

/// Adds a kind for as long as the program runs.
class RegisteredLightMapKind {
  public:
    explicit RegisteredLightMapKind(const LightMapKind& kind);
};

}  // namespace bench
