#include "common/tracer/trace_block.h"

#include "common/core/random.h"
#include "common/tracer/scatter.h"

namespace common {
namespace {

struct Photon {
    std::uint64_t index;
    Vec3 origin;
    Vec3 direction;
    Rgb flux;
};

std::vector<Photon> emit_block(const PhotonSource& source, const RayScene& rays, std::uint64_t seed,
                               std::uint64_t first_photon, std::uint64_t count) {
    std::vector<Photon> photons;
    photons.reserve(count);
    for (std::uint64_t index = first_photon; index < first_photon + count; ++index) {
        const EmittedPhoton emitted = source.emit(seed, index);
        photons.push_back(
            {index, rays.off_surface(emitted.origin, emitted.normal), emitted.direction, emitted.flux});
    }
    return photons;
}

}  // namespace

PhotonFates& PhotonFates::operator+=(const PhotonFates& other) {
    emitted += other.emitted;
    missed += other.missed;
    escaped += other.escaped;
    absorbed += other.absorbed;
    given_up += other.given_up;
    return *this;
}

PhotonFates trace_block(const RayScene& rays, const PhotonSource& source, std::uint64_t seed,
                        std::uint64_t first_photon, std::uint64_t count, HitBatch& hits) {
    const Scene& scene = rays.scene();
    hits.clear();
    PhotonFates fates{.emitted = count};
    std::vector<Photon> alive = emit_block(source, rays, seed, first_photon, count);

    for (std::uint32_t event = 0; !alive.empty() && event < max_events; ++event) {
        std::size_t survivors = 0;
        for (const Photon& photon : alive) {
            const std::optional<SurfaceId> surface = rays.nearest(photon.origin, photon.direction);
            if (!surface) {
                ++(event == 0 ? fates.missed : fates.escaped);
                continue;
            }
            const Vec3 position = position_at(scene, *surface);
            if (scene.material_of(surface->triangle).kind == SurfaceKind::diffuse)
                hits.push_back(position, photon.direction, photon.flux, *surface);

            const auto u = random_uniforms(seed, photon.index, event, RandomPurpose::scattering);
            if (const auto next = scatter(scene, *surface, photon.direction, photon.flux, u))
                alive[survivors++] = {photon.index, rays.off_surface(position, next->normal), next->direction,
                                      next->flux};
            else
                ++fates.absorbed;
        }
        alive.resize(survivors);
    }
    fates.given_up = alive.size();
    return fates;
}

}  // namespace common
