#include "common/tracer/photon_source.h"

#include <numbers>

#include "common/core/input_error.h"
#include "common/core/random.h"
#include "common/core/sampling.h"
#include "common/core/scrambled_sobol.h"
#include "common/scene/coverage.h"
#include "common/tracer/ray_scene.h"

namespace common {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

// --- power: total flux, W

Rgb power_of(const AreaEmitter& e) {
    return e.mean_radiance * (pi * e.area * (e.both_faces ? 2.0f : 1.0f));
}

Rgb power_of(const PointEmitter& e) {
    return e.light.intensity * (e.towards_scene ? 2 * pi * e.towards_scene->versine : 4 * pi);
}

/// Integral of the glTF falloff, the square of a linear ramp in cos(theta), over the cone.
Rgb power_of(const SpotEmitter& e) {
    if (e.light.is_narrow()) {
        const double inner = 1 - e.light.cos_inner_angle, outer = 1 - e.light.cos_outer_angle;
        return e.light.intensity * static_cast<float>(2 * std::numbers::pi * (inner + (outer - inner) / 3));
    }
    const auto inner = static_cast<float>(e.light.cos_inner_angle),
               outer = static_cast<float>(e.light.cos_outer_angle);
    return e.light.intensity * (2 * pi * ((1 - inner) + (inner - outer) / 3));
}

Rgb power_of(const DirectionalEmitter& e) {
    return e.light.irradiance * e.entry.area_across(e.light.direction);
}

/// The irradiance at each point of the box is pi L towards the inside.
Rgb power_of(const SkyEmitter& e) {
    return e.sky.radiance * (pi * e.entry.area());
}

// --- emission: a photon that carries the emitter's whole power

/// Returns the mean over coverage, W/(m^2 sr): a hole emits nothing.
Rgb radiance_at(const Scene& scene, const SurfaceId& surface) {
    return emitted_radiance_at(scene, surface) * coverage_at(scene, surface);
}

/// Returns a unit vector around +z whose cosine is 1 - `versine`, accurate for arbitrarily small angles.
Vec3 direction_off_axis(float versine, float turn) {
    const float sine = std::sqrt(versine * (2 - versine));
    const Vec2 azimuth = circle_at(turn);
    return {sine * azimuth.x, sine * azimuth.y, 1 - versine};
}

EmittedPhoton emit_from(const Scene& scene, const AreaEmitter& e, const EmissionNumbers& numbers,
                        double within) {
    Vec2 uv = sample_triangle(numbers.at[1], numbers.at[2]);
    float density = 1;
    if (e.cells) {
        const EmissionCells::Place place = e.cells->place(within, numbers.at[1], numbers.at[2]);
        uv = place.uv;
        density = place.density;
    }
    const Rgb radiance =
        e.varies ? radiance_at(scene, {e.triangle, uv.x, uv.y}) * (1 / density) : e.mean_radiance;
    const bool from_back = e.both_faces && numbers.towards[2] < 0.5f;
    const float side = from_back ? -1.0f : 1.0f;
    const float emitting_area = e.area * (e.both_faces ? 2.0f : 1.0f);
    return {e.corner + e.edge_u * uv.x + e.edge_v * uv.y, e.frame.to_world(numbers.lobe) * side,
            e.frame.normal * side, radiance * (pi * emitting_area), e.triangle};
}

EmittedPhoton emit_from(const Scene&, const PointEmitter& e, const EmissionNumbers& numbers, double) {
    Vec3 direction = sample_sphere(numbers.towards[0], numbers.towards[1]);
    if (e.towards_scene)
        direction = Frame(e.towards_scene->axis)
                        .to_world(direction_off_axis(numbers.towards[0] * e.towards_scene->versine,
                                                     numbers.towards[1]));
    return {e.light.position, direction, direction, power_of(e)};
}

/// Does the same as for wide cones, in terms of 1 - cosine.
EmittedPhoton emit_from_narrow(const SpotLight& light, const EmissionNumbers& numbers) {
    const auto inner = static_cast<float>(1 - light.cos_inner_angle),
               outer = static_cast<float>(1 - light.cos_outer_angle);
    const float versine = numbers.towards[0] * outer;
    const float ramp = versine <= inner ? 1.0f : (outer - versine) / (outer - inner);
    const Vec3 direction = Frame(light.axis).to_world(direction_off_axis(versine, numbers.towards[1]));
    return {light.position, direction, direction, light.intensity * (ramp * ramp * 2 * pi * outer)};
}

/// Uniform over the cone, weighted by the falloff at the sampled angle.
EmittedPhoton emit_from(const Scene&, const SpotEmitter& e, const EmissionNumbers& numbers, double) {
    if (e.light.is_narrow()) return emit_from_narrow(e.light, numbers);
    const auto inner = static_cast<float>(e.light.cos_inner_angle),
               outer = static_cast<float>(e.light.cos_outer_angle);
    const Vec3 local = sample_cone(outer, numbers.towards[0], numbers.towards[1]);
    const float ramp = std::clamp((local.z - outer) / std::max(inner - outer, 1e-6f), 0.0f, 1.0f);
    const Vec3 direction = Frame(e.light.axis).to_world(local);
    return {e.light.position, direction, direction, e.light.intensity * (ramp * ramp * 2 * pi * (1 - outer))};
}

/// Starts outside the box, as surfaces may lie on its faces.
EmittedPhoton emit_from(const Scene&, const DirectionalEmitter& e, const EmissionNumbers& numbers, double) {
    const Vec3& direction = e.light.direction;
    const BoundsEntry::Place place =
        e.entry.place_across(direction, numbers.towards[0], numbers.at[1], numbers.at[2]);
    return {place.position - direction * e.entry.reach(), direction, direction, power_of(e)};
}

EmittedPhoton emit_from(const Scene&, const SkyEmitter& e, const EmissionNumbers& numbers, double) {
    const BoundsEntry::Place place = e.entry.place(numbers.towards[2], numbers.at[1], numbers.at[2]);
    const Vec3 direction = Frame(-place.outward).to_world(numbers.lobe);
    return {place.position - direction * e.entry.reach(), direction, direction, power_of(e)};
}

// --- area lights

bool emission_varies(const Scene& scene, std::uint32_t triangle) {
    const CoverageRange coverage = coverage_range(scene, triangle);
    return scene.material_of(triangle).emissive_texture.texture != no_texture ||
           coverage.least != coverage.most;
}

/// Cuts all triangles with an emissive texture into cells.
class TexturedEmission {
  public:
    explicit TexturedEmission(const Scene& scene) : scene_(scene), brightest_(scene.texture.size()) {
        std::size_t triangles = 0;
        for (std::uint32_t t = 0; t < scene.triangle.size(); ++t)
            triangles += is_textured(scene.material_of(t));
        constexpr std::size_t cells_in_all = 1 << 16;
        most_cells_ = cells_in_all / std::max<std::size_t>(1, triangles);
    }

