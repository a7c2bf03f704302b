// FLANN's kd-tree with every photon inserted as it arrives.
#include "bench/contenders/photon_map_store.h"

namespace bench {
namespace {

constexpr double tree_bytes = 96;  // 75, plus FLANN's array of pointers while it grows

const RegisteredEngine registered(
    5, {.name = "flann-incremental",
        .purpose = "every photon inserted into FLANN's KDTreeIndex: what the paper measures itself against",
        .style = {"#7a5ea8", "s"},
        .bytes_per_hit = photon_bytes + tree_bytes,
        .most_photons = common::max_flann_points,
        .grows = true,
        .make_store = make_photon_map_store<photonmap::FlannIncrementalPhotonSink>});

}  // namespace
}  // namespace bench
