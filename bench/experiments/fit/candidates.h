// The settings that a fit chooses among, and the grid of a search by brute force: one list for both.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "bench/contenders/contender.h"

namespace bench::fit {

enum class CandidateKind {
    light_map,      ///< with so many texels, each of which shows its own hits
    adaptive_map,   ///< with an error of so many percent as it estimates it itself
    photon_radius,  ///< all photons within so many scene diagonals
    photon_share    ///< the k nearest, k being so large a share of all photons
};

/// A setting but for the number of hits. Its error has the same form for any number N of hits: blur and
/// truncation do not depend on N, the variance falls as 1 / N. That is why texels show their own hits (/h0)
/// and k grows with N. Light maps store halves: their rounding is far below any error that can be measured.
/// Adaptive maps are of another kind: their blocks change with N, and nothing is known of their error but at
/// the N of the pilot.
struct Candidate {
    CandidateKind kind;
    std::string basis;   ///< of a light map, "L2/radiance"; of a photon map its kernel
    std::string gather;  ///< of a light map, "surface4" or "bilinear/face"; of a photon map "r" or "k"
    double value;        ///< as the kind says
    double texels = 0;   ///< of an adaptive map: its smallest blocks

    /// As parse_contender reads it.
    [[nodiscard]] std::string name(std::uint64_t hits) const;
    [[nodiscard]] Contender contender(std::uint64_t hits) const { return parse_contender("fit", name(hits)); }

    /// What all candidates have in common with which it differs in `value` alone; an adaptive map is alone in
    /// its.
    [[nodiscard]] std::string chain() const;

    /// Of the blur, in a unit of the chain's own: a texel's side, a radius. 0 of an adaptive map.
    [[nodiscard]] double width() const;

    [[nodiscard]] bool is_light_map() const { return kind == CandidateKind::light_map || is_adaptive(); }

    /// Whether its blocks change with the hits.
    [[nodiscard]] bool is_adaptive() const { return kind == CandidateKind::adaptive_map; }
};

/// The k nearest are as many as parse_contender takes, and enough for their noise to be 1 / k.
inline constexpr double least_nearest = 8, most_nearest = 100'000;

/// k of a share at so many hits, at least 2.
[[nodiscard]] std::uint64_t nearest_count(double share, std::uint64_t hits);

/// The basis by which the truncation of the others is measured: the one that loses least.
[[nodiscard]] const std::string& finest_basis();

/// Bases whose difference is the last band of the harmonics.
[[nodiscard]] const std::string& basis_below_finest();

/// Each chain from coarse to fine.
[[nodiscard]] std::vector<Candidate> all_candidates();

/// The grid as names of methods, for `study`: of shares, k in powers of two, which are shares of any number
/// of hits.
[[nodiscard]] std::vector<std::string> grid_names();

}  // namespace bench::fit
