// Sinks that fill a photon map, and the maps they become.
#pragma once

#include "common/point_index/flann_index.h"
#include "common/point_index/nanoflann_index.h"
#include "photonmap/packed_storage.h"
#include "photonmap/photon_map.h"

namespace photonmap {

/// Appends during tracing; when finished sorts the photons along a space-filling curve and builds the index
/// once over all of them: how photon maps are made today.
template <common::PointIndex Index>
class BulkPhotonSink {
  public:
    BulkPhotonSink(const common::Scene& scene, GatherSettings settings)
        : scene_(&scene), settings_(settings) {}

    void consume(std::span<const common::HitBatch> wave) { photons_.append(wave); }

    [[nodiscard]] PhotonMap<Index> finish(float watts_per_flux) && {
        PhotonStorage sorted = std::move(photons_).sorted_along_curve();
        Index index(sorted.positions());
        return {*scene_, {std::move(sorted), std::move(index)}, watts_per_flux, settings_};
    }

    [[nodiscard]] const common::RejectedHits& rejected() const { return photons_.rejected(); }
    [[nodiscard]] std::size_t bytes() const { return photons_.bytes(); }

  private:
    const common::Scene* scene_;
    GatherSettings settings_;
    PhotonStorage photons_;
};

/// Inserts every photon into the tree as it comes: what the paper measures itself against.
template <class Index>
class IncrementalPhotonSink {
  public:
    IncrementalPhotonSink(const common::Scene& scene, GatherSettings settings)
        : scene_(&scene), settings_(settings) {}

    void consume(std::span<const common::HitBatch> wave) {
        const std::size_t before = photons_.size();
        photons_.append(wave);
        index_.add(photons_.positions().subspan(before));
    }

    [[nodiscard]] PhotonMap<Index> finish(float watts_per_flux) && {
        return {*scene_, {std::move(photons_), std::move(index_)}, watts_per_flux, settings_};
    }

    [[nodiscard]] const common::RejectedHits& rejected() const { return photons_.rejected(); }
    [[nodiscard]] std::size_t bytes() const { return photons_.bytes() + index_.bytes(); }

  private:
    const common::Scene* scene_;
    GatherSettings settings_;
    PhotonStorage photons_;
    Index index_;
};

/// Packs photons as they come and builds the compact index over them when finished: the strongest photon map
/// that this suite has.
class CompactPhotonSink {
  public:
    using Map = PhotonMap<common::CompactIndex, PackedPhotons>;

    CompactPhotonSink(const common::Scene& scene, GatherSettings settings)
        : scene_(&scene), settings_(settings), photons_(scene) {}

    void consume(std::span<const common::HitBatch> wave) { photons_.append(wave); }

    [[nodiscard]] Map finish(float watts_per_flux) && {
        PackedPhotonStorage::Indexed indexed = std::move(photons_).indexed();
        return {*scene_, {std::move(indexed.photons), std::move(indexed.index)}, watts_per_flux, settings_};
    }

    [[nodiscard]] const common::RejectedHits& rejected() const { return photons_.rejected(); }
    [[nodiscard]] std::size_t bytes() const { return photons_.bytes(); }

  private:
    const common::Scene* scene_;
    GatherSettings settings_;
    PackedPhotonStorage photons_;
};

using FlannPhotonSink = BulkPhotonSink<common::FlannIndex>;
using NanoflannPhotonSink = BulkPhotonSink<common::NanoflannIndex>;
using FlannIncrementalPhotonSink = IncrementalPhotonSink<common::FlannIncrementalIndex>;

static_assert(common::MapSink<FlannPhotonSink>);
static_assert(common::MapSink<NanoflannPhotonSink>);
static_assert(common::MapSink<FlannIncrementalPhotonSink>);
static_assert(common::MapSink<CompactPhotonSink>);
static_assert(common::IrradianceEstimator<PhotonMap<common::FlannIndex>>);
static_assert(common::IrradianceEstimator<CompactPhotonSink::Map>);

}  // namespace photonmap
