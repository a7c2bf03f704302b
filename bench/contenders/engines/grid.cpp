// A grid with cells as wide as the gather's radius.
#include "bench/contenders/photon_map_store.h"

namespace bench {
namespace {

constexpr double cell_bytes = 8;  // at most two cells a photon

const RegisteredEngine registered(3, {.name = "grid",
                                      .purpose = "cells of the gather's radius",
                                      .style = {"#b08d12", "P"},
                                      .bytes_per_hit = sorted_and_indexed(cell_bytes),
                                      .most_photons = photonmap::GridIndex::max_points,
                                      .for_one_radius = true,
                                      .make_store = make_photon_map_store<photonmap::GridPhotonSink>});

}  // namespace
}  // namespace bench
