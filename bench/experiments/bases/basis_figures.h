// The error of every basis over many environments.
#pragma once

#include <functional>
#include <optional>

#include "bench/experiments/bases/basis.h"

namespace bench::bases {

/// In %, over a set of environments.
struct ErrorFigures {
    double mean = 0, worst = 0;
};

/// One basis in one kind of light.
struct BasisFigures {
    LightKind light;
    Basis basis;
    std::size_t environments = 0;
    ErrorFigures series;       ///< of what the basis says
    ErrorFigures answered;     ///< of what the light map answers
    double at_own_normal = 0;  ///< series / truth where the normal is not bent, mean over the environments
};

/// Goes through `count` environments of the kind (one, where none differ). `go_on` is asked before each;
/// nothing comes back where it says no.
[[nodiscard]] std::optional<std::vector<BasisFigures>> measure_bases(std::span<const Basis> bases,
                                                                     LightKind kind, std::size_t count,
                                                                     std::uint64_t seed,
                                                                     const std::function<bool()>& go_on);

/// The figures that this is held to, derived without any of this code, in %: by quadrature over 60
/// environments drawn at random, which leaves the means of the point lights a standard error of 2.7, 1.1, 0.4
/// and 0.2 for L0, L1, L2 and L4. None for the weights that serve as contrast, and no worst where there is
/// one environment.
struct ExpectedFigures {
    double mean;
    std::optional<double> worst;
};
[[nodiscard]] std::optional<ExpectedFigures> expected_figures(LightKind kind, const std::string& basis);

}  // namespace bench::bases
