// 12. Degenerate photons: none, about as many as a gather wants, all at one point or on one line.
#include <limits>

#include "bench/experiments/stability/known_light.h"
#include "bench/experiments/stability/stability_case.h"
#include "bench/experiments/stability/unit_floor.h"

namespace bench::stability {
namespace {

using common::HitBatch;
using common::SurfacePoint;
using photonmap::GatherSettings;

constexpr std::size_t k = 50;
constexpr double counts[] = {0, 1, 2, k - 1, k, k + 1, 200};
constexpr std::size_t spoiled_hits = 6;
constexpr int texels_each_way = 4;

/// A sink whose gathers test every photon.
using BruteForceSink = photonmap::BulkPhotonSink<photonmap::TreeOverCurve<common::BruteForceIndex>>;

enum class Arrangement { anywhere, in_pairs, on_a_line, in_one_place };

/// Makes vertical photons of 1 W, whose sums are exact in any order, also in the compact map.
HitBatch photons(std::size_t count, Arrangement arrangement, Generator& generator) {
    HitBatch hits;
    for (std::size_t i = 0; i < count; ++i) {
        float s = uniform(generator), t = uniform(generator);
        if (arrangement == Arrangement::on_a_line) s = 0.3f;
        if (arrangement == Arrangement::in_one_place) s = t = 0.3f;
        common::SurfaceId on = scene_builder::on_quad(0, s, t);
        if (arrangement == Arrangement::in_pairs && i % 2 == 1) on = hits.surface.back();
        hits.push_back(common::position_at(unit_floor(), on), {0, 0, -1}, {1, 1, 1}, on);
    }
    return hits;
}

/// Adds some hits that every store must reject.
HitBatch spoiled(HitBatch hits) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                    inf = std::numeric_limits<float>::infinity();
    const common::SurfaceId on = scene_builder::on_quad(0, 0.3f, 0.3f);
    hits.push_back({nan, 0.3f, 0}, {0, 0, -1}, {1, 1, 1}, on);
    hits.push_back({0.3f, inf, 0}, {0, 0, -1}, {1, 1, 1}, on);
    hits.push_back({0.3f, 0.3f, 0}, {0, 0, nan}, {1, 1, 1}, on);
    hits.push_back({0.3f, 0.3f, 0}, {-inf, 0, -1}, {1, 1, 1}, on);
    hits.push_back({0.3f, 0.3f, 0}, {0, 0, -1}, {1, nan, 1}, on);
    hits.push_back({0.3f, 0.3f, 0}, {0, 0, -1}, {1, 1, inf}, on);
    return hits;
}

/// Returns points on the photons and elsewhere.
std::vector<SurfacePoint> points_for(const HitBatch& hits, Generator& generator) {
    std::vector<SurfacePoint> points;
    for (std::size_t i = 0; i < 16; ++i) {
        const float s = uniform(generator), t = uniform(generator);
        const bool on_photon = i % 2 == 0 && hits.size() > 0;
        points.push_back(scene_builder::front_of(unit_floor(), on_photon
                                                                   ? hits.surface[generator() % hits.size()]
                                                                   : scene_builder::on_quad(0, s, t)));
    }
    return points;
}

/// Returns the answers of a photon map and, last, its number of rejected hits.
template <class PhotonSink>
std::vector<float> answers(const HitBatch& hits, const GatherSettings& gather,
                           std::span<const SurfacePoint> points) {
    PhotonSink sink(unit_floor(), gather);
    sink.consume(std::span(&hits, 1));
    const auto rejected = static_cast<float>(sink.rejected().not_finite);
    const auto map = std::move(sink).finish(1.0f);
    std::vector<float> found;
    for (const SurfacePoint& point : points) found.push_back(map.irradiance(point).x);
    found.push_back(rejected);
    return found;
}

std::size_t differing(const std::vector<float>& a, const std::vector<float>& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < b.size(); ++i) count += !(a[i] == b[i]);
    return count;
}

