// Packed photons in a kd-tree of our own.
#include "bench/contenders/photon_map_store.h"

namespace bench {
namespace {

constexpr double packed_bytes = 26;  // 24, plus partly filled pages during sorting

const RegisteredEngine registered(4, {.name = "compact",
                                      .purpose = "packed photons under a tree of this project: the strongest",
                                      .style = {"#202020", "D"},
                                      .bytes_per_hit = packed_bytes,
                                      .most_photons = photonmap::CompactIndex::max_points,
                                      .make_store = make_photon_map_store<photonmap::CompactPhotonSink>});

}  // namespace
}  // namespace bench
