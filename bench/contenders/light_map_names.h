// The parts of light maps' names that all kinds share.
#pragma once

#include "bench/contenders/light_map.h"
#include "bench/contenders/name_parts.h"

namespace bench {

[[nodiscard]] const LightBasis& basis_named(const std::string& name);

[[nodiscard]] std::string name_of(const shlm::Gather& gather);

/// Parses what may follow a gather: uv or face, then tTEXELS.
void take_texels(NameParts& parts, TexelSetting& setting);

/// Parses a kind of light map from its first part on, or returns null where the part is not of this kind.
using ParseLightMap = std::shared_ptr<const Technique> (*)(NameParts&);

/// A kind of light map other than the uniform ones: the first part of its name is not a basis.
struct LightMapKind {
    std::string form;     ///< of the first part: "aPERCENT"
    std::string example;  ///< an example of a name
    ParseLightMap parse;
};

[[nodiscard]] const std::vector<LightMapKind>& light_map_kinds();

/// Registers a kind until the program ends.
class RegisteredLightMapKind {
  public:
    explicit RegisteredLightMapKind(const LightMapKind& kind);
};

}  // namespace bench