/// Returns the number of wrong answers of a light map, from counting the photons in the point's texel. The
/// texel's area and the answer each round once.
std::size_t wrong_texels(const HitBatch& sound, const HitBatch& offered,
                         std::span<const SurfacePoint> points) {
    static const shlm::PreparedTexels texels = texels_of(unit_floor(), texels_each_way * texels_each_way);
    shlm::Sink<FlatModel> sink(texels, shlm::OwnTexel{}, shlm::Quantum({1, 1, 1}), 0);
    sink.consume(std::span(&offered, 1));
    const auto map = sink.finish(1.0f);
    const auto texel_at = [](const common::Vec3& p) {
        return std::pair(static_cast<int>(p.x * texels_each_way), static_cast<int>(p.y * texels_each_way));
    };
    std::size_t wrong = sink.rejected().not_finite != spoiled_hits;
    for (const SurfacePoint& point : points) {
        double expected = 0;
        for (const common::Vec3& p : sound.position)
            expected += texel_at(p) == texel_at(point.position) ? texels_each_way * texels_each_way : 0.0;
        wrong += !(std::abs(map.irradiance(point).x - expected) <= 0x1p-20 * expected);
    }
    return wrong;
}

std::vector<StabilityCurve> run(const CaseRun& run) {
    const auto none = [](double) { return 0.0; };
    std::vector<StabilityCurve> curves = {
        curve_at("photon map, flann", counts, none),
        curve_at("photon map, nanoflann", counts, none),
        curve_at("photon map, compact", counts, none),
        curve_at("photon map, grid, radius only", counts, none),
        curve_at("light map, own texel", counts, none),
        curve_at("photon map, flann-incremental (not exact)", counts, none, Expected::shown)};
    const GatherSettings by_number = nearest(k, 0.4), by_radius = within(unit_floor(), 0.2);
    const GatherSettings asked = nearest(run.has_mutation("the k-th photon counts") ? k + 1 : k, 0.4);
    const bool one_more = run.has_mutation("the light map is to have one photon more");

    run.for_each_seed([&](std::uint64_t seed) {
        Generator generator(seed);
        for (std::size_t i = 0; i < std::size(counts); ++i) {
            std::array<std::size_t, 6> wrong{};
            for (const auto arrangement : {Arrangement::anywhere, Arrangement::in_pairs,
                                           Arrangement::on_a_line, Arrangement::in_one_place}) {
                HitBatch sound = photons(static_cast<std::size_t>(counts[i]), arrangement, generator);
                const HitBatch hits = spoiled(sound);
                const auto points = points_for(sound, generator);
                auto expected = answers<BruteForceSink>(sound, by_number, points),
                     expected_within = answers<BruteForceSink>(sound, by_radius, points);
                expected.back() = expected_within.back() = spoiled_hits;
                const auto differing_of = [&]<class PhotonSink>() {
                    return differing(answers<PhotonSink>(hits, asked, points), expected) +
                           differing(answers<PhotonSink>(hits, by_radius, points), expected_within);
                };
                wrong[0] += differing_of.operator()<photonmap::FlannPhotonSink>();
                wrong[1] += differing_of.operator()<photonmap::NanoflannPhotonSink>();
                wrong[2] += differing_of.operator()<photonmap::CompactPhotonSink>();
                wrong[3] +=
                    differing(answers<photonmap::GridPhotonSink>(hits, by_radius, points), expected_within);
                wrong[5] += differing_of.operator()<photonmap::FlannIncrementalPhotonSink>();
                if (one_more) sound.push_back(points[0].position, {0, 0, -1}, {1, 1, 1}, points[0].surface);
                wrong[4] += wrong_texels(sound, hits, points);
            }
            for (std::size_t c = 0; c < curves.size(); ++c)
                curves[c].points[i].measured.push_back(static_cast<double>(wrong[c]));
        }
    });
    return curves;
}

const RegisteredCase registered(
    120,
    {.name = "degenerate-photons",
     .purpose = "Empty maps, fewer photons than a gather wants, photons in one place or on one line, NaN and "
                "infinity: trees that never end, divisions by zero, one NaN that spoils an image.",
     .scene =
         "Vertical photons of 1 W on a floor of 1 x 1: anywhere, in pairs, on a line, in one place; among "
         "them six hits that are not finite. Gathers of k = 50 and of radius 0.2 at 16 points; seeds "
         "place photons and points.",
     .swept = "photons",
     .measured = "answers unlike brute force",
     .theory = "None differs, to the bit: sums of equal photons are exact in any order. All six spoiled hits "
               "are rejected and counted. Light map: the photons in the point's texel / its area.",
     .advice = "Nothing to do. flann-incremental misses some photons by design of FLANN's search.",
     .mutations = {"the k-th photon counts", "the light map is to have one photon more"},
     .run = run});

}  // namespace
}  // namespace bench::stability
