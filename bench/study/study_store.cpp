#include "bench/study/study_store.h"

#include <oneapi/tbb/parallel_for.h>

#include "bench/app/finished_map.h"

namespace bench {
namespace {

using UseMap = std::function<void(const StudyMap&)>;

template <common::IrradianceEstimator Map>
StudyMap study_map(const Method& method, const Map& map, double build_seconds) {
    return {.method = method,
            .irradiance = [&map](const common::SurfacePoint& point) { return map.irradiance(point); },
            .build_seconds = build_seconds,
            .bytes = map.bytes()};
}

/// What adaptive maps of all errors share is found once; each method is charged for it.
template <class Model>
void finish_store(shlm::Sink<Model>& sink, const std::vector<Method>& methods, const PreparedMethods&,
                  const common::TraceReport& trace, const UseMap& use) {
    std::optional<shlm::BlockSearch> search;
    double search_seconds = 0;
    for (const Method& method : methods) {
        const ShlmMethod& light_map = *method.light_map();
        const bool adaptive = light_map.basis == LightBasis::adaptive;
        if constexpr (std::same_as<Model, shlm::AdaptiveModel>)
            if (adaptive && !search) {
                const common::Stopwatch searching;
                search.emplace(search_blocks(sink, trace));
                search_seconds = searching.seconds();
            }
        const common::Stopwatch build;
        const FinishedLightMap map =
            adaptive ? FinishedLightMap(adaptive_map(light_map, *search, sink.texels().layout))
                     : finished_map(light_map, sink, trace);
        StudyMap result = study_map(method, map, build.seconds() + (adaptive ? search_seconds : 0));
        result.insert_bytes = sink.bytes();
        result.hits_rejected = sink.rejected().total();
        result.clamped_share = sink.accumulator().clamped().discarded_share();
        use(result);
    }
}

/// The photons are sorted and indexed once; each method is charged for it.
template <class Sink>
void finish_store(Sink& sink, const std::vector<Method>& methods, const PreparedMethods& prepared,
                  const common::TraceReport& trace, const UseMap& use) {
    const std::uint64_t rejected = sink.rejected().total();
    const std::size_t insert_bytes = sink.bytes();
    const common::Stopwatch build;
    const auto photons = common::finish_map(std::move(sink), trace);
    const double build_seconds = build.seconds();
    for (const Method& method : methods) {
        const auto map = photons.with_gather(gather_of(*method.photon_map(), prepared.settings().max_radius));
        StudyMap result = study_map(method, map, build_seconds);
        result.hits_rejected = rejected;
        result.insert_bytes = insert_bytes;
        use(result);
    }
}

}  // namespace

std::vector<common::Rgb> ask(const StudyMap& map, std::span<const common::SurfacePoint> points) {
    std::vector<common::Rgb> answers(points.size());
    tbb::parallel_for(std::size_t{0}, points.size(),
                      [&](std::size_t i) { answers[i] = map.irradiance(points[i]); });
    return answers;
}

std::vector<MethodGroup> groups_of(const std::vector<Method>& methods) {
    std::vector<MethodGroup> groups;
    for (const Method& method : methods) {
        if (groups.empty() || !fill_alike(groups.back().front(), method)) groups.emplace_back();
        groups.back().push_back(method);
    }
    return groups;
}

StudyStore::StudyStore(std::vector<Method> methods, PreparedMethods& prepared,
                       const common::PhotonSource& source) {
    const Method first = methods.front();
    prepared.prepare(first);  // the scene's, not the run's
    const common::Stopwatch making_room;
    with_sink(first, prepared, source, [&](auto made) {
        using Sink = decltype(made);
        insert_seconds_ = making_room.seconds();
        const auto sink = std::make_shared<Sink>(std::move(made));
        consume_ = [sink](std::span<const common::HitBatch> wave) { sink->consume(wave); };
        finish_ = [sink, methods = std::move(methods), &prepared](const common::TraceReport& trace,
                                                                  const UseMap& use) {
            finish_store(*sink, methods, prepared, trace, use);
        };
    });
}

}  // namespace bench
