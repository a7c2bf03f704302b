#include "common/tracer/trace_block.h"

#include <utility>

#include "common/core/random.h"
#include "common/tracer/scatter.h"

namespace common {
namespace {

/// Triangles are prefetched for this many photons ahead: about the time of a cache miss.
constexpr std::size_t prefetch_distance = 16;

}  // namespace

void TracedBlock::keep_photons(std::uint64_t first, std::uint64_t end) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < hits.size(); ++i)
        if (hits.photon[i] >= first && hits.photon[i] < end)
            hits.set(kept++, hits.position[i], hits.direction[i], hits.flux[i], hits.surface[i],
                     hits.photon[i]);
    hits.resize(kept);
    fate.resize(end);
    fate.erase(fate.begin(), fate.begin() + static_cast<std::ptrdiff_t>(first));
}

std::uint64_t TracedBlock::photons_with(std::uint64_t wanted, std::uint64_t first) const {
    std::vector<std::uint64_t> hits_of(photons_per_block, 0);
    for (const std::uint32_t photon : hits.photon) ++hits_of[photon];
    std::uint64_t found = 0;
    for (std::uint64_t photon = first; photon < photons_per_block; ++photon)
        if ((found += hits_of[photon]) >= wanted) return photon + 1;
    return photons_per_block;
}

BlockTracer::BlockTracer(const RayScene& rays, const PhotonSource& source, std::uint64_t seed,
                         RecordedHits recorded)
    : rays_(&rays), source_(&source), seed_(seed), recorded_(recorded), order_(rays.scene().bounds) {}

void BlockTracer::trace(std::uint64_t block, TracedBlock& traced) {
    const std::uint64_t first_photon = block * photons_per_block;
    traced.hits.clear();
    traced.fate.assign(photons_per_block, PhotonFate::absorbed);

    reflected_.resize(photons_per_block);
    survived_.assign(photons_per_block, 1);
    source_->emit(seed_, first_photon, rays_->surface_offset(), reflected_);
    drop_dark(traced);
    if (rays_->may_cover_lights()) drop_covered(first_photon);
    direct_.assign(recorded_ == RecordedHits::indirect ? photons_per_block : 0, true);
    const std::uint32_t most_events = source_->most_events();
    for (std::uint32_t event = 0; event < most_events; ++event) {
        const std::span<const std::uint32_t> alive = order_.sort(reflected_, survived_);
        if (alive.empty()) return;
        photons_.gather(reflected_, alive);
        rays_->nearest(photons_.origin, photons_.direction, met_);
        drop_escaped(event, traced);
        find_arrivals();
        look_up_textures();
        look_up_vertex_colors();
        if (recorded_ == RecordedHits::indirect) leave_out_direct();
        record_hits(traced.hits);
        reflect_diffuse(first_photon, event);
        scatter_others(first_photon, event);
        if (recorded_ == RecordedHits::indirect) keep_direct();
    }
    for (std::size_t i = 0; i < reflected_.size(); ++i)
        if (survived_[i]) traced.fate[reflected_.number[i]] = PhotonFate::given_up;
}

/// Drops photons without flux: their hits would contribute nothing.
void BlockTracer::drop_dark(TracedBlock& traced) {
    for (std::size_t i = 0; i < reflected_.size(); ++i) {
        if (Rgb(reflected_.flux[i]) != Rgb(0, 0, 0)) continue;
        survived_[i] = 0;
        traced.fate[i] = PhotonFate::without_light;
    }
}

/// Ends photons that start on a light which another surface covers.
void BlockTracer::drop_covered(std::uint64_t first_photon) {
    for (std::size_t i = 0; i < reflected_.size(); ++i) {
        const EmittedPhoton photon = source_->emit(seed_, first_photon + i);
        if (photon.triangle && rays_->is_covered(*photon.triangle, photon.origin, photon.normal))
            survived_[i] = 0;
    }
}

/// Ends photons that hit nothing.
void BlockTracer::drop_escaped(std::uint32_t event, TracedBlock& traced) {
    if (std::find(met_.triangle.begin(), met_.triangle.end(), no_triangle) == met_.triangle.end()) return;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < photons_.size(); ++i) {
        if (met_.triangle[i] == no_triangle) {
            traced.fate[photons_.number[i]] = event == 0 ? PhotonFate::missed : PhotonFate::escaped;
            continue;
        }
        photons_.number[kept] = photons_.number[i];
        photons_.origin.set(kept, photons_.origin[i]);
        photons_.direction.set(kept, photons_.direction[i]);
        photons_.flux.set(kept, photons_.flux[i]);
        met_.set(kept, met_[i]);
        ++kept;
    }
    photons_.resize(kept);
    met_.resize(kept);
}

void BlockTracer::find_arrivals() {
    const std::size_t count = photons_.size();
    position_.resize(count);
    normal_.resize(count);
    base_color_.resize(count);
    stores_.resize(count);
    textured_.clear();
    colored_.clear();
    others_.clear();
    const PhotonSurfaces& surfaces = rays_->surfaces();
    for (std::size_t i = 0; i < count; ++i) {
        if (i + prefetch_distance < count)
            __builtin_prefetch(&surfaces[met_.triangle[i + prefetch_distance]]);
        const PhotonSurface& surface = surfaces[met_.triangle[i]];
        position_.set(i, surface.position(met_.u[i], met_.v[i]));
        const bool front = photons_.direction[i].dot(surface.normal) < 0;
        normal_.set(i, front ? surface.normal : -surface.normal);
        base_color_.set(i, surface.base_color);
        stores_[i] = surface.stores();
        if (surface.kind == PhotonSurface::diffuse) continue;
        if (surface.is_textured()) textured_.push_back(static_cast<std::uint32_t>(i));
        if (surface.is_colored()) colored_.push_back(static_cast<std::uint32_t>(i));
        if (!surface.is_simple()) others_.push_back(static_cast<std::uint32_t>(i));
    }
}

