#include <gtest/gtest.h>

#include <atomic>

#include "common/core/input_error.h"
#include "common/tracer/null_sink.h"
#include "common/tracer/recording_sink.h"
#include "tests/support/statistics.h"
#include "tests/support/tracing.h"

namespace {

using namespace tests;
using common::PhotonFates;
using common::TraceReport;
using common::TraceTarget;

/// Makes a rotated room away from the origin, with a lamp, a mirror ball and a glass ball.
Scene furnished_room() {
    Scene scene = closed_box(diffuse(Rgb(0.7f, 0.5f, 0.3f)));
    add(scene, sphere({-0.4f, -0.5f, 0}, 0.3f, 3), mirror(Rgb(0.9f, 0.9f, 0.9f)));
    add(scene, sphere({0.4f, -0.5f, 0.1f}, 0.3f, 3), glass());
    add(scene, quad({-0.2f, 0.9f, -0.2f}, {0.4f, 0, 0}, {0, 0, 0.4f}), diffuse(Rgb(0, 0, 0), Rgb(3, 2, 1)));
    scene.point_light.push_back({{0.1f, 0.2f, 0.3f}, Rgb(1, 1, 1)});
    return moved(scene, skew_rotation(), {3, -5, 2});
}

/// Makes a small plate under a lamp, which most photons miss.
Scene open_scene() {
    Scene scene;
    add(scene, quad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2}), diffuse(Rgb(0.5f, 0.5f, 0.5f)));
    scene.point_light.push_back({{0, 1, 0}, Rgb(1, 1, 1)});
    return scene;
}

std::uint64_t ended(const PhotonFates& fates) {
    return fates.missed + fates.escaped + fates.absorbed + fates.given_up;
}

TEST(Tracer, GivesTheSameHitsOnAnyNumberOfThreads) {
    const Scene scene = furnished_room();
    const TraceTarget target{.photons = count_for(100'000, 5'000)};
    TracedRun one;
    common::ThreadPool(1).run([&] { one = record(scene, 1, target); });
    EXPECT_GT(one.hits.size(), target.photons);
    for (const int threads : {2, 7}) {
        TracedRun many;
        common::ThreadPool(threads).run([&] { many = record(scene, 1, target); });
        EXPECT_TRUE(same_hits(one.hits, many.hits)) << threads << " threads";
        EXPECT_EQ(one.report.fates.absorbed, many.report.fates.absorbed) << threads << " threads";
    }
}

/// Hits with the numbers of their photons in the run.
struct NumberedHits {
    common::HitBatch hits;
    std::vector<std::uint64_t> photon;
    std::uint64_t blocks = 0;

    void consume(std::span<const common::HitBatch> wave) {
        for (const common::HitBatch& batch : wave) {
            for (std::size_t i = 0; i < batch.size(); ++i) {
                hits.push_back(batch.position[i], batch.direction[i], batch.flux[i], batch.surface[i]);
                photon.push_back(blocks * common::photons_per_block + batch.photon[i]);
            }
            ++blocks;
        }
    }

    [[nodiscard]] common::HitBatch of_photons(std::uint64_t first, std::uint64_t end) const {
        common::HitBatch some;
        for (std::size_t i = 0; i < hits.size(); ++i)
            if (photon[i] >= first && photon[i] < end)
                some.push_back(hits.position[i], hits.direction[i], hits.flux[i], hits.surface[i]);
        return some;
    }
};