    /// Returns null for a triangle without such a texture.
    std::shared_ptr<const EmissionCells> cells_of(std::uint32_t triangle) {
        const Material& material = scene_.material_of(triangle);
        if (!is_textured(material)) return nullptr;
        std::optional<BrightestTexels>& brightest = brightest_[material.emissive_texture.texture];
        if (!brightest) brightest.emplace(scene_.texture[material.emissive_texture.texture]);
        return std::make_shared<const EmissionCells>(scene_, triangle, *brightest, most_cells_);
    }

  private:
    static bool is_textured(const Material& material) {
        return material.emits() && material.emissive_texture.texture != no_texture;
    }

    const Scene& scene_;
    std::vector<std::optional<BrightestTexels>> brightest_;  ///< one per texture, as they are needed
    std::size_t most_cells_;
};

/// Returns the mean with holes included. With holes it is estimated on a fixed grid of points; a lamp with
/// holes at all of them still gets a share of the photons.
Rgb mean_emitted_radiance(const Scene& scene, std::uint32_t triangle, const EmissionCells* cells) {
    const CoverageRange coverage = coverage_range(scene, triangle);
    const Rgb whole =
        (cells ? cells->mean_radiance() : scene.material_of(triangle).emitted_radiance) * coverage.most;
    if (coverage.least == coverage.most) return whole;
    constexpr int steps = 16;
    Rgb sum(0, 0, 0);
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            const Vec2 uv = sample_triangle((static_cast<float>(i) + 0.5f) / steps,
                                            (static_cast<float>(j) + 0.5f) / steps);
            sum += radiance_at(scene, {triangle, uv.x, uv.y});
        }
    constexpr float least_share = 0.01f;
    return sum * ((1 - least_share) / (steps * steps)) + whole * least_share;
}