/// In steps, a few photons at a time: each step finds in the cache what the one before has prefetched.
void BlockTracer::look_up_textures() {
    constexpr std::size_t together = 32;
    std::array<Texture::Footprint, together> footprint;
    const PhotonSurfaces& surfaces = rays_->surfaces();
    for (std::size_t begin = 0; begin < textured_.size(); begin += together) {
        const std::span<const std::uint32_t> some =
            std::span(textured_).subspan(begin, std::min(together, textured_.size() - begin));
        for (const std::uint32_t i : some) __builtin_prefetch(&surfaces.texture(met_.triangle[i]));
        for (std::size_t k = 0; k < some.size(); ++k) {
            const SurfaceTexture& at = surfaces.texture(met_.triangle[some[k]]);
            footprint[k] = at.texture->footprint(at.texcoord(met_.u[some[k]], met_.v[some[k]]));
            at.texture->prefetch(footprint[k]);
        }
        for (std::size_t k = 0; k < some.size(); ++k) {
            const std::uint32_t i = some[k];
            const Rgb factor = surfaces[met_.triangle[i]].base_color;
            base_color_.set(i, factor * surfaces.texture(met_.triangle[i]).texture->filter(footprint[k]));
        }
    }
}

void BlockTracer::look_up_vertex_colors() {
    const PhotonSurfaces& surfaces = rays_->surfaces();
    for (std::size_t k = 0; k < colored_.size(); ++k) {
        if (k + prefetch_distance < colored_.size())
            __builtin_prefetch(&surfaces.colors(met_.triangle[colored_[k + prefetch_distance]]));
        const std::uint32_t i = colored_[k];
        const Rgb color = surfaces.colors(met_.triangle[i]).color(met_.u[i], met_.v[i]);
        base_color_.set(i, Rgb(base_color_[i]) * color);
    }
}

/// A photon stays direct where it goes straight on.
void BlockTracer::keep_direct() {
    std::erase_if(went_straight_, [&](std::uint32_t number) { return !direct_[number]; });
    direct_.assign(photons_per_block, false);
    for (const std::uint32_t number : went_straight_) direct_[number] = true;
}

void BlockTracer::leave_out_direct() {
    for (std::size_t i = 0; i < photons_.size(); ++i)
        if (direct_[photons_.number[i]]) stores_[i] = 0;
}

void BlockTracer::record_hits(HitBatch& hits) {
    std::size_t next = hits.size();
    hits.resize(next + photons_.size());
    for (std::size_t i = 0; i < photons_.size(); ++i) {
        hits.set(next, position_[i], photons_.direction[i], Rgb(photons_.flux[i]), met_[i],
                 photons_.number[i]);
        next += stores_[i];
    }
    hits.resize(next);
}

/// Treats all surfaces as diffuse and opaque; the few others are handled afterwards. No branch and no call,
/// so that the compiler vectorises the loop.
void BlockTracer::reflect_diffuse(std::uint64_t first_photon, std::uint32_t event) {
    const std::size_t count = photons_.size();
    reflected_.resize(count);
    survived_.resize(count);
    std::copy(photons_.number.begin(), photons_.number.end(), reflected_.number.begin());

    const std::uint32_t* const number = photons_.number.data();
    std::uint32_t* const survived = survived_.data();
    const Vec3View<const float> flux = std::as_const(photons_).flux.view(),
                                position = std::as_const(position_).view(),
                                normal = std::as_const(normal_).view(),
                                base_color = std::as_const(base_color_).view();
    const Vec3View<float> new_flux = reflected_.flux.view(), new_direction = reflected_.direction.view(),
                          new_origin = reflected_.origin.view();
    const float offset = rays_->surface_offset();
    const std::uint64_t seed = seed_;
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) {
        const auto u = random_uniforms(seed, first_photon + number[i], event, RandomPurpose::scattering);
        const Rgb arriving = flux[i];
        const Roulette roulette = play_roulette(arriving, arriving * Rgb(base_color[i]), u[0]);
        survived[i] = roulette.survived;
        new_flux.set(i, roulette.flux);
        new_direction.set(i, reflect_diffusely(normal[i], u[1], u[2]));
        new_origin.set(i, position[i] + normal[i] * offset);
    }
}

void BlockTracer::scatter_others(std::uint64_t first_photon, std::uint32_t event) {
    went_straight_.clear();
    for (const std::uint32_t i : others_) {
        const auto u =
            random_uniforms(seed_, first_photon + photons_.number[i], event, RandomPurpose::scattering);
        const auto scattered =
            scatter(rays_->scene(), met_[i], photons_.direction[i], Rgb(photons_.flux[i]), u);
        survived_[i] = scattered.has_value();
        if (!scattered) continue;
        if (scattered->straight) went_straight_.push_back(photons_.number[i]);
        reflected_.origin.set(i, rays_->off_surface(position_[i], scattered->normal));
        reflected_.direction.set(i, scattered->direction);
        reflected_.flux.set(i, scattered->flux);
    }
}

}  // namespace common
