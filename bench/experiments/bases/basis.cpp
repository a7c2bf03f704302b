#include "bench/experiments/bases/basis.h"

#include "shlm/basis/ambient_and_direction.h"
#include "shlm/basis/hemisphere_four.h"
#include "shlm/basis/luminance_nine.h"

namespace bench {
namespace {

using enum shlm::ShWeight;

template <class Kept, shlm::ShWeight Weight = radiance, class Number = float>
Basis basis(const std::string& name) {
    using Model = shlm::TexelModel<Kept::order, Weight>;
    constexpr std::size_t numbers = shlm::number_count<Kept>;
    return {name, numbers, numbers * sizeof(Number), &ask<Model, Kept, Number>};
}

template <class Number>
std::vector<Basis> ladder(const std::string& suffix) {
    return {basis<shlm::Harmonics<0>, normalised, Number>("L0/normalised" + suffix),
            basis<shlm::AmbientAndDirection, radiance, Number>("AD/radiance" + suffix),
            basis<shlm::LuminanceNine, radiance, Number>("YL2/radiance" + suffix),
            basis<shlm::Harmonics<1>, radiance, Number>("L1/radiance" + suffix),
            basis<shlm::HemisphereFour, radiance, Number>("H4/radiance" + suffix),
            basis<shlm::Harmonics<2>, radiance, Number>("L2/radiance" + suffix),
            basis<shlm::Harmonics<4>, radiance, Number>("L4/radiance" + suffix)};
}

}  // namespace

std::vector<Basis> all_bases() {
    std::vector<Basis> bases = ladder<float>("");
    bases.push_back(basis<shlm::Harmonics<2>, normalised>("L2/normalised"));
    bases.push_back(basis<shlm::Harmonics<2>, flux>("L2/flux"));
    for (Basis& in_halves : ladder<shlm::half>("/half")) bases.push_back(std::move(in_halves));
    return bases;
}

}  // namespace bench
