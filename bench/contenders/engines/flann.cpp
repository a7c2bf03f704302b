// FLANN's kd-tree in one bulk build.
#include "bench/contenders/photon_map_store.h"

namespace bench {
namespace {

constexpr double tree_bytes = 46;  // 33 to 42, depending on leaf fill

const RegisteredEngine registered(
    1, {.name = "flann",
        .purpose = "one bulk build of FLANN's KDTreeSingleIndex: how photon maps are made today",
        .style = {"#0b6fb8", "o"},
        .bytes_per_hit = sorted_and_indexed(tree_bytes),
        .most_photons = common::max_flann_points,
        .make_store = make_photon_map_store<photonmap::FlannPhotonSink>});

}  // namespace
}  // namespace bench
