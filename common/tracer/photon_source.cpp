#include "common/tracer/photon_source.h"

#include <numbers>

#include "common/core/input_error.h"
#include "common/core/random.h"
#include "common/core/sampling.h"
#include "common/scene/surface_point.h"

namespace common {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

// --- power: total flux, W

Rgb power_of(const AreaEmitter& e) {
    return e.mean_radiance * (pi * e.area * (e.both_faces ? 2.0f : 1.0f));
}

Rgb power_of(const PointEmitter& e) {
    return e.light.intensity * (4 * pi);
}

/// Integral of the glTF falloff, the square of a linear ramp in cos(theta), over the cone.
Rgb power_of(const SpotEmitter& e) {
    const float inner = e.light.cos_inner_angle, outer = e.light.cos_outer_angle;
    return e.light.intensity * (2 * pi * ((1 - inner) + (inner - outer) / 3));
}

Rgb power_of(const DirectionalEmitter& e) {
    return e.light.irradiance * (pi * e.radius * e.radius);
}

/// Each point of the sphere lets pi L through towards the inside.
Rgb power_of(const SkyEmitter& e) {
    return e.sky.radiance * (pi * 4 * pi * e.radius * e.radius);
}

// --- emission: a photon that carries the emitter's whole power

EmittedPhoton emit_from(const Scene& scene, const AreaEmitter& e, const EmissionNumbers& numbers) {
    const Vec2 uv = sample_triangle(numbers.at[1], numbers.at[2]);
    const bool from_back = e.both_faces && numbers.towards[2] < 0.5f;
    const float side = from_back ? -1.0f : 1.0f;
    const Rgb radiance = e.textured ? emitted_radiance_at(scene, {e.triangle, uv.x, uv.y}) : e.mean_radiance;
    const float emitting_area = e.area * (e.both_faces ? 2.0f : 1.0f);
    return {e.corner + e.edge_u * uv.x + e.edge_v * uv.y, e.frame.to_world(numbers.lobe) * side,
            e.frame.normal * side, radiance * (pi * emitting_area), e.triangle};
}

EmittedPhoton emit_from(const Scene&, const PointEmitter& e, const EmissionNumbers& numbers) {
    const Vec3 direction = sample_sphere(numbers.towards[0], numbers.towards[1]);
    return {e.light.position, direction, direction, power_of(e)};
}

/// Uniform over the cone, weighted by the falloff at the sampled angle.
EmittedPhoton emit_from(const Scene&, const SpotEmitter& e, const EmissionNumbers& numbers) {
    const float inner = e.light.cos_inner_angle, outer = e.light.cos_outer_angle;
    const Vec3 local = sample_cone(outer, numbers.towards[0], numbers.towards[1]);
    const float ramp = std::clamp((local.z - outer) / std::max(inner - outer, 1e-6f), 0.0f, 1.0f);
    const Vec3 direction = Frame(e.light.axis).to_world(local);
    return {e.light.position, direction, direction, e.light.intensity * (ramp * ramp * 2 * pi * (1 - outer))};
}

EmittedPhoton emit_from(const Scene&, const DirectionalEmitter& e, const EmissionNumbers& numbers) {
    const Frame frame(e.light.direction);
    const Vec2 disc = sample_disc(numbers.at[1], numbers.at[2]) * e.radius;
    return {e.center + frame.to_world({disc.x, disc.y, -e.radius}), e.light.direction, e.light.direction,
            power_of(e)};
}

EmittedPhoton emit_from(const Scene&, const SkyEmitter& e, const EmissionNumbers& numbers) {
    const Vec3 outward = sample_sphere(numbers.at[1], numbers.at[2]);
    const Vec3 direction = Frame(-outward).to_world(numbers.lobe);
    return {e.center + outward * e.radius, direction, direction, power_of(e)};
}

// --- area lights

/// Mean over a fixed grid of points. An emissive texture that is dark at all of them still gets a share of
/// the photons.
Rgb mean_emitted_radiance(const Scene& scene, std::uint32_t triangle) {
    const Material& material = scene.material_of(triangle);
    if (material.emissive_texture.texture == no_texture) return material.emitted_radiance;
    constexpr int steps = 16;
    Rgb sum(0, 0, 0);
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            const Vec2 uv = sample_triangle((static_cast<float>(i) + 0.5f) / steps,
                                            (static_cast<float>(j) + 0.5f) / steps);
            sum += emitted_radiance_at(scene, {triangle, uv.x, uv.y});
        }
    constexpr float least_share = 0.01f;
    return sum * ((1 - least_share) / (steps * steps)) + material.emitted_radiance * least_share;
}

