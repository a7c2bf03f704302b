// nanoflann's kd-tree in one bulk build.
#include "bench/contenders/photon_map_store.h"

namespace bench {
namespace {

constexpr double tree_bytes = 12;  // 7 to 8, depending on leaf fill

const RegisteredEngine registered(2, {.name = "nanoflann",
                                      .purpose = "the same with the library that people would choose today",
                                      .style = {"#2f9e6e", "v"},
                                      .bytes_per_hit = sorted_and_indexed(tree_bytes),
                                      .most_photons = photonmap::NanoflannIndex::max_points,
                                      .make_store = make_photon_map_store<photonmap::NanoflannPhotonSink>});

}  // namespace
}  // namespace bench
