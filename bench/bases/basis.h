// What a texel may keep of its light, and what it then says of tilted normals.
#pragma once

#include <string>

#include "bench/bases/one_texel.h"
#include "shlm/sink.h"

namespace bench {

/// Irradiance by shading normal, W/m^2.
struct BasisAnswers {
    std::vector<double> series;    ///< what the basis says, which may be below zero
    std::vector<double> answered;  ///< what the light map answers: that, cut off at zero
};

/// For photons that come from no scene: as if their brightest had all the light.
[[nodiscard]] inline shlm::Quantum quantum_for(const common::HitBatch& photons) {
    common::Rgb brightest(0, 0, 0);
    for (const common::Rgb& flux : photons.flux)
        for (int c = 0; c < 3; ++c) brightest[c] = std::max(brightest[c], flux[c]);
    return shlm::Quantum(brightest);
}

/// Fills a light map of one texel with the photons and asks it for every normal.
template <class Model>
[[nodiscard]] BasisAnswers ask(const OneTexel& texel, const common::HitBatch& photons,
                               std::span<const common::Vec3> normals) {
    shlm::Sink<Model> sink(texel.prepared(), shlm::OwnTexel{}, quantum_for(photons));
    sink.consume(std::span(&photons, 1));
    const shlm::LightMap<Model> map = sink.finish(1);
    BasisAnswers answers;
    for (const common::Vec3& normal : normals) {
        const common::SurfacePoint point = texel.point_with(normal);
        shlm::TexelMean<Model> mean(point.shading_normal);
        mean.add(map.texels().front().light, 1);
        answers.series.push_back(mean.series().x);
        answers.answered.push_back(map.irradiance(point).x);
    }
    return answers;
}

struct Basis {
    std::string name;     ///< order and weight, as in the names of the methods
    std::size_t numbers;  ///< per channel and texel
    BasisAnswers (*ask)(const OneTexel&, const common::HitBatch&, std::span<const common::Vec3>);

    /// One texel as it would be stored: floats, three channels.
    [[nodiscard]] std::size_t bytes() const { return numbers * 3 * sizeof(float); }
};

/// What a traditional light map keeps, then orders 1, 2 and 4, then order 2 with the other weights.
[[nodiscard]] std::vector<Basis> all_bases();

}  // namespace bench
