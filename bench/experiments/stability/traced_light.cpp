#include "bench/experiments/stability/traced_light.h"

namespace bench::stability {

double light_in_photons(const common::HitBatch& hits) {
    photonmap::PhotonStorage storage;
    storage.append(std::span(&hits, 1));
    double sum = 0;
    for (std::size_t i = 0; i < storage.size(); ++i) sum += common::mean_component(storage[i].flux);
    return sum;
}

common::Scene lit_box(float albedo) {
    common::Scene scene = scene_builder::closed_box(scene_builder::diffuse({albedo, albedo, albedo}));
    scene.point_light.push_back({{0.1f, 0.2f, 0.3f}, {1, 1, 1}});
    return scene;
}

}  // namespace bench::stability
