#include "bench/app/finished_map.h"

#include "shlm/ambient_and_direction.h"
#include "shlm/hemisphere_six.h"
#include "shlm/luminance_four.h"
#include "shlm/luminance_nine.h"

namespace bench {
namespace {

/// Calls `work` with an object of what the finished texels keep, which is made from what the model sums.
template <class Model, class Work>
auto with_basis(LightBasis basis, Work work) {
    if constexpr (Model::weight == shlm::ShWeight::radiance) {  // the only weight of those that are fitted
        if constexpr (Model::order == 1)
            if (basis == LightBasis::AD) return work(shlm::AmbientAndDirection{});
        if constexpr (Model::order == 2) {
            if (basis == LightBasis::H4) return work(shlm::HemisphereFour{});
            if (basis == LightBasis::H6) return work(shlm::HemisphereSix{});
            if (basis == LightBasis::YH4) return work(shlm::LuminanceFour{});
            if (basis == LightBasis::YL2) return work(shlm::LuminanceNine{});
        }
    }
    return work(shlm::Harmonics<Model::order>{});
}

}  // namespace

shlm::BlockSearch search_blocks(const shlm::Sink<shlm::AdaptiveModel>& sink,
                                const common::TraceReport& trace) {
    return {sink.accumulator().sums(), sink.texels(), trace.watts_per_flux()};
}

shlm::AdaptiveMap adaptive_map(const ShlmMethod& method, const shlm::BlockSearch& search,
                               const shlm::TexelLayout& layout) {
    return {search, layout, method.wanted_error_percent / 100,
            std::holds_alternative<shlm::Bilinear>(method.gather)};
}

template <class Model>
FinishedLightMap finished_map(const ShlmMethod& method, const shlm::Sink<Model>& sink,
                              const common::TraceReport& trace) {
    const float scale = trace.watts_per_flux();
    if constexpr (std::same_as<Model, shlm::AdaptiveModel>)
        if (method.basis == LightBasis::adaptive)
            return FinishedLightMap(adaptive_map(method, search_blocks(sink, trace), sink.texels().layout));
    return with_basis<Model>(method.basis, [&](auto basis) {
        using Basis = decltype(basis);
        if (method.in_halves)
            return FinishedLightMap(
                sink.template finish<Basis, shlm::half>(scale, method.gather, method.least_hits));
        return FinishedLightMap(sink.template finish<Basis>(scale, method.gather, method.least_hits));
    });
}

using enum shlm::ShWeight;
template <int Order, shlm::ShWeight Weight>
using Sums = shlm::Sink<shlm::TexelModel<Order, Weight>>;

// All that with_model has.
template FinishedLightMap finished_map(const ShlmMethod&, const Sums<0, radiance>&,
                                       const common::TraceReport&);
template FinishedLightMap finished_map(const ShlmMethod&, const Sums<0, flux>&, const common::TraceReport&);
template FinishedLightMap finished_map(const ShlmMethod&, const Sums<0, normalised>&,
                                       const common::TraceReport&);
template FinishedLightMap finished_map(const ShlmMethod&, const Sums<1, radiance>&,
                                       const common::TraceReport&);
template FinishedLightMap finished_map(const ShlmMethod&, const Sums<1, flux>&, const common::TraceReport&);
template FinishedLightMap finished_map(const ShlmMethod&, const Sums<1, normalised>&,
                                       const common::TraceReport&);
template FinishedLightMap finished_map(const ShlmMethod&, const Sums<2, radiance>&,
                                       const common::TraceReport&);
template FinishedLightMap finished_map(const ShlmMethod&, const Sums<2, flux>&, const common::TraceReport&);
template FinishedLightMap finished_map(const ShlmMethod&, const Sums<2, normalised>&,
                                       const common::TraceReport&);
template FinishedLightMap finished_map(const ShlmMethod&, const Sums<4, radiance>&,
                                       const common::TraceReport&);
template FinishedLightMap finished_map(const ShlmMethod&, const Sums<4, flux>&, const common::TraceReport&);
template FinishedLightMap finished_map(const ShlmMethod&, const Sums<4, normalised>&,
                                       const common::TraceReport&);

}  // namespace bench
