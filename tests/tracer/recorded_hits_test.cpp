// Tests which hits are left out where direct light is kept apart.
#include <gtest/gtest.h>

#include "common/tracer/recording_sink.h"
#include "tests/support/see_through.h"
#include "tests/support/tracing.h"

namespace {

using namespace tests;
using common::HitBatch;
using common::RecordedHits;

constexpr std::uint64_t seed = 1;

/// Makes a closed box with a lamp below the ceiling, and a mirror and a ball of glass on the floor.
Scene specular_box() {
    Scene scene = closed_box(diffuse(Rgb(0.7f, 0.5f, 0.3f)));
    add(scene, quad({-0.4f, -0.4f, 0.9f}, {0, 0.8f, 0}, {0.8f, 0, 0}), diffuse(Rgb(0, 0, 0), Rgb(3, 2, 1)));
    add(scene, quad({-0.9f, -0.9f, -0.8f}, {0.6f, 0, 0}, {0, 0.6f, 0.3f}), double_sided(mirror()));
    add(scene, sphere({0.4f, 0.4f, -0.6f}, 0.3f, 2), glass());
    return scene;
}

HitBatch traced(const common::RayScene& rays, const common::PhotonSource& source, std::uint64_t block,
                RecordedHits recorded) {
    common::TracedBlock block_of_photons;
    common::BlockTracer(rays, source, seed, recorded).trace(block, block_of_photons);
    return block_of_photons.hits;
}

/// Returns the hits whose photon does not travel as it was emitted: whatever deflects a photon turns it.
HitBatch deflected(const HitBatch& all, const common::RayScene& rays, const common::PhotonSource& source,
                   std::uint64_t block) {
    common::PhotonBatch emitted;
    emitted.resize(common::photons_per_block);
    source.emit(seed, block * common::photons_per_block, rays.surface_offset(), emitted);
    HitBatch rest;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (all.direction[i] != Vec3(emitted.direction[all.photon[i]]))
            rest.push_back(all.position[i], all.direction[i], all.flux[i], all.surface[i], all.photon[i]);
    return rest;
}

TEST(RecordedHits, LeaveOutWhatComesStraight) {
    for (const Scene& scene : {specular_box(), see_through_room()}) {
        const common::RayScene rays(scene);
        const common::PhotonSource source(scene);
        for (const std::uint64_t block : {0, 7}) {
            const HitBatch all = traced(rays, source, block, RecordedHits::all),
                           indirect = traced(rays, source, block, RecordedHits::indirect);
            EXPECT_GT(indirect.size(), 100u);
            EXPECT_LT(indirect.size(), all.size() - 100);
            EXPECT_TRUE(same_hits(indirect, deflected(all, rays, source, block)));
        }
    }
}

/// What mirrors and glass throw on a surface is indirect, though it is the photon's first hit there.
TEST(RecordedHits, KeepCaustics) {
    Scene scene;
    add(scene, quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), diffuse(Rgb(0, 0, 0)));
    add(scene, sphere({0, 0, 0.5f}, 0.3f, 3), glass());
    add(scene, quad({-0.1f, -0.1f, 1.5f}, {0, 0.2f, 0}, {0.2f, 0, 0}), diffuse(Rgb(0, 0, 0), Rgb(1, 1, 1)));
    const common::RayScene rays(scene);
    const common::PhotonSource source(scene);
    const HitBatch indirect = traced(rays, source, 0, RecordedHits::indirect);
    std::size_t below_the_ball = 0;
    for (const Vec3& at : indirect.position) below_the_ball += at.z == 0 && std::hypot(at.x, at.y) < 0.3f;
    EXPECT_GT(below_the_ball, 20u);
    EXPECT_GT(2 * below_the_ball, indirect.size()) << "glass reflects little";
}

TEST(RecordedHits, AreNoneWhereNothingReflects) {
    Scene scene;
    add(scene, quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), diffuse(Rgb(0, 0, 0)));
    add(scene, quad({-0.4f, -0.4f, 1}, {0, 0.8f, 0}, {0.8f, 0, 0}), diffuse(Rgb(0, 0, 0), Rgb(1, 1, 1)));
    const common::RayScene rays(scene);
    EXPECT_EQ(traced(rays, common::PhotonSource(scene), 0, RecordedHits::indirect).size(), 0u);
}

TEST(RecordedHits, AreTheSameForAnyNumberOfThreadsAndPieces) {
    const Scene scene = specular_box();
    const common::RayScene rays(scene);
    const common::PhotonSource source(scene);
    const auto run = [&](int threads, std::initializer_list<std::uint64_t> ends) {
        common::ThreadPool pool(threads);
        common::RecordingSink sink;
        pool.run([&] {
            std::uint64_t first = 0;
            for (const std::uint64_t end : ends) {
                (void)common::trace_photons(rays, source, seed,
                                            {.photons = end - first, .first_photon = first}, sink, {}, {},
                                            RecordedHits::indirect);
                first = end;
            }
        });
        return sink.hits();
    };
    const HitBatch once = run(1, {30'000});
    EXPECT_GT(once.size(), 1000u);
    EXPECT_TRUE(same_hits(once, run(3, {30'000})));
    EXPECT_TRUE(same_hits(once, run(2, {4096, 5 * 4096, 30'000})));
}

}  // namespace