AreaEmitter area_emitter(const Scene& scene, std::uint32_t triangle,
                         std::shared_ptr<const EmissionCells> cells) {
    const Material& material = scene.material_of(triangle);
    const auto [a, b, c] = scene.triangle[triangle];
    const Vec3& corner = scene.position[a];
    const Rgb mean_radiance = mean_emitted_radiance(scene, triangle, cells.get());
    return {triangle,
            material.double_sided,
            std::move(cells),
            emission_varies(scene, triangle),
            triangle_area(scene, triangle),
            mean_radiance,
            corner,
            scene.position[b] - corner,
            scene.position[c] - corner,
            Frame(scene.geometric_normal[triangle])};
}

// --- point lights

/// Beyond this distance, in radii of the scene's bounding sphere, a light emits only towards the sphere. Of
/// photons in all directions, fewer than 7 in 100 would hit it.
constexpr double far_in_radii = 2;

PointEmitter point_emitter(const Scene& scene, const PointLight& light) {
    if (scene.bounds.isEmpty()) return {light, {}};
    const Imath::V3d towards = Imath::V3d(scene.bounds.center()) - Imath::V3d(light.position);
    // A little larger than the sphere, for rounding.
    const double radius = 0.501 * static_cast<double>(scene.diagonal()), distance = towards.length();
    if (distance <= far_in_radii * radius) return {light, {}};
    const double sine = radius / distance;
    const double versine = sine * sine / (1 + std::sqrt(1 - sine * sine));
    return {light, Cone{Vec3(towards / distance), static_cast<float>(versine)}};
}

/// Always inline, as only then the compiler vectorises the loop over photons: a tenth of the time of tracing.
[[gnu::always_inline]] inline EmissionNumbers numbers_of(std::uint64_t seed, std::uint64_t index) {
    const auto at = random_uniforms(seed, index, 0, RandomPurpose::emission_origin);
    const auto towards = random_uniforms(seed, index, 0, RandomPurpose::emission_direction);
    return {at, towards, sample_cosine_hemisphere(towards[0], towards[1])};
}

/// Photons whose numbers are made together, from a multiple of as many on.
constexpr std::size_t together = ScrambledSobol::block;

/// The direction has the first two coordinates, whose pairs are spread best; points of light have no other.
class SobolEmission {
  public:
    SobolEmission(std::uint64_t seed, std::uint64_t index)
        : points_(static_cast<std::uint32_t>(index), keys(seed, index >> 32)) {}

    [[nodiscard]] EmissionNumbers numbers(std::uint64_t index) const {
        const auto i = static_cast<std::uint32_t>(index % together);
        // All 32 bits choose the light: the first 24, then the other 8.
        const std::uint32_t choice = points_.bits(4, i);
        const std::array<float, 4> at = {static_cast<float>(choice >> 8) * 0x1p-24f, points_.uniform(2, i),
                                         points_.uniform(3, i), static_cast<float>(choice & 0xff) * 0x1p-8f};
        const std::array<float, 4> towards = {points_.uniform(0, i), points_.uniform(1, i),
                                              points_.uniform(5, i), 0};
        return {at, towards, sample_cosine_hemisphere(towards[0], towards[1])};
    }

  private:
    static std::array<std::uint32_t, sobol_dimensions> keys(std::uint64_t seed, std::uint64_t high_bits) {
        const auto a = random_bits(seed, high_bits, 0, RandomPurpose::scramble_of_origin),
                   b = random_bits(seed, high_bits, 0, RandomPurpose::scramble_of_direction);
        return {b[0], b[1], a[0], a[1], a[2], b[2]};
    }

    ScrambledSobol points_;
};

}  // namespace

EmissionNumbers emission_numbers(std::uint64_t seed, std::uint64_t index) {
    return numbers_of(seed, index);
}

PhotonSource::PhotonSource(const Scene& scene) : scene_(&scene) {
    TexturedEmission textured(scene);
    for (std::uint32_t t = 0; t < scene.triangle.size(); ++t)
        if (scene.material_of(t).emits()) add(area_emitter(scene, t, textured.cells_of(t)));
    for (const PointLight& light : scene.point_light) add(point_emitter(scene, light));
    for (const SpotLight& light : scene.spot_light) add(SpotEmitter{light});
    const BoundsEntry entry(scene.bounds);
    for (const DirectionalLight& light : scene.directional_light) add(DirectionalEmitter{light, entry});
    if (scene.sky) add(SkyEmitter{*scene.sky, entry});

    if (emitters_.empty()) throw NoLight(scene.source + ": no light in the scene");
    const double total = cumulative_.back();
    if (!std::isfinite(total) || !is_finite(power_))
        throw InputError(scene.source + ": its lights are too bright for float");
    for (std::size_t e = 0; e < emitters_.size(); ++e)
        inverse_probability_.push_back(static_cast<float>(total / mean_power(e)));
}

