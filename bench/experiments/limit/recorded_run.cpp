#include "bench/experiments/limit/recorded_run.h"

#include <fmt/format.h>

#include <array>

#include "common/core/input_error.h"
#include "common/core/random.h"
#include "common/tracer/photon_order.h"
#include "common/tracer/scatter.h"

namespace bench::limit {
namespace {

using common::PhotonFate;
using common::Vec3;

constexpr std::size_t bytes_per_ray = 6 * sizeof(float);

/// Follows one photon from its light to its end.
PhotonFate follow(const common::RayScene& rays, const common::PhotonSource& source, std::uint64_t seed,
                  std::uint64_t photon, RecordedRun& run) {
    const common::EmittedPhoton emitted = source.emit(seed, photon);
    if (emitted.triangle && rays.is_covered(*emitted.triangle, emitted.origin, emitted.normal))
        return PhotonFate::absorbed;
    Vec3 origin = rays.off_surface(emitted.origin, emitted.normal), direction = emitted.direction;
    common::Rgb flux = emitted.flux;
    if (flux == common::Rgb(0, 0, 0)) return PhotonFate::without_light;
    for (std::uint32_t event = 0; event < source.most_events(); ++event) {
        run.add(origin, direction);
        const auto met = rays.nearest(origin, direction);
        if (!met) return event == 0 ? PhotonFate::missed : PhotonFate::escaped;
        const common::PhotonSurface& surface = rays.surfaces()[met->triangle];
        run.report.hits += surface.stores();
        const auto u = random_uniforms(seed, photon, event, common::RandomPurpose::scattering);
        const auto scattered = common::scatter(rays.scene(), *met, direction, flux, u);
        if (!scattered) return PhotonFate::absorbed;
        const Vec3 position = surface.position(met->u, met->v);
        origin = rays.off_surface(position, scattered->normal);
        direction = scattered->direction;
        flux = scattered->flux;
    }
    return PhotonFate::given_up;
}

void check_size(const RecordedRun& run, std::size_t max_bytes) {
    const double in_blocks = static_cast<double>(run.blocks.size() * rays_per_block * bytes_per_ray);
    if (in_blocks > static_cast<double>(max_bytes))
        throw common::InputError(
            fmt::format("--hits: the rays of the first {:.3g} fill {:.3g} GiB, no more are free",
                        static_cast<double>(run.report.hits), in_blocks * 0x1p-30));
}

}  // namespace

void RecordedRun::add(const Vec3& origin, const Vec3& direction) {
    const std::size_t place = rays++ % rays_per_block;
    if (place == 0) {
        blocks.emplace_back();
        blocks.back().resize(rays_per_block);
    }
    blocks.back().origin.set(place, origin);
    blocks.back().direction.set(place, direction);
}

RecordedRun record_run(const common::RayScene& rays, const common::PhotonSource& source, std::uint64_t seed,
                       std::uint64_t hits, std::size_t max_bytes, const RecordProgress& progress) {
    RecordedRun run;
    for (std::uint64_t photon = 0; run.report.hits < hits; ++photon) {
        const std::array<PhotonFate, 1> fate = {follow(rays, source, seed, photon, run)};
        run.report.fates.add(fate);
        if (photon % common::photons_per_block != 0) continue;
        check_that_photons_hit(run.report, {.hits = hits});
        check_size(run, max_bytes);
        if (!progress(run)) break;
    }
    if (!run.blocks.empty()) run.blocks.back().resize(run.rays - (run.blocks.size() - 1) * rays_per_block);
    return run;
}

std::vector<RayBlock> sorted_blocks(const std::vector<RayBlock>& blocks, const Imath::Box3f& bounds) {
    common::PhotonOrder order(bounds);
    common::PhotonBatch photons, in_order;
    std::vector<RayBlock> sorted;
    for (const RayBlock& block : blocks) {
        photons.resize(block.size());
        photons.origin = block.origin;
        photons.direction = block.direction;
        const std::vector<std::uint32_t> all(block.size(), 1);
        in_order.gather(photons, order.sort(photons, all));
        sorted.push_back({in_order.origin, in_order.direction});
    }
    return sorted;
}

}  // namespace bench::limit
