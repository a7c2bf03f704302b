#include "common/reference/path.h"

#include <numbers>

#include "common/reference/direction_choice.h"
#include "common/reference/light_sample.h"
#include "common/reference/specular.h"
#include "common/reference/straight_line.h"
#include "common/scene/coverage.h"

namespace common::reference {
namespace {

using Imath::V3d;
using std::numbers::pi;

/// Surfaces on a path before Russian roulette may end it.
constexpr int sure_surfaces = 4;

V3d doubles(const Rgb& c) {
    return {static_cast<double>(c.x), static_cast<double>(c.y), static_cast<double>(c.z)};
}

double largest(const V3d& v) {
    return std::max({v.x, v.y, v.z});
}

/// A direction chosen at a diffuse surface, and what the weight of a light that it hits depends on.
struct ChosenDirection {
    Vec3 origin;
    Vec3 towards;    ///< unit
    double density;  ///< per solid angle
};

class Path {
  public:
    Path(const RayScene& rays, const Lights& lights, RandomStream& stream, int most_surfaces, LightPart part)
        : rays_(rays),
          scene_(rays.scene()),
          lights_(lights),
          stream_(stream),
          part_(part),
          most_surfaces_(most_surfaces) {}

    V3d irradiance(const SurfacePoint& point, const FirstNumbers& first) {
        Receiver receiver{rays_.off_surface(point.position, point.geometric_normal), point.shading_normal,
                          point.geometric_normal};
        FirstNumbers numbers = first;
        while (true) {
            const LightChoice choice(lights_, receiver);
            const DirectionChoice directions(lights_.specular(), receiver);
            if (is_wanted()) add_light(receiver, choice, directions, numbers);
            const Vec3 towards = directions.choose(numbers.direction);
            const double cosine = incident_cosine(receiver, V3d(towards));
            if (cosine <= 0) break;
            const ChosenDirection chosen{receiver.origin, towards, directions.density(towards)};
            throughput_ *= cosine / pi / chosen.density;
            const std::optional<Receiver> next = follow(chosen, choice);
            if (!next) break;
            is_direct_ = false;
            if (part_ == LightPart::direct) break;
            receiver = *next;
            numbers = {{stream_.next(), stream_.next()}, {stream_.next(), stream_.next()}, stream_.next()};
        }
        return sum_;
    }

  private:
    /// Next event estimation.
    void add_light(const Receiver& receiver, const LightChoice& choice, const DirectionChoice& directions,
                   const FirstNumbers& numbers) {
        const std::int32_t chosen = choice.choose(numbers.which_light);
        if (chosen < 0) return;
        const auto sample = sample_light(rays_, lights_.light()[chosen], receiver, numbers.on_light);
        if (!sample) return;
        const V3d arriving = part_arriving(receiver, *sample);
        if (!(largest(arriving) > 0)) return;
        const double probability = choice.probability(chosen);
        double weight = 1;
        if (sample->density > 0) {
            const double by_light = probability * sample->density;
            const double by_direction = directions.density(sample->towards.normalized());
            weight = by_light / (by_light + by_direction);
        }
        add(doubles(sample->irradiance) * arriving * (weight / probability));
    }

    /// Returns the fraction of the sample's light that occluders transmit.
    V3d part_arriving(const Receiver& receiver, const LightSample& sample) const {
        if (lights_.see_through())
            return part_that_arrives(rays_, receiver.origin, sample.towards, sample.reach);
        return rays_.occluded(receiver.origin, sample.towards, sample.reach) ? V3d(0, 0, 0) : V3d(1, 1, 1);
    }

