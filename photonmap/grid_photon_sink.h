// A photon map over a grid, for gathers with a fixed radius.
#pragma once

#include "common/point_index/grid_index.h"
#include "photonmap/photon_map.h"

namespace photonmap {

/// Appends during tracing; when finished sorts the photons into the cells of a grid made for the largest
/// radius of its gathers.
class GridPhotonSink {
  public:
    GridPhotonSink(const common::Scene& scene, GatherSettings settings)
        : scene_(&scene), settings_(settings) {}

    void consume(std::span<const common::HitBatch> wave) { photons_.append(wave); }

    [[nodiscard]] PhotonMap<common::GridIndex> finish(float watts_per_flux) && {
        const common::GridCells cells(photons_.positions(), largest_radius(settings_, scene_->diagonal()));
        PhotonStorage sorted = std::move(photons_).in_order(cells.order(photons_.positions()));
        common::GridIndex index(sorted.positions(), cells);
        return {*scene_, {std::move(sorted), std::move(index)}, watts_per_flux, settings_};
    }

    [[nodiscard]] const common::RejectedHits& rejected() const { return photons_.rejected(); }
    [[nodiscard]] std::size_t bytes() const { return photons_.bytes(); }

  private:
    const common::Scene* scene_;
    GatherSettings settings_;
    PhotonStorage photons_;
};

static_assert(common::MapSink<GridPhotonSink>);
static_assert(common::IrradianceEstimator<PhotonMap<common::GridIndex>>);

}  // namespace photonmap
