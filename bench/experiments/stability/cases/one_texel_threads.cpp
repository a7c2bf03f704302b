// 14. Contention: every hit of every thread goes to one texel.
#include <atomic>
#include <bit>
#include <thread>

#include "bench/contenders/plain_sums.h"
#include "bench/experiments/stability/known_light.h"
#include "bench/experiments/stability/stability_case.h"
#include "bench/experiments/stability/unit_floor.h"
#include "common/core/stopwatch.h"
#include "common/core/threads.h"

namespace bench::stability {
namespace {

using common::HitBatch;
using Model = shlm::PaperModel;

constexpr std::size_t numbers = 3 * Model::summed;

/// Makes uniform light of photons with random flux.
std::vector<HitBatch> random_batches(std::size_t count, Generator& generator) {
    std::vector<HitBatch> batches(count);
    for (HitBatch& hits : batches) {
        irradiate_quad(hits, unit_floor(), 0, 1024, generator, diffusely_onto({0, 0, 1}));
        for (common::Rgb& flux : hits.flux) flux *= uniform(generator);
    }
    return batches;
}

/// The numbers and the hits that a texel has summed, bit by bit.
using Sums = std::vector<std::int64_t>;

/// Adds with all threads at once. Each thread takes the next batch that is left.
Sums sums_of(std::span<const HitBatch> batches, const shlm::PreparedTexels& texels, int threads) {
    shlm::Accumulator<Model> accumulator(texels.layout, quantum_of(batches.front()));
    std::atomic<std::size_t> next = 0;
    {
        std::vector<std::jthread> adding;
        for (int t = 0; t < threads; ++t)
            adding.emplace_back([&] {
                for (std::size_t b = next++; b < batches.size(); b = next++) accumulator.add(batches[b]);
            });
    }
    Sums sums;
    for (std::size_t k = 0; k < numbers; ++k) sums.push_back(accumulator.sums().quanta(0, k));
    sums.push_back(static_cast<std::int64_t>(accumulator.sums().hits(0)));
    return sums;
}

/// Does what many programs do: every thread has its own float sums, which are added at the end.
Sums sums_of_floats(std::span<const HitBatch> batches, int threads) {
    std::array<float, numbers> joined{};
    for (int t = 0; t < threads; ++t) {
        PlainSums<Model, float> own(1, quantum_of(batches.front()));
        for (std::size_t b = static_cast<std::size_t>(t); b < batches.size();
             b += static_cast<std::size_t>(threads))
            for (std::size_t i = 0; i < batches[b].size(); ++i)
                own.add(0, -batches[b].direction[i], -1 / batches[b].direction[i].z, batches[b].flux[i]);
        for (std::size_t k = 0; k < numbers; ++k) joined[k] += static_cast<float>(own.value(0, k));
    }
    Sums sums;
    for (const float number : joined) sums.push_back(std::bit_cast<std::int32_t>(number));
    return sums;
}

/// Returns the answers of a photon map of these photons, stored and indexed by so many threads, but by no
/// more than the whole run may use.
std::vector<common::Rgb> answers_of(std::span<const HitBatch> batches, int threads) {
    const auto most = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    return common::ThreadPool(std::min(threads, static_cast<int>(most))).run([&] {
        photonmap::CompactPhotonSink sink(unit_floor(), nearest(50, 0.1));
        sink.consume(batches);
        const auto map = std::move(sink).finish(1);
        std::vector<common::Rgb> answers;
        for (int i = 0; i < 64; ++i)
            answers.push_back(map.irradiance(scene_builder::front_of(
                unit_floor(), scene_builder::on_quad(0, 0.11f + 0.1f * static_cast<float>(i % 8),
                                                     0.12f + 0.1f * static_cast<float>(i / 8)))));
        return answers;
    });
}

template <class Values>
double number_of_differences(const Values& a, const Values& b) {
    double differing = 0;
    for (std::size_t i = 0; i < a.size(); ++i) differing += a[i] != b[i];
    return differing;
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    constexpr double places[] = {1, 2, 4, 7};
    const auto none = [](double) { return 0.0; };
    std::vector<StabilityCurve> curves = {
        curve_at("photon map: answers that differ, of 64", places, none),
        curve_at("light map: sums that differ, of 28", places, none),
        curve_at("light map: hits/s over those of one thread", places, none, Expected::shown)};
    const shlm::PreparedTexels texels = texels_of(unit_floor(), 1);
    const bool floats = run.has_mutation("every thread has floats of its own");

    run.for_each_seed([&](std::uint64_t seed) {
        Generator generator(seed);
        const std::vector<HitBatch> batches = random_batches(run.either<std::size_t>(256, 16), generator);
        const auto sums_with = [&](int threads) {
            return floats ? sums_of_floats(batches, threads) : sums_of(batches, texels, threads);
        };
        const Sums sums_of_one = sums_with(1);
        const std::vector<common::Rgb> answers_of_one = answers_of(batches, 1);
        double seconds_of_one = 0;
        for (std::size_t i = 0; i < std::size(places); ++i) {
            const int threads = static_cast<int>(places[i]);
            const common::Stopwatch stopwatch;
            const Sums sums = sums_with(threads);
            const double seconds = stopwatch.seconds();
            if (i == 0) seconds_of_one = seconds;
            curves[0].points[i].measured.push_back(
                number_of_differences(answers_of(batches, threads), answers_of_one));
            curves[1].points[i].measured.push_back(number_of_differences(sums, sums_of_one));
            curves[2].points[i].measured.push_back(seconds_of_one / seconds);
        }
    });
    return curves;
}

const RegisteredCase registered(
    140,
    {.name = "one-texel-threads",
     .purpose = "Contention: where all hits go to one texel, threads that add floats give another map each "
                "time, and threads that wait for each other gain nothing.",
     .scene = "One texel under uniform light, photons of random brightness by seed. All threads add at once.",
     .swept = "threads",
     .measured = "answers or sums that differ; relative speed",
     .theory = "No sum and no answer differs from that of one thread, in no bit. Speed is shown: a texel is "
               "one share of the map, to which one thread adds at a time.",
     .advice = "Nothing to avoid for the answer: the light map sums integers, the photon map keeps the "
               "photons' order. A scene all of whose light falls on few texels takes in hits at the speed "
               "of one thread.",
     .mutations = {"every thread has floats of its own"},
     .run = run});

}  // namespace
}  // namespace bench::stability
