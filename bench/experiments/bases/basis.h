// The bases in which a texel may keep its light, and the irradiance they give for tilted normals.
#pragma once

#include <string>

#include "bench/experiments/bases/one_texel.h"
#include "shlm/map/sink.h"

namespace bench::bases {

/// Irradiance per shading normal, W/m^2, of the red channel.
struct BasisAnswers {
    std::vector<double> series;    ///< value of the basis, which may be negative
    std::vector<double> answered;  ///< answer of the light map: the same, clamped at zero
};

/// Returns the quantum for photons that come from no scene, as if the brightest of them carried all the
/// light.
[[nodiscard]] inline shlm::Quantum quantum_for(const common::HitBatch& photons) {
    common::Rgb brightest(0, 0, 0);
    for (const common::Rgb& flux : photons.flux)
        for (int c = 0; c < 3; ++c) brightest[c] = std::max(brightest[c], flux[c]);
    return shlm::Quantum(brightest);
}

/// Fills a light map of one texel with the photons, projects its sums on the basis, and evaluates every
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
    std::string name;       ///< as in names of methods: basis, weight, and half for half floats
    std::string contender;  ///< the method whose answer at one texel this is
    std::size_t numbers;    ///< per texel
    std::size_t bytes;      ///< per texel
    BasisAnswers (*ask)(const OneTexel&, const common::HitBatch&, std::span<const common::Vec3>);
};

/// Returns what a traditional light map keeps, then the bases by increasing size, then order 2 with the other
/// weights. The same ones in half floats follow, without those weights.
[[nodiscard]] std::vector<Basis> all_bases();

}  // namespace bench::bases
