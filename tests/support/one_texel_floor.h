// Hits on a floor of one texel, and the irradiance that models give for them.
#pragma once

#include "shlm/map/sink.h"
#include "tests/support/texels.h"
#include "tests/support/tracing.h"

namespace tests {

/// All instantiated models.
using AllModels = std::tuple<
    shlm::TexelModel<0, shlm::ShWeight::radiance>, shlm::TexelModel<1, shlm::ShWeight::radiance>,
    shlm::TexelModel<2, shlm::ShWeight::radiance>, shlm::TexelModel<4, shlm::ShWeight::radiance>,
    shlm::TexelModel<0, shlm::ShWeight::flux>, shlm::TexelModel<1, shlm::ShWeight::flux>,
    shlm::TexelModel<2, shlm::ShWeight::flux>, shlm::TexelModel<4, shlm::ShWeight::flux>,
    shlm::TexelModel<0, shlm::ShWeight::normalised>, shlm::TexelModel<1, shlm::ShWeight::normalised>,
    shlm::TexelModel<2, shlm::ShWeight::normalised>, shlm::TexelModel<4, shlm::ShWeight::normalised>>;

/// Calls `test` with an object of each model.
template <class Test>
void for_each_model(Test test) {
    std::apply([&](auto... model) { (test(model), ...); }, AllModels{});
}

/// Does the same for the models with one weight.
template <shlm::ShWeight Weight, class Test>
void for_each_order(Test test) {
    for_each_model([&](auto model) {
        if constexpr (decltype(model)::weight == Weight) test(model);
    });
}

/// Makes a floor of one texel at z = 0 with an area of 1.
inline const Scene& floor_scene() {
    static const Scene made = [] {
        Scene scene;
        add(scene, quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), diffuse(Rgb(1, 1, 1)));
        return scene;
    }();
    return made;
}

/// Adds a hit that brings `flux` to the floor from this direction.
inline void add_hit(common::HitBatch& hits, const Vec3& towards_light, const Rgb& flux) {
    hits.push_back({0.5f, 0.5f, 0}, -towards_light, flux, on_quad(0, 0.5f, 0.5f));
}

inline common::HitBatch one_hit(const Vec3& towards_light, const Rgb& flux) {
    common::HitBatch hits;
    add_hit(hits, towards_light, flux);
    return hits;
}

/// A map of hits on the floor, evaluated for different shading normals.
template <class Model>
class Floor {
  public:
    explicit Floor(const common::HitBatch& hits)
        : texels_(texels_of(floor_scene(), 1)), map_(filled(texels_, hits)) {}

    [[nodiscard]] Rgb irradiance(const Vec3& shading_normal) const {
        SurfacePoint point = front_of(floor_scene(), on_quad(0, 0.5f, 0.5f));
        point.shading_normal = shading_normal;
        return map_.irradiance(point);
    }

  private:
    static shlm::HarmonicMap<Model> filled(const shlm::PreparedTexels& texels, const common::HitBatch& hits) {
        shlm::Sink<Model> sink(texels, shlm::OwnTexel{}, quantum_for(hits));
        sink.consume(std::span(&hits, 1));
        return sink.finish(1);
    }

    shlm::PreparedTexels texels_;
    shlm::HarmonicMap<Model> map_;
};

inline const Vec3 up(0, 0, 1);

/// Returns a unit vector `tilt` radians from straight up, rotated by `turn` radians.
inline Vec3 direction(double tilt, double turn = 0) {
    return {static_cast<float>(std::sin(tilt) * std::cos(turn)),
            static_cast<float>(std::sin(tilt) * std::sin(turn)), static_cast<float>(std::cos(tilt))};
}

/// Returns the series of the clamped cosine, truncated after an order, at a cosine of x. It is clamped at
/// zero, too.
inline double kernel(int order, double x) {
    switch (order) {
        case 0:
            return 0.25;
        case 1:
            return std::max(0.0, 0.25 + x / 2);
        case 2:
            return std::max(0.0, (3 + 16 * x + 15 * x * x) / 32);
        default:
            return std::max(
                0.0, (3 + 16 * x + 15 * x * x) / 32 - 3.0 / 32 * (35 * std::pow(x, 4) - 30 * x * x + 3) / 8);
    }
}

}  // namespace tests