TEST(Tracer, EveryRunHasTheSamePhotons) {
    const Scene scene = furnished_room();
    NumberedHits longest;
    trace(scene, 2, {.photons = 30'000}, longest);
    for (const TraceTarget target :
         {TraceTarget{.photons = 256}, TraceTarget{.photons = 5'120}, TraceTarget{.hits = 1},
          TraceTarget{.hits = 30'000}, TraceTarget{.photons = 9'000, .first_photon = 4'000},
          TraceTarget{.hits = 3'000, .first_photon = 8'192}}) {
        const TracedRun run = record(scene, 2, target);
        EXPECT_GT(run.hits.size(), 0u);
        EXPECT_EQ(run.hits.size(), run.report.hits);
        EXPECT_TRUE(same_hits(run.hits, longest.of_photons(target.first_photon,
                                                           target.first_photon + run.report.fates.emitted)))
            << "target " << target.photons << " photons, " << target.hits << " hits from photon "
            << target.first_photon;
    }
}

/// Counts what it gets from several threads at once.
struct UnorderedCount {
    std::atomic<std::uint64_t> hits = 0, at_once = 0;

    void consume(std::span<const common::HitBatch> wave) {
        for (const common::HitBatch& batch : wave) hits += batch.size();
    }
    void add(const common::HitBatch& batch) {
        hits += batch.size();
        at_once += batch.size();
    }
};

TEST(Tracer, UnorderedSinkGetsTheSameRun) {
    for (const TraceTarget target : {TraceTarget{.photons = 100'001}, TraceTarget{.hits = 600'000},
                                     TraceTarget{.photons = 200'000, .first_photon = 100}}) {
        UnorderedCount sink;
        const TraceReport unordered = trace(furnished_room(), 10, target, sink);
        const TraceReport ordered = record(furnished_room(), 10, target).report;
        EXPECT_EQ(sink.hits, unordered.hits);
        EXPECT_GT(sink.at_once, 0u);
        EXPECT_EQ(unordered.hits, ordered.hits);
        EXPECT_EQ(unordered.fates.emitted, ordered.fates.emitted);
        EXPECT_EQ(unordered.fates.absorbed, ordered.fates.absorbed);
        EXPECT_EQ(unordered.fates.given_up, ordered.fates.given_up);
    }
}

TEST(Tracer, GoesOnFromWhereItWasStopped) {
    const Scene scene = furnished_room();
    for (const common::TraceTarget target :
         {common::TraceTarget{.photons = 300'001}, common::TraceTarget{.hits = 900'000}}) {
        const TracedRun whole = record(scene, 5, target);
        common::RecordingSink sink;
        TraceReport report;
        int calls = 0;
        do {
            report = common::trace_photons(
                common::RayScene(scene), common::PhotonSource(scene), 5, target, sink,
                [](const TraceReport&) { return false; }, report);
        } while (report.fates.emitted < whole.report.fates.emitted && ++calls < 1000);
        EXPECT_GT(calls, 1);
        EXPECT_TRUE(same_hits(sink.hits(), whole.hits)) << target.photons << " photons";
        EXPECT_EQ(report.fates.absorbed, whole.report.fates.absorbed);
    }
}

TEST(Tracer, ARunMayBeginAtAnyPhoton) {
    const Scene scene = furnished_room();
    const std::uint64_t block = common::photons_per_block;
    const TracedRun whole = record(scene, 6, {.photons = 3 * block});
    std::uint64_t hits = 0;
    for (const auto& [first, end] :
         {std::pair(0ul, 1000ul), std::pair(1000ul, block + 24), std::pair(block + 24, 3 * block)})
        hits += record(scene, 6, {.photons = end - first, .first_photon = first}).report.hits;
    EXPECT_EQ(hits, whole.report.hits);
    const TracedRun head = record(scene, 6, {.photons = 2 * block}),
                    tail = record(scene, 6, {.photons = block, .first_photon = 2 * block});
    common::HitBatch joined = head.hits;
    for (std::size_t i = 0; i < tail.hits.size(); ++i)
        joined.push_back(tail.hits.position[i], tail.hits.direction[i], tail.hits.flux[i],
                         tail.hits.surface[i]);
    EXPECT_TRUE(same_hits(joined, whole.hits));
}

TEST(Tracer, DifferentSeedsGiveDifferentHits) {
    const Scene scene = furnished_room();
    const TracedRun a = record(scene, 1, {.photons = 256}), b = record(scene, 2, {.photons = 256}),
                    c = record(scene, 1 + (std::uint64_t{1} << 32), {.photons = 256});
    EXPECT_FALSE(begins_with(a.hits, b.hits));
    EXPECT_NE(a.hits.position[0], b.hits.position[0]);
    EXPECT_NE(a.hits.position[0], c.hits.position[0]) << "the seed's upper half counts too";
}

TEST(Tracer, AccountsForEveryPhoton) {
    const TraceReport open = record(open_scene(), 3, {.photons = 20'000}).report;
    EXPECT_EQ(open.fates.emitted, 20'000u) << "exactly, in the middle of a block";
    EXPECT_EQ(ended(open.fates), open.fates.emitted);
    EXPECT_GT(open.fates.missed, 0u);
    EXPECT_GT(open.fates.escaped, 0u);
    EXPECT_GT(open.fates.absorbed, 0u);
    EXPECT_EQ(open.hits, open.fates.escaped + open.fates.absorbed) << "each has hit the plate once";

    const TraceReport closed = record(furnished_room(), 3, {.photons = 20'000}).report;
    EXPECT_EQ(ended(closed.fates), closed.fates.emitted);
    EXPECT_FLOAT_EQ(closed.watts_per_flux(), 1 / 20'000.0f);
}

TEST(Tracer, EndsWithThePhotonThatReachesTheHits) {
    for (const Scene& scene : {furnished_room(), open_scene()})
        for (const std::uint64_t wanted : {1u, 255u, 1000u, 40'000u}) {
            const TraceReport report = record(scene, 4, {.hits = wanted}).report;
            EXPECT_GE(report.hits, wanted);
            if (report.fates.emitted == 1) continue;
            const TraceReport shorter = record(scene, 4, {.photons = report.fates.emitted - 1}).report;
            EXPECT_LT(shorter.hits, wanted) << "a photon less was enough";
        }
}

TEST(Tracer, ReachesBothTargets) {
    const TraceReport many_hits = record(open_scene(), 5, {.photons = 1'000, .hits = 5'000}).report;
    EXPECT_GE(many_hits.hits, 5'000u);
    const TraceReport many_photons = record(open_scene(), 5, {.photons = 50'000, .hits = 10}).report;
    EXPECT_GE(many_photons.fates.emitted, 50'000u);
    EXPECT_EQ(record(open_scene(), 5, {}).report.fates.emitted, 0u) << "nothing asked for";
}

TEST(Tracer, ThrowsWhereNoHitsCanBeReached) {
    Scene scene;
    add(scene, quad({-1, 0, 1}, {2, 0, 0}, {0, 0, -2}), mirror());
    scene.point_light.push_back({{0, 1, 0}, Rgb(1, 1, 1)});
    common::NullSink sink;
    EXPECT_THROW(trace(scene, 6, {.hits = 1}, sink), common::InputError);
    EXPECT_NO_THROW(trace(scene, 6, {.photons = 1000}, sink));
}

TEST(Tracer, StopsWhenProgressSaysSo) {
    common::NullSink sink;
    int calls = 0;
    const TraceReport report = trace(open_scene(), 7, {.photons = 100'000'000}, sink,
                                     [&](const TraceReport&) { return ++calls < 2; });
    EXPECT_TRUE(report.interrupted);
    EXPECT_GT(report.fates.emitted, 0u);
    EXPECT_LT(report.fates.emitted, 100'000'000u);
    EXPECT_EQ(ended(report.fates), report.fates.emitted);
}

TEST(Tracer, StoresNothingOnMirrorsAndGlass) {
    const Scene scene = furnished_room();
    for (const SurfaceId& surface : record(scene, 8, {.photons = 20'000}).hits.surface)
        ASSERT_EQ(scene.material_of(surface.triangle).kind, common::SurfaceKind::diffuse);
}

TEST(Tracer, EndsInARoomOfPerfectMirrors) {
    if (count_for(0, 1) == 1) GTEST_SKIP() << "a block of photons with all the events there can be";
    Scene scene = closed_box(mirror());
    scene.point_light.push_back({{0.1f, 0.2f, 0.3f}, Rgb(1, 1, 1)});
    const TraceReport report = record(scene, 9, {.photons = 256}).report;
    EXPECT_EQ(report.fates.given_up, 256u);
    EXPECT_EQ(report.hits, 0u);
}

TEST(Tracer, RecordsHitsWhereTheyAre) {
    const Scene scene = furnished_room();
    const common::HitBatch hits = record(scene, 10, {.photons = 5'000}).hits;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        // They are rounded differently, by a few ulp of the largest coordinate.
        ASSERT_LT((hits.position[i] - common::position_at(scene, hits.surface[i])).length(), 4e-6f);
        ASSERT_NEAR(hits.direction[i].length(), 1, 1e-5);
        ASSERT_GE(hits.surface[i].u, 0);
        ASSERT_GE(hits.surface[i].v, 0);
        ASSERT_LE(hits.surface[i].u + hits.surface[i].v, 1 + 1e-6f);
    }
}

TEST(Tracer, LosesNextToNothingFromAClosedRoom) {
    // The room is rotated, so every position is rounded. All walls emit and reflect. A photon leaks if it
    // hits one wall within rounding of another, which has a probability of about 1 in 10^7 in such a room.
    const Scene scene =
        moved(closed_box(diffuse(Rgb(0.9f, 0.9f, 0.9f), Rgb(1, 1, 1))), skew_rotation(), {1, -2, 1});
    const TracedRun run = record(scene, 11, {.hits = count_for(3'000'000, 100'000)});
    std::uint64_t on_backs = 0;
    for (std::size_t i = 0; i < run.hits.size(); ++i)
        on_backs += run.hits.direction[i].dot(scene.geometric_normal[run.hits.surface[i].triangle]) > 0;
    const double bound = std::max(1.0, 2e-6 * static_cast<double>(run.hits.size()));
    EXPECT_LE(static_cast<double>(run.report.fates.missed + run.report.fates.escaped), bound);
    EXPECT_LE(static_cast<double>(on_backs), bound);
}

TEST(Tracer, PhotonsDoNotMeetTheLampTheyLeave) {
    Scene plate;
    add(plate, quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), diffuse(Rgb(0.5f, 0.5f, 0.5f), Rgb(1, 1, 1)));
    for (const Vec3& offset : {Vec3(0, 0, 0), Vec3(1, 2, 3), Vec3(100, -70, 40)}) {
        const TraceReport report =
            record(moved(plate, skew_rotation(), offset), 12, {.photons = count_for(1'000'000, 50'000)})
                .report;
        EXPECT_EQ(report.hits, 0u) << "of " << report.fates.emitted << " photons of a lone plate at "
                                   << offset;
    }
}

}  // namespace
