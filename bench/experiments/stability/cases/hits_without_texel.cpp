// 9. Hits without a texel, and hits with non-finite numbers: every one that is lost must be counted.
#include "bench/experiments/stability/faulty_box.h"
#include "bench/experiments/stability/stability_case.h"
#include "bench/setup/traced_hits.h"
#include "common/tracer/rejected_hits.h"

namespace bench::stability {
namespace {

using common::HitBatch;
using common::RejectedHits;
using common::Vec3;
using photonmap::GatherSettings;

/// Returns copies of the first hit, in each of which one number is not finite.
HitBatch broken_copies(const HitBatch& hits) {
    constexpr float infinite = std::numeric_limits<float>::infinity();
    HitBatch broken;
    for (const float value : {std::numeric_limits<float>::quiet_NaN(), infinite, -infinite})
        for (int number = 0; number < 9; ++number) {
            Vec3 at = hits.position[0], along = hits.direction[0];
            common::Rgb flux = hits.flux[0];
            (number < 3 ? at[number] : number < 6 ? along[number - 3] : flux[number - 6]) = value;
            broken.push_back(at, along, flux, hits.surface[0]);
        }
    return broken;
}

/// What became of the hits that were offered to a sink.
struct Taken {
    std::uint64_t stored;
    RejectedHits rejected;
};

template <common::MapSink Sink>
Taken offer_to_photon_map(Sink sink, std::span<const HitBatch> wave) {
    sink.consume(wave);
    const RejectedHits rejected = sink.rejected();
    return {std::move(sink).finish(1).size(), rejected};
}

Taken offer_to_light_map(const shlm::PreparedTexels& texels, std::span<const HitBatch> wave) {
    shlm::Sink<shlm::PaperModel> sink(texels, shlm::NearestTexels{}, quantum_of(wave.front()));
    sink.consume(wave);
    Taken taken{0, sink.rejected()};
    for (std::size_t i = 0; i < texels.geometry.size(); ++i)
        if (texels.geometry[i].area > 0) taken.stored += sink.accumulator().sums().hits(i);
    return taken;
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    constexpr double places[] = {0, 1, 2, 3};
    const auto all = [](double) { return 1.0; };
    const auto none = [](double) { return 0.0; };
    const auto of_one_kind = [](double walls) { return walls / 6; };
    const auto of_neither = [](double walls) { return 1 - 2 * walls / 6; };
    const auto of_fronts = [](double walls) { return 1 - walls / 6; };
    const bool faces_need_uv = run.has_mutation("texels by face need coordinates");
    const bool as_light_map = run.has_mutation("a photon map needs coordinates");
    std::vector<StabilityCurve> curves = {
        curve_at("photon maps: stored", places, [&](double w) { return as_light_map ? of_neither(w) : 1; }),
        curve_at("light map: stored", places, of_neither),
        curve_at("light map: no coordinates", places, of_one_kind),
        curve_at("light map: back of a single-sided surface", places, of_one_kind),
        curve_at("light map by face: stored", places,
                 [&](double w) { return faces_need_uv ? of_neither(w) : of_fronts(w); }),
        curve_at("all: not finite, of those that are not", places, all),
        curve_at("all: neither stored nor rejected", places, none)};
    std::vector<FaultyBox> boxes;
    for (const double faulty : places) boxes.emplace_back(static_cast<std::size_t>(faulty));

    run.for_each_seed([&](std::uint64_t seed) {
        for (std::size_t i = 0; i < std::size(places); ++i) {
            const FaultyBox& box = boxes[i];
            const HitBatch hits =
                traced(box.scene, seed, {.photons = run.either<std::uint64_t>(20'000, 2'000)}).hits;
            const std::vector<HitBatch> wave = {hits, broken_copies(hits)};
            const GatherSettings gather = nearest(50, 0.1);
            const Taken light_map = offer_to_light_map(box.texels, wave);
            const Taken by_face = offer_to_light_map(box.by_face, wave);
            const std::vector<Taken> everyone = {
                offer_to_photon_map(photonmap::FlannPhotonSink(box.scene, gather), wave),
                offer_to_photon_map(photonmap::NanoflannPhotonSink(box.scene, gather), wave),
                offer_to_photon_map(photonmap::FlannIncrementalPhotonSink(box.scene, gather), wave),
                offer_to_photon_map(photonmap::GridPhotonSink(box.scene, gather), wave),
                offer_to_photon_map(photonmap::CompactPhotonSink(box.scene, gather), wave),
                light_map,
                by_face};

            double stored = 0, not_finite = 0, lost = 0;
            for (const Taken& taken : everyone) {
                stored += static_cast<double>(taken.stored);
                not_finite += static_cast<double>(taken.rejected.not_finite);
                lost += std::abs(static_cast<double>(common::count_hits(wave)) -
                                 static_cast<double>(taken.stored));
                if (!run.has_mutation("rejected hits are not counted"))
                    lost -= static_cast<double>(taken.rejected.total());
            }
            stored -= static_cast<double>(light_map.stored + by_face.stored);
            const auto offered = static_cast<double>(hits.size()),
                       broken = static_cast<double>(wave[1].size()),
                       stores = static_cast<double>(everyone.size());
            const double measured[] = {stored / (stores - 2) / offered,
                                       static_cast<double>(light_map.stored) / offered,
                                       static_cast<double>(light_map.rejected.without_texel) / offered,
                                       static_cast<double>(light_map.rejected.back_of_single_sided) / offered,
                                       static_cast<double>(by_face.stored) / offered,
                                       not_finite / stores / broken,
                                       lost / offered};
            for (std::size_t c = 0; c < curves.size(); ++c)
                curves[c].points[i].measured.push_back(measured[c]);
        }
    });
    return curves;
}

const RegisteredCase registered(
    90,
    {.name = "hits-without-texel",
     .purpose = "Hits that have no texel, and hits that are no numbers: energy that a map loses without a "
                "word is found by nobody, and one NaN spoils all that is averaged with it.",
     .scene = "A closed box with a point light in its middle, traced. Some of its six walls have no "
              "lightmap coordinates, as many others are wound so that their backs are lit.",
     .swept = "walls of each kind",
     .measured = "part of the hits",
     .theory = "A sixth of the hits on each wall. hits = stored + rejected, to the hit. NaN and both "
               "infinities in each of nine numbers are counted as not finite. Photon maps store the rest.",
     .advice = "Heed what render says it rejected, and hits_rejected in the table of compare. Have texels by "
               "face, the default where coordinates are missing; make materials of open surfaces "
               "double-sided.",
     .mutations = {"a photon map needs coordinates", "texels by face need coordinates",
                   "rejected hits are not counted"},
     .run = run});

}  // namespace
}  // namespace bench::stability
