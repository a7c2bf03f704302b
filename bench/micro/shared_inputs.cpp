#include "bench/micro/shared_inputs.h"

namespace bench {
namespace {

struct WaveRecorder {
    std::vector<std::vector<common::HitBatch>> waves;

    void consume(std::span<const common::HitBatch> wave) { waves.emplace_back(wave.begin(), wave.end()); }
};

}  // namespace

SharedInputs::SharedInputs(const std::string& scene_file)
    : loaded_(scene_file, SceneOptions{}),
      source_(loaded_.scene),
      queries_(visible_query_points(loaded_, micro_seed)) {}

const Recording& SharedInputs::recording(std::uint64_t hits) {
    const auto [entry, is_new] = recordings_.try_emplace(hits);
    if (is_new) {
        WaveRecorder recorder;
        entry->second.report =
            common::trace_photons(loaded_.rays, source_, micro_seed, {.hits = hits}, recorder);
        entry->second.waves = std::move(recorder.waves);
    }
    return entry->second;
}

PreparedMethods& SharedInputs::methods(std::size_t texels) {
    MethodSettings settings;
    settings.texels.count = texels;
    return methods_.try_emplace(texels, loaded_, settings).first->second;
}

}  // namespace bench
