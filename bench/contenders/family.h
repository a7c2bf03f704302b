// Families of contenders, named by the first part of a contender's name.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bench/contenders/name_parts.h"

namespace bench {

class Technique;

/// Describes a part of a family's names to users.
struct NameField {
    std::string key;   ///< name of the part
    std::string form;  ///< the allowed values: "disc, cone or epanechnikov"
    std::string meaning;
};

struct Family {
    std::string purpose;
    /// Parses what follows the family's name. Throws InputError by NameParts::complain.
    std::function<std::shared_ptr<const Technique>(NameParts&)> parse;
    std::function<std::vector<NameField>()> fields;
    /// Returns a name for each engine, basis or kind of the family, as `shlmbench methods` lists them.
    std::function<std::vector<std::string>()> names;
};

[[nodiscard]] const std::map<std::string, Family>& all_families();

/// Registers a family until the program ends.
class RegisteredFamily {
  public:
    RegisteredFamily(const std::string& name, Family family);
};

}  // namespace bench
