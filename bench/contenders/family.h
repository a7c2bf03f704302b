// Families of contenders, which the first part of a name says.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bench/contenders/name_parts.h"

namespace bench {

class Technique;

/// A part of a family's names, as people are told of it.
struct NameField {
    std::string key;   ///< as people are told
    std::string form;  ///< what may stand there: "disc, cone or epanechnikov"
    std::string meaning;
};

struct Family {
    std::string purpose;
    /// Reads what follows the family's name. Throws InputError as NameParts complains.
    std::function<std::shared_ptr<const Technique>(NameParts&)> parse;
    std::function<std::vector<NameField>()> fields;
    /// A name for each engine, basis or kind that the family has: those that `shlmbench methods` lists.
    std::function<std::vector<std::string>()> names;
};

[[nodiscard]] const std::map<std::string, Family>& all_families();

/// Adds a family for as long as the program runs.
class RegisteredFamily {
  public:
    RegisteredFamily(const std::string& name, Family family);
};

}  // namespace bench