PhotonSource::PhotonSource(const RayScene& rays, EmissionSequence sequence) : PhotonSource(rays.scene()) {
    pilot_ = send_pilot(rays, *this);
    weigh_by_pilot();
    sequence_ = sequence;
    constexpr double nearly_all = 15.0 / 16;
    if (pilot_.endless >= nearly_all) most_events_ = max_events_of_endless_light;
}

void PhotonSource::weigh_by_pilot() {
    constexpr double least = 0.01;
    std::vector<double> factor;
    for (const LightReach& reach : pilot_.light)
        factor.push_back(reach.missed > 0.5 ? std::max(1 - reach.missed, least) : 1.0);
    // If all lose the same share, the probabilities do not change.
    if (std::all_of(factor.begin(), factor.end(), [&](double f) { return f == factor.front(); })) return;
    double sum = 0;
    for (std::size_t e = 0; e < emitters_.size(); ++e)
        cumulative_[e] = sum += mean_power(e) * factor[pilot_.light_of_emitter[e]];
    for (std::size_t e = 0; e < emitters_.size(); ++e)
        inverse_probability_[e] =
            static_cast<float>(sum / (mean_power(e) * factor[pilot_.light_of_emitter[e]]));
}

double PhotonSource::mean_power(std::size_t emitter) const {
    return mean_component(std::visit([](const auto& e) { return power_of(e); }, emitters_[emitter]));
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
    return emit(sequence_ == EmissionSequence::sobol ? SobolEmission(seed, index).numbers(index)
                                                     : emission_numbers(seed, index));
}

EmittedPhoton PhotonSource::emit(const EmissionNumbers& numbers) const {
    // Two numbers make one of 48 bits: with 24 bits, the faintest of many lights would never be chosen.
    const double choice = (numbers.at[0] + numbers.at[3] * 0x1p-24) * cumulative_.back();
    const auto found = std::upper_bound(cumulative_.begin(), cumulative_.end(), choice);
    const std::size_t chosen = std::min<std::size_t>(found - cumulative_.begin(), emitters_.size() - 1);
    // The remainder of the number chooses the place.
    const double before = chosen == 0 ? 0.0 : cumulative_[chosen - 1];
    const double within = std::clamp((choice - before) / (cumulative_[chosen] - before), 0.0, 1 - 0x1p-30);
    EmittedPhoton photon = emit_from(chosen, numbers, within);
    photon.flux *= inverse_probability_[chosen];
    return photon;
}

EmittedPhoton PhotonSource::emit_from(std::size_t emitter, const EmissionNumbers& numbers,
                                      double within) const {
    return std::visit([&](const auto& e) { return common::emit_from(*scene_, e, numbers, within); },
                      emitters_[emitter]);
}

void PhotonSource::emit(std::uint64_t seed, std::uint64_t first_photon, float surface_offset,
                        PhotonBatch& photons) const {
    // First the random numbers, for a few photons at a time, in a loop that the compiler vectorises.
    std::array<EmissionNumbers, together> numbers;
    for (std::size_t begin = 0; begin < photons.size();) {
        const std::uint64_t first = first_photon + begin;
        const std::size_t count = std::min<std::size_t>(together - first % together, photons.size() - begin);
        if (sequence_ == EmissionSequence::sobol) {
            const SobolEmission sobol(seed, first);
            for (std::size_t i = 0; i < count; ++i) numbers[i] = sobol.numbers(first + i);
        } else {
            for (std::size_t i = 0; i < count; ++i) numbers[i] = numbers_of(seed, first + i);
        }
        for (std::size_t i = 0; i < count; ++i) {
            const EmittedPhoton photon = emit(numbers[i]);
            photons.number[begin + i] = static_cast<std::uint32_t>(begin + i);
            photons.origin.set(begin + i, photon.origin + photon.normal * surface_offset);
            photons.direction.set(begin + i, photon.direction);
            photons.flux.set(begin + i, photon.flux);
        }
        begin += count;
    }
}

}  // namespace common
