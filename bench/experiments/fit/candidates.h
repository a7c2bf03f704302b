// The settings that a fit chooses among. The grid of a brute-force search has the same ones.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "bench/contenders/contender.h"

namespace bench::fit {

enum class CandidateKind {
    light_map,      ///< of `value` texels, each of which shows its own hits
    adaptive_map,   ///< whose own estimate of its error is `value` percent
    photon_radius,  ///< all photons within a radius of `value` scene diagonals
    photon_share    ///< the k nearest photons, k being `value` times the number of photons
};

/// A setting without its number of hits. The error has the same form for any number N of hits: blur and
/// truncation do not depend on N, and the variance falls as 1 / N. For this reason texels show their own hits
/// (/h0) and k grows with N. Light maps store half floats: their rounding is far below any measurable error.
/// Adaptive maps are different: their blocks change with N, so their error is known only at the pilot's N.
struct Candidate {
    CandidateKind kind;
    std::string basis;   ///< of a light map, "L2/radiance"; of a photon map its kernel
    std::string gather;  ///< of a light map, "surface4" or "bilinear/face"; of a photon map "r" or "k"
    double value;        ///< its meaning depends on `kind`
    double texels = 0;   ///< of an adaptive map: the number of texels, its smallest blocks

    /// Returns the method's name in the grammar of parse_contender.
    [[nodiscard]] std::string name(std::uint64_t hits) const;
    [[nodiscard]] Contender contender(std::uint64_t hits) const { return parse_contender("fit", name(hits)); }

    /// Names the chain: the candidates that differ in `value` alone. An adaptive map is a chain of its own.
    [[nodiscard]] std::string chain() const;

    /// Returns the width of the blur in a unit of the chain: a texel's side or a radius. 0 for an adaptive
    /// map.
    [[nodiscard]] double width() const;

    [[nodiscard]] bool is_light_map() const { return kind == CandidateKind::light_map || is_adaptive(); }

    /// Whether its blocks change with the hits.
    [[nodiscard]] bool is_adaptive() const { return kind == CandidateKind::adaptive_map; }
};

/// Bounds on k: parse_contender accepts no more, and with fewer the noise would not fall as 1 / k.
inline constexpr double least_nearest = 8, most_nearest = 100'000;

/// Returns k for a share of so many hits, at least 2.
[[nodiscard]] std::uint64_t nearest_count(double share, std::uint64_t hits);

/// The basis with the least truncation, against which the truncation of the others is measured.
[[nodiscard]] const std::string& finest_basis();

/// The basis that lacks only the last band of the finest one: their difference is that band.
[[nodiscard]] const std::string& basis_below_finest();

/// Lists all candidates, each chain from coarse to fine.
[[nodiscard]] std::vector<Candidate> all_candidates();

/// Lists the grid as names of methods, for `study`. Instead of shares it has k in powers of two, each of
/// which is a share of any number of hits.
[[nodiscard]] std::vector<std::string> grid_names();

}  // namespace bench::fit
