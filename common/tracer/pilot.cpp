#include "common/tracer/pilot.h"

#include <algorithm>
#include <map>

#include "common/core/random.h"
#include "common/scene/coverage.h"
#include "common/tracer/photon_source.h"
#include "common/tracer/ray_scene.h"
#include "common/tracer/scatter.h"

namespace common {
namespace {

constexpr std::uint64_t pilot_seed = 0x50494c4f54;  // the seed of a run with a probability of 2^-64

/// The number of photons of all lights together, and its limits for each light.
constexpr std::size_t photons_in_all = 1 << 15, least_photons = 64, most_photons = 1 << 12;
constexpr std::uint64_t photons_to_the_end = 32;

enum class Arrival { none, front, back, absorbed };

/// Returns on which side a photon first hits a diffuse surface.
Arrival first_arrival(const RayScene& rays, const EmittedPhoton& photon, std::uint64_t number) {
    const Scene& scene = rays.scene();
    Vec3 origin = rays.off_surface(photon.origin, photon.normal), direction = photon.direction;
    constexpr std::uint32_t most_events = 64;  // light behind more glass than that may count as lost
    for (std::uint32_t event = 0; event < most_events; ++event) {
        const auto met = rays.nearest(origin, direction);
        if (!met) return Arrival::none;
        const Material& material = scene.material_of(met->triangle);
        const auto u = random_uniforms(pilot_seed, number, event, RandomPurpose::scattering);
        if (material.kind == SurfaceKind::diffuse && u[3] < coverage_at(scene, *met)) {
            const bool front = direction.dot(scene.geometric_normal[met->triangle]) < 0;
            return front || material.double_sided ? Arrival::front : Arrival::back;
        }
        const auto scattered = scatter(scene, *met, direction, photon.flux, u);
        if (!scattered) return Arrival::absorbed;
        origin = rays.off_surface(position_at(scene, *met), scattered->normal);
        direction = scattered->direction;
    }
    return Arrival::none;
}

/// Returns whether a photon is still alive after max_events surfaces.
bool is_endless(const RayScene& rays, const EmittedPhoton& photon, std::uint64_t number) {
    Vec3 origin = rays.off_surface(photon.origin, photon.normal), direction = photon.direction;
    Rgb flux = photon.flux;
    for (std::uint32_t event = 0; event < max_events; ++event) {
        const auto met = rays.nearest(origin, direction);
        if (!met) return false;
        const auto u = random_uniforms(pilot_seed, number, event, RandomPurpose::scattering);
        const auto scattered = scatter(rays.scene(), *met, direction, flux, u);
        if (!scattered) return false;
        origin = rays.off_surface(position_at(rays.scene(), *met), scattered->normal);
        direction = scattered->direction;
        flux = scattered->flux;
    }
    return true;
}

std::string name_of(const Scene& scene, const Emitter& emitter) {
    const auto or_kind = [](const std::string& name, const char* kind) { return name.empty() ? kind : name; };
    if (const auto* area = std::get_if<AreaEmitter>(&emitter)) {
        const std::string& name = scene.material_of(area->triangle).name;
        return name.empty() ? "a material that emits" : "material '" + name + "'";
    }
    if (const auto* point = std::get_if<PointEmitter>(&emitter))
        return or_kind(point->light.name, "a point light");
    if (const auto* spot = std::get_if<SpotEmitter>(&emitter))
        return or_kind(spot->light.name, "a spot light");
    if (const auto* sun = std::get_if<DirectionalEmitter>(&emitter))
        return or_kind(sun->light.name, "a directional light");
    return "the sky";
}

/// Treats the triangles of one material as one light, and every other emitter as one of its own.
class Lights {
  public:
    Lights(const Scene& scene, const PhotonSource& source, Pilot& pilot) : source_(source), pilot_(pilot) {
        std::map<std::uint32_t, std::uint32_t> of_material;
        for (std::size_t e = 0; e < source.emitters().size(); ++e) {
            const Emitter& emitter = source.emitters()[e];
            auto light = static_cast<std::uint32_t>(pilot.light.size());
            if (const auto* area = std::get_if<AreaEmitter>(&emitter))
                light =
                    of_material.try_emplace(scene.instance[scene.instance_of[area->triangle]].material, light)
                        .first->second;
            if (light == pilot.light.size()) {
                pilot.light.push_back({name_of(scene, emitter)});
                emitters_.emplace_back();
            }
            pilot.light_of_emitter.push_back(light);
            Emitters& of_light = emitters_[light];
            of_light.number.push_back(e);
            of_light.cumulative.push_back((of_light.cumulative.empty() ? 0 : of_light.cumulative.back()) +
                                          source.mean_power(e));
        }
    }

    [[nodiscard]] std::size_t size() const { return emitters_.size(); }

    void measure(const RayScene& rays, std::size_t light, std::size_t photons) {
        const Emitters& emitters = emitters_[light];
        double emitted = 0, missed = 0, on_backs = 0;
        for (std::size_t i = 0; i < photons; ++i) {
            const std::uint64_t number = light * most_photons + i;
            // Stratified over the light's emitters and, on those with a texture, over their emission.
            const double place =
                emitters.cumulative.back() * (static_cast<double>(i) + 0.5) / static_cast<double>(photons);
            const auto chosen =
                std::upper_bound(emitters.cumulative.begin(), emitters.cumulative.end() - 1, place);
            const double before = chosen == emitters.cumulative.begin() ? 0.0 : *(chosen - 1);
            const double within = std::clamp((place - before) / (*chosen - before), 0.0, 1 - 0x1p-30);
            const EmittedPhoton photon = source_.emit_from(
                emitters.number[static_cast<std::size_t>(chosen - emitters.cumulative.begin())],
                emission_numbers(pilot_seed, number), within);
            const double light_carried = static_cast<double>(mean_component(photon.flux));
            if (light_carried == 0) continue;
            const Arrival arrival = first_arrival(rays, photon, number);
            emitted += light_carried;
            missed += arrival == Arrival::none ? light_carried : 0;
            on_backs += arrival == Arrival::back ? light_carried : 0;
        }
        pilot_.light[light].missed = emitted > 0 ? missed / emitted : 0;
        pilot_.light[light].on_backs = emitted > missed ? on_backs / (emitted - missed) : 0;
    }

  private:
    /// The emitters of one light.
    struct Emitters {
        std::vector<std::size_t> number;
        std::vector<double> cumulative;  ///< power
    };

    const PhotonSource& source_;
    Pilot& pilot_;
    std::vector<Emitters> emitters_;
};

}  // namespace

Pilot send_pilot(const RayScene& rays, const PhotonSource& source) {
    Pilot pilot;
    Lights lights(rays.scene(), source, pilot);
    const std::size_t of_each = std::clamp(photons_in_all / lights.size(), least_photons, most_photons);
    for (std::size_t light = 0; light < lights.size(); ++light) lights.measure(rays, light, of_each);
    for (std::uint64_t photon = 0; photon < photons_to_the_end; ++photon)
        pilot.endless +=
            is_endless(rays, source.emit(pilot_seed, photon), photon) ? 1.0 / photons_to_the_end : 0;
    return pilot;
}

}  // namespace common
