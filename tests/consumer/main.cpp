// Traces a glTF scene into a sink of this program and into a light map, and evaluates the map.
#include <cstdio>
#include <exception>
#include <stdexcept>

#include "common/gltf/load_gltf.h"
#include "common/tracer/trace_photons.h"
#include "common/view/place_camera.h"
#include "common/view/visible_surfaces.h"
#include "shlm/layout/prepared_texels.h"
#include "shlm/map/sink.h"

namespace {

/// Sums all arriving flux, W times the number of photons emitted.
struct ArrivingLight {
    common::Rgb sum{0, 0, 0};

    void consume(std::span<const common::HitBatch> wave) {
        for (const common::HitBatch& hits : wave)
            for (const common::Rgb& flux : hits.flux) sum += flux;
    }
};

void run(const char* file) {
    const common::Scene scene = common::load_gltf(file);
    const common::RayScene rays(scene);
    const common::PhotonSource source(rays);
    const common::TraceTarget target{.hits = 200'000};
    constexpr std::uint64_t seed = 1;

    ArrivingLight light;
    const common::TraceReport trace = common::trace_photons(rays, source, seed, target, light);
    const common::Rgb watts = light.sum * trace.watts_per_flux();

    const shlm::PreparedTexels texels(scene, shlm::find_lightmap_uv(scene), 16'384);
    shlm::Sink<shlm::PaperModel> sink(texels, shlm::NearestTexels{}, shlm::Quantum(source.power()));
    const auto map =
        common::finish_map(std::move(sink), common::trace_photons(rays, source, seed, target, sink));

    const common::Camera camera = scene.camera.empty() ? common::place_camera(rays) : scene.camera.front();
    double irradiance = 0, pixels = 0;
    for (const common::VisibleSurface& seen : common::visible_surfaces(rays, camera, 64, 36)) {
        if (!seen.present) continue;
        irradiance += common::mean_component(map.irradiance(seen.point));
        ++pixels;
    }
    std::printf("hits %llu, arriving %.4g W, mean irradiance %.4g W/m^2, map %zu bytes\n",
                static_cast<unsigned long long>(trace.hits),
                static_cast<double>(watts.x + watts.y + watts.z) / 3, irradiance / pixels, map.bytes());
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc != 2) throw std::invalid_argument("usage: consumer SCENE.glb");
        run(argv[1]);
        return 0;
    } catch (const std::exception& e) {
        std::fprintf(stderr, "consumer: %s\n", e.what());
        return 2;
    }
}
