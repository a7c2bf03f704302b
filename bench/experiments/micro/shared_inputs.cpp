#include "bench/experiments/micro/shared_inputs.h"

namespace bench::micro {
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

PreparedScene& SharedInputs::prepared(std::size_t texels) {
    ContenderSettings settings;
    settings.texels.count = texels;
    return prepared_.try_emplace(texels, loaded_, settings).first->second;
}

std::unique_ptr<Store> SharedInputs::store(const std::string& contender, std::size_t texels) {
    const Contender named = parse_contender("micro", contender);
    (void)named->prepare(prepared(texels));
    return named->make_store(prepared(texels), source_);
}

std::unique_ptr<const Answers> map_of(SharedInputs& inputs, const std::string& contender, std::size_t texels,
                                      std::uint64_t hits, int times) {
    const std::unique_ptr<Store> store = inputs.store(contender, texels);
    const Recording& recording = inputs.recording(hits);
    for (int i = 0; i < times; ++i) replay(recording, *store);
    common::TraceReport report = recording.report;
    report.fates.emitted *= static_cast<std::uint64_t>(times);
    report.hits *= static_cast<std::uint64_t>(times);
    return parse_contender("micro", contender)->finish(*store, report).answers;
}

}  // namespace bench::micro
