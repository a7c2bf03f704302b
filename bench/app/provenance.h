// Where a result comes from: machine, build, libraries, time.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <stdexcept>
#include <string>

#include "bench/app/methods.h"

namespace bench {

/// The user ended long work; the message says what became of it. The command exits with 130.
class Interrupted : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// machine, cores, memory_bytes, compiler, flags, libraries, commit (of the build), built and date (UTC).
[[nodiscard]] nlohmann::ordered_json provenance();

/// The same for an image's header, as shlmbench:KEY.
[[nodiscard]] std::map<std::string, std::string> provenance_notes();

/// "texels=262144 max-radius=auto"
[[nodiscard]] std::string describe(const MethodSettings& settings);

/// Warnings of the scene on stderr, a line each; those about lightmap coordinates where they matter.
void print_warnings(const LoadedScene& scene, const PreparedMethods& prepared, bool about_lightmap);

}  // namespace bench
