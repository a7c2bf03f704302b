// The provenance of a result: machine, build, libraries, time.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace bench {

/// Returns machine, instruction_set, cores, memory_bytes, compiler, flags, libraries, commit (of the build),
/// built and date (UTC).
[[nodiscard]] nlohmann::ordered_json provenance();

/// Returns the same for an image's header, with keys shlmbench:KEY.
[[nodiscard]] std::map<std::string, std::string> provenance_notes();

}  // namespace bench
