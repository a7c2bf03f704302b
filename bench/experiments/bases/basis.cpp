#include "bench/experiments/bases/basis.h"

#include "shlm/basis/ambient_and_direction.h"
#include "shlm/basis/hemisphere_fit.h"
#include "shlm/basis/luminance_fit.h"

namespace bench::bases {
namespace {

using enum shlm::ShWeight;

template <class Kept, shlm::ShWeight Weight = radiance, class Number = float>
Basis basis(const std::string& name) {
    using Model = shlm::TexelModel<Kept::order, Weight>;
    constexpr std::size_t numbers = shlm::number_count<Kept>;
    const std::string half = std::is_same_v<Number, float> ? "" : "/half";
    return {name + half, "shlm/" + name + "/own" + half, numbers, numbers * sizeof(Number),
            &ask<Model, Kept, Number>};
}

template <class Number>
std::vector<Basis> ladder() {
    return {basis<shlm::Harmonics<0>, normalised, Number>("L0/normalised"),
            basis<shlm::HemisphereFit<0>, flux, Number>("F0/flux"),
            basis<shlm::AmbientAndDirection, radiance, Number>("AD/radiance"),
            basis<shlm::LuminanceFit<1>, radiance, Number>("YF1/radiance"),
            basis<shlm::LuminanceFit<2>, radiance, Number>("YF2/radiance"),
            basis<shlm::HemisphereFit<1>, radiance, Number>("F1/radiance"),
            basis<shlm::Harmonics<2>, radiance, Number>("L2/radiance"),
            basis<shlm::HemisphereFit<2>, radiance, Number>("F2/radiance"),
            basis<shlm::Harmonics<4>, radiance, Number>("L4/radiance")};
}

}  // namespace

std::vector<Basis> all_bases() {
    std::vector<Basis> bases = ladder<float>();
    bases.push_back(basis<shlm::Harmonics<2>, normalised>("L2/normalised"));
    bases.push_back(basis<shlm::Harmonics<2>, flux>("L2/flux"));
    for (Basis& in_halves : ladder<shlm::half>()) bases.push_back(std::move(in_halves));
    return bases;
}

}  // namespace bench::bases
