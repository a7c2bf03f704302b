// What the benchmarks work on: one scene, its recorded hits, and the points that its camera sees.
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

/// The hits of a whole run, cut into waves as the tracer gave them.
struct Recording {
    std::vector<std::vector<common::HitBatch>> waves;
    common::TraceReport report;
};

/// Everything is made when first asked for and then kept: Google Benchmark calls a benchmark several times to
/// find out how often to repeat it, and none of that belongs under its clock.
class SharedInputs {
  public:
    /// Throws InputError for a scene that cannot be read, has no light, or shows its camera no diffuse
    /// surface.
    explicit SharedInputs(const std::string& scene_file);

    [[nodiscard]] const LoadedScene& loaded() const { return loaded_; }
    [[nodiscard]] const common::PhotonSource& source() const { return source_; }
    [[nodiscard]] const QueryPoints& queries() const { return queries_; }

    /// A run of at least this many hits.
    [[nodiscard]] const Recording& recording(std::uint64_t hits);

    /// With the command's own settings but for the number of texels.
    [[nodiscard]] PreparedScene& prepared(std::size_t texels = shlm::default_texels);

    /// Empty.
    [[nodiscard]] std::unique_ptr<Store> store(const std::string& contender,
                                               std::size_t texels = shlm::default_texels);

  private:
    LoadedScene loaded_;
    common::PhotonSource source_;
    QueryPoints queries_;
    std::map<std::uint64_t, Recording> recordings_;
    std::map<std::size_t, PreparedScene> prepared_;
};

/// Gives the store a recorded run.
inline void replay(const Recording& recording, Store& store) {
    for (const auto& wave : recording.waves) store.consume(wave);
}

/// The map of a contender after `times` times a recorded run.
[[nodiscard]] std::unique_ptr<const Answers> map_of(SharedInputs& inputs, const std::string& contender,
                                                    std::size_t texels, std::uint64_t hits, int times = 1);

}  // namespace bench::micro