EmissionNumbers emission_numbers(std::uint64_t seed, std::uint64_t index) {
    const auto at = random_uniforms(seed, index, 0, RandomPurpose::emission_origin);
    const auto towards = random_uniforms(seed, index, 0, RandomPurpose::emission_direction);
    return {at, towards, sample_cosine_hemisphere(towards[0], towards[1])};
}

AreaEmitter area_emitter(const Scene& scene, std::uint32_t triangle) {
    const Material& material = scene.material_of(triangle);
    const auto [a, b, c] = scene.triangle[triangle];
    const Vec3& corner = scene.position[a];
    return {triangle,
            material.double_sided,
            material.emissive_texture.texture != no_texture,
            triangle_area(scene, triangle),
            mean_emitted_radiance(scene, triangle),
            corner,
            scene.position[b] - corner,
            scene.position[c] - corner,
            Frame(scene.geometric_normal[triangle])};
}

}  // namespace

PhotonSource::PhotonSource(const Scene& scene) : scene_(&scene) {
    for (std::uint32_t t = 0; t < scene.triangle.size(); ++t)
        if (scene.material_of(t).emits()) add(area_emitter(scene, t));
    for (const PointLight& light : scene.point_light) add(PointEmitter{light});
    for (const SpotLight& light : scene.spot_light) add(SpotEmitter{light});
    const Vec3 center = scene.bounds.center();
    const float radius = 0.5f * scene.diagonal();
    for (const DirectionalLight& light : scene.directional_light)
        add(DirectionalEmitter{light, center, radius});
    if (scene.sky) add(SkyEmitter{*scene.sky, center, radius});

    if (emitters_.empty())
        throw InputError(scene.source +
                         ": no light in the scene; add one with --sky R,G,B or --sun X,Y,Z,R,G,B");
    const double total = cumulative_.back();
    if (!std::isfinite(total) || !is_finite(power_))
        throw InputError(scene.source + ": its lights are too bright for float");
    for (const Emitter& emitter : emitters_) {
        const Rgb power = std::visit([](const auto& e) { return power_of(e); }, emitter);
        inverse_probability_.push_back(static_cast<float>(total / mean_component(power)));
    }
}

void PhotonSource::add(const Emitter& emitter) {
    const Rgb power = std::visit([](const auto& e) { return power_of(e); }, emitter);
    const float mean = mean_component(power);
    if (mean == 0) return;
    emitters_.push_back(emitter);
    cumulative_.push_back(mean + (cumulative_.empty() ? 0.0 : cumulative_.back()));
    power_ += power;
}

EmittedPhoton PhotonSource::emit(std::uint64_t seed, std::uint64_t index) const {
    return emit(emission_numbers(seed, index));
}

EmittedPhoton PhotonSource::emit(const EmissionNumbers& numbers) const {
    // Two numbers make one of 48 bits: 24 would never reach the faintest of many lights.
    const double choice = (numbers.at[0] + numbers.at[3] * 0x1p-24) * cumulative_.back();
    const auto found = std::upper_bound(cumulative_.begin(), cumulative_.end(), choice);
    const std::size_t chosen = std::min<std::size_t>(found - cumulative_.begin(), emitters_.size() - 1);
    EmittedPhoton photon =
        std::visit([&](const auto& e) { return emit_from(*scene_, e, numbers); }, emitters_[chosen]);
    photon.flux *= inverse_probability_[chosen];
    return photon;
}

void PhotonSource::emit(std::uint64_t seed, std::uint64_t first_photon, float surface_offset,
                        PhotonBatch& photons) const {
    // The random numbers first, a few photons at a time: that loop becomes vector code.
    constexpr std::size_t together = 64;
    std::array<EmissionNumbers, together> numbers;
    for (std::size_t begin = 0; begin < photons.size(); begin += together) {
        const std::size_t count = std::min(together, photons.size() - begin);
        for (std::size_t i = 0; i < count; ++i) numbers[i] = emission_numbers(seed, first_photon + begin + i);
        for (std::size_t i = 0; i < count; ++i) {
            const EmittedPhoton photon = emit(numbers[i]);
            photons.number[begin + i] = static_cast<std::uint32_t>(begin + i);
            photons.origin.set(begin + i, photon.origin + photon.normal * surface_offset);
            photons.direction.set(begin + i, photon.direction);
            photons.flux.set(begin + i, photon.flux);
        }
    }
}

}  // namespace common