    /// Follows `chosen` through holes, mirrors and glass to the next diffuse surface, and adds the emission
    /// on the way.
    std::optional<Receiver> follow(const ChosenDirection& chosen, const LightChoice& choice) {
        Vec3 origin = chosen.origin, towards = chosen.towards;
        bool straight = true;  // whether next event estimation finds the same path
        while (true) {
            const std::optional<SurfaceId> surface = rays_.nearest(origin, towards);
            if (!surface) {
                if (scene_.sky && is_wanted()) add(doubles(scene_.sky->radiance) * pi);
                return std::nullopt;
            }
            const Vec3 position = position_at(scene_, *surface);
            const Vec3& front = scene_.geometric_normal[surface->triangle];
            const Vec3 normal = towards.dot(front) < 0 ? front : -front;
            if (is_hole(*surface)) {
                if (++surfaces_ > most_surfaces_) return std::nullopt;
                origin = rays_.off_surface(position, -normal);
                continue;
            }
            const double weight = straight ? weight_of_meeting(*surface, position, chosen, choice) : 1;
            if (is_wanted()) add(emitted(*surface, towards) * (pi * weight));
            if (++surfaces_ > most_surfaces_) return std::nullopt;

            throughput_ *= doubles(base_color_at(scene_, *surface));
            if (scene_.material_of(surface->triangle).kind == SurfaceKind::diffuse) {
                if (!survives()) return std::nullopt;
                return Receiver{rays_.off_surface(position, normal), normal, normal};
            }
            const auto arrival = specular_arrival(scene_, *surface, -towards, stream_.next());
            if (!arrival) return std::nullopt;
            throughput_ *= arrival->factor;
            index_sq_ *= arrival->index_ratio_sq;
            if (!survives()) return std::nullopt;
            origin = rays_.off_surface(position, arrival->geometric_normal);
            towards = arrival->towards;
            straight = straight && arrival->straight;
            is_direct_ = is_direct_ && straight;
            if (part_ == LightPart::direct && !is_direct_) return std::nullopt;
        }
    }

    /// Decides at random where coverage is partial.
    bool is_hole(const SurfaceId& surface) {
        const auto coverage = static_cast<double>(coverage_at(scene_, surface));
        return coverage < 1 && stream_.next() >= coverage;
    }

    /// Returns the weight of what `chosen` hits; next event estimation, which finds it as well, has the rest.
    double weight_of_meeting(const SurfaceId& surface, const Vec3& position, const ChosenDirection& chosen,
                             const LightChoice& choice) const {
        const std::int32_t light = lights_.of_triangle(surface.triangle);
        if (light < 0) return 1;
        const auto& area = std::get<AreaLight>(lights_.light()[light]);
        const double by_light =
            choice.probability(light) * density_of(area, surface, position - chosen.origin);
        return chosen.density / (chosen.density + by_light);
    }

    /// Returns the radiance that the surface emits against the direction `towards`.
    V3d emitted(const SurfaceId& surface, const Vec3& towards) const {
        const Material& material = scene_.material_of(surface.triangle);
        const bool front = towards.dot(scene_.geometric_normal[surface.triangle]) < 0;
        if (!material.emits() || !(front || material.double_sided)) return V3d(0, 0, 0);
        return doubles(emitted_radiance_at(scene_, surface));
    }

    /// Russian roulette on the throughput. It ignores the squared index of a medium, which cancels when the
    /// path leaves the medium.
    bool survives() {
        const double carried = largest(throughput_) / index_sq_;
        if (!(carried > 0)) return false;
        if (surfaces_ <= sure_surfaces || carried >= 1) return true;
        if (stream_.next() >= carried) return false;
        throughput_ /= carried;
        return true;
    }

    /// Whether light that the path meets now is of the part.
    [[nodiscard]] bool is_wanted() const {
        return part_ == LightPart::all || (part_ == LightPart::direct) == is_direct_;
    }

    void add(const V3d& irradiance) { sum_ += throughput_ * irradiance; }

    const RayScene& rays_;
    const Scene& scene_;
    const Lights& lights_;
    RandomStream& stream_;
    V3d sum_{0, 0, 0};
    V3d throughput_{1, 1, 1};  ///< irradiance at the visible point per irradiance at the end of the path
    double index_sq_ = 1;      ///< the factor of `throughput_` that is due to squared indices
    LightPart part_;
    bool is_direct_ = true;  ///< no diffuse surface, mirror or glass so far
    int most_surfaces_;
    int surfaces_ = 1;
};

}  // namespace

V3d sample_irradiance(const RayScene& rays, const Lights& lights, const SurfacePoint& point,
                      const FirstNumbers& first, RandomStream& stream, int most_surfaces, LightPart part) {
    return Path(rays, lights, stream, most_surfaces, part).irradiance(point, first);
}

}  // namespace common::reference
