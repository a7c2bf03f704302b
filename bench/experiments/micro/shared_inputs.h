// Inputs of the benchmarks: one scene, its recorded hits, and the points that its camera sees.
#pragma once

#include <fmt/format.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bench/contenders/trace_into.h"
#include "bench/setup/query_points.h"
#include "common/tracer/trace_photons.h"

namespace bench::micro {

inline constexpr std::uint64_t micro_seed = 1;

/// The hits of a whole run, in waves as the tracer delivered them.
struct Recording {
    std::vector<std::vector<common::HitBatch>> waves;
    common::TraceReport report;
};

/// Makes everything when it is first needed and keeps it. Google Benchmark calls a benchmark several times to
/// find out how often to repeat it, and none of this must be timed.
class SharedInputs {
  public:
    /// Throws InputError for a scene that cannot be read, has no light, or shows its camera no diffuse
    /// surface.
    explicit SharedInputs(const std::string& scene_file);

    [[nodiscard]] const LoadedScene& loaded() const { return loaded_; }
    [[nodiscard]] const common::PhotonSource& source() const { return source_; }
    [[nodiscard]] const QueryPoints& queries() const { return queries_; }

    /// Returns a run of at least this many hits.
    [[nodiscard]] const Recording& recording(std::uint64_t hits);

    /// Returns the scene with the command's settings, except for the number of texels.
    [[nodiscard]] PreparedScene& prepared(std::size_t texels = shlm::default_texels);

    /// Makes an empty store.
    [[nodiscard]] std::unique_ptr<Store> store(const std::string& contender,
                                               std::size_t texels = shlm::default_texels);

  private:
    LoadedScene loaded_;
    common::PhotonSource source_;
    QueryPoints queries_;
    std::map<std::uint64_t, Recording> recordings_;
    std::map<std::size_t, PreparedScene> prepared_;
};

/// Adds a recorded run to the store.
inline void replay(const Recording& recording, Store& store) {
    for (const auto& wave : recording.waves) store.consume(wave);
}

/// Returns the map of a contender after a recorded run was added `times` times.
[[nodiscard]] std::unique_ptr<const Answers> map_of(SharedInputs& inputs, const std::string& contender,
                                                    std::size_t texels, std::uint64_t hits, int times = 1);

}  // namespace bench::micro
