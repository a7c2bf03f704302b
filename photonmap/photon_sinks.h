// Sinks that fill a photon map, and the maps they become.
#pragma once

#include "common/point_index/flann_index.h"
#include "common/tracer/rejected_hits.h"
#include "photonmap/index/grid_index.h"
#include "photonmap/index/nanoflann_index.h"
#include "photonmap/packed_storage.h"
#include "photonmap/photon_map.h"

namespace photonmap {

/// Appends photons during tracing and builds the index once over all of them when finished. `Engine`
/// determines how photons are stored and indexed.
template <class Engine>
class BulkPhotonSink {
  public:
    using Map = typename Engine::Map;

    /// `scene` and `covers`, if it is not null, must outlive the sink and its map.
    BulkPhotonSink(const common::Scene& scene, GatherSettings settings,
                   const common::CoveringSurfaces* covers = nullptr)
        : scene_(&scene), settings_(settings), covers_(covers), photons_(Engine::storage(scene)) {}

    void consume(std::span<const common::HitBatch> wave) { photons_.append(wave); }

    [[nodiscard]] Map finish(float watts_per_flux) && {
        return {*scene_, Engine::indexed(std::move(photons_), *scene_, settings_), watts_per_flux, settings_,
                covers_};
    }

    [[nodiscard]] const common::RejectedHits& rejected() const { return photons_.rejected(); }
    [[nodiscard]] std::size_t bytes() const { return photons_.bytes(); }

  private:
    const common::Scene* scene_;
    GatherSettings settings_;
    const common::CoveringSurfaces* covers_;
    typename Engine::Storage photons_;
};

/// A tree over photons sorted along a space-filling curve: how photon maps are usually made today.
template <common::PointIndex Index>
struct TreeOverCurve {
    using Map = PhotonMap<Index>;
    using Storage = PhotonStorage;

    [[nodiscard]] static Storage storage(const common::Scene&) { return {}; }

    [[nodiscard]] static typename Map::Stored indexed(Storage&& photons, const common::Scene&,
                                                      const GatherSettings&) {
        PhotonStorage sorted = std::move(photons).sorted_along_curve();
        Index index(sorted.positions());
        return {std::move(sorted), std::move(index)};
    }
};

/// Photons sorted into the cells of a grid that is made for the largest gather radius.
struct CellsOfRadius {
    using Map = PhotonMap<GridIndex>;
    using Storage = PhotonStorage;

    [[nodiscard]] static Storage storage(const common::Scene&) { return {}; }

    [[nodiscard]] static Map::Stored indexed(Storage&& photons, const common::Scene& scene,
                                             const GatherSettings& settings) {
        const GridCells cells(photons.positions(), largest_radius(settings, scene.diagonal()));
        PhotonStorage sorted = std::move(photons).in_order(cells.order(photons.positions()));
        GridIndex index(sorted.positions(), cells);
        return {std::move(sorted), std::move(index)};
    }
};

/// Photons packed as they arrive, with the compact index: the strongest photon map that this suite has.
struct PackedUnderCompactTree {
    using Map = PhotonMap<CompactIndex, PackedPhotons>;
    using Storage = PackedPhotonStorage;

    [[nodiscard]] static Storage storage(const common::Scene& scene) { return Storage(scene); }

    [[nodiscard]] static Map::Stored indexed(Storage&& photons, const common::Scene&, const GatherSettings&) {
        Storage::Indexed indexed = std::move(photons).indexed();
        return {std::move(indexed.photons), std::move(indexed.index)};
    }
};

/// Inserts every photon into the tree as it arrives: the baseline of the paper.
template <class Index>
class IncrementalPhotonSink {
  public:
    /// Has the same requirements as BulkPhotonSink.
    IncrementalPhotonSink(const common::Scene& scene, GatherSettings settings,
                          const common::CoveringSurfaces* covers = nullptr)
        : scene_(&scene), settings_(settings), covers_(covers) {}

    void consume(std::span<const common::HitBatch> wave) {
        const std::size_t before = photons_.size();
        photons_.append(wave);
        index_.add(photons_.positions().subspan(before));
    }

    [[nodiscard]] PhotonMap<Index> finish(float watts_per_flux) && {
        return {*scene_, {std::move(photons_), std::move(index_)}, watts_per_flux, settings_, covers_};
    }

    [[nodiscard]] const common::RejectedHits& rejected() const { return photons_.rejected(); }
    [[nodiscard]] std::size_t bytes() const { return photons_.bytes() + index_.bytes(); }

  private:
    const common::Scene* scene_;
    GatherSettings settings_;
    const common::CoveringSurfaces* covers_;
    PhotonStorage photons_;
    Index index_;
};

using FlannPhotonSink = BulkPhotonSink<TreeOverCurve<common::FlannIndex>>;
using NanoflannPhotonSink = BulkPhotonSink<TreeOverCurve<NanoflannIndex>>;
using GridPhotonSink = BulkPhotonSink<CellsOfRadius>;
using CompactPhotonSink = BulkPhotonSink<PackedUnderCompactTree>;
using FlannIncrementalPhotonSink = IncrementalPhotonSink<common::FlannIncrementalIndex>;

static_assert(common::MapSink<FlannPhotonSink>);
static_assert(common::MapSink<NanoflannPhotonSink>);
static_assert(common::MapSink<FlannIncrementalPhotonSink>);
static_assert(common::MapSink<GridPhotonSink>);
static_assert(common::MapSink<CompactPhotonSink>);
static_assert(common::IrradianceEstimator<PhotonMap<common::FlannIndex>>);
static_assert(common::IrradianceEstimator<GridPhotonSink::Map>);
static_assert(common::IrradianceEstimator<CompactPhotonSink::Map>);

}  // namespace photonmap
