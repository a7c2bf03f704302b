#include "photonmap/packed_storage.h"

#include <fmt/format.h>

#include "common/core/input_error.h"
#include "photonmap/finite_hits.h"
#include "photonmap/index/compact_build.h"

namespace photonmap {
namespace {

PackedPhoton packed(const common::HitBatch& batch, std::size_t i, const common::Scene& scene) {
    const common::Vec3& normal = scene.geometric_normal[batch.surface[i].triangle];
    const float cosine = batch.direction[i].dot(normal);
    const float divisor = std::max(std::abs(cosine), common::min_incident_cosine);
    return {batch.position[i], static_cast<std::uint16_t>(PackedNormal::pack(cosine < 0 ? normal : -normal)),
            PackedLight::pack(batch.direction[i], batch.flux[i] * (1 / divisor))};
}

}  // namespace

void PackedPhotonStorage::append(std::span<const common::HitBatch> wave) {
    std::span<PackedPhoton> room;
    const std::size_t stored = store_finite_hits(
        wave,
        [&](std::size_t count) {
            if (count > CompactIndex::max_points - photons_.size())
                throw common::InputError(
                    fmt::format("the compact photon map holds at most {} photons", CompactIndex::max_points));
            room = photons_.grow(count);
        },
        [&](std::size_t row, const common::HitBatch& batch, std::size_t i) {
            room[row] = packed(batch, i, *scene_);
        });
    rejected_.not_finite += common::count_hits(wave) - stored;
}

PackedPhotonStorage::Indexed PackedPhotonStorage::indexed() && {
    PackedPhotons photons;
    photons.size_ = photons_.size();
    std::span<std::uint16_t> normals;
    std::span<PackedLight> lights;
    CompactIndex index = build_compact_index(
        std::move(photons_),
        [&](std::size_t places) {
            normals = photons.normals_.grow(places);
            lights = photons.lights_.grow(places);
        },
        [&](std::size_t place, const PackedPhoton& photon) {
            normals[place] = photon.arrival_normal;
            lights[place] = photon.light;
        });
    return {std::move(photons), std::move(index)};
}

}  // namespace photonmap
