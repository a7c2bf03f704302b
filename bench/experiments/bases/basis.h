// What a texel may keep of its light, and what it then says of tilted normals.
#pragma once

#include <string>

#include "bench/experiments/bases/one_texel.h"
#include "shlm/map/sink.h"

namespace bench::bases {

/// Irradiance by shading normal, W/m^2, of the red channel.
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

/// Fills a light map of one texel with the photons, keeps of it what the basis keeps, and asks that for every
/// normal.
template <class Model, shlm::Basis Kept = shlm::Harmonics<Model::order>, class Number = float>
[[nodiscard]] BasisAnswers ask(const OneTexel& texel, const common::HitBatch& photons,
                               std::span<const common::Vec3> normals) {
    const shlm::OwnTexel own;
    shlm::Sink<Model> sink(texel.prepared(), own, quantum_for(photons));
    sink.consume(std::span(&photons, 1));
    const auto map = sink.template finish<Kept, Number>(1, own, 0);
    BasisAnswers answers;
    for (const common::Vec3& normal : normals) {
        answers.series.push_back(map.texels().front().irradiance(normal).x * map.unit());
        answers.answered.push_back(map.irradiance(texel.point_with(normal)).x);
    }
    return answers;
}

struct Basis {
    std::string name;  ///< as in the names of the methods: basis, weight, and half where it stores halves
    std::string contender;  ///< the method with one texel's answer
    std::size_t numbers;    ///< per texel
    std::size_t bytes;      ///< per texel
    BasisAnswers (*ask)(const OneTexel&, const common::HitBatch&, std::span<const common::Vec3>);
};

/// What a traditional light map keeps, then the ladder of bases upwards, then order 2 with the other weights;
/// behind them the same but for those weights in halves.
[[nodiscard]] std::vector<Basis> all_bases();

}  // namespace bench::bases
