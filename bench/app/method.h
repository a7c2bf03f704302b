// The methods by name: what is measured, in one word that stays the same in every table.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "photonmap/gather_settings.h"
#include "shlm/settings.h"

namespace bench {

/// What a finished texel keeps: a file each in shlm/.
enum class LightBasis { L0, L1, L2, L4, H4, H6, YH4, YL2, AD, adaptive };

/// Of the harmonics that hits are summed in for it.
[[nodiscard]] constexpr int summed_order(LightBasis basis) {
    switch (basis) {
        case LightBasis::L0:
            return 0;
        case LightBasis::L1:
        case LightBasis::AD:
            return 1;
        case LightBasis::L4:
            return 4;
        default:
            return 2;
    }
}

/// shlm / BASIS / radiance flux normalised / own bilinear surfaceK knnK [/ uv face] [/ tTEXELS] [/ hHITS] [/ half]
/// shlm / aPERCENT / normalised / own bilinear [/ uv face] [/ tTEXELS], adaptive
struct ShlmMethod {
    LightBasis basis = LightBasis::L2;
    double wanted_error_percent = 0;  ///< of an adaptive map (shlm::AdaptiveMap)
    shlm::ShWeight weight = shlm::ShWeight::radiance;
    shlm::Gather gather = shlm::NearestTexels{};
    std::optional<shlm::TexelPlacement> placement;  ///< none: as --texels says
    std::size_t texels = 0;                         ///< 0: as many as --texels says
    std::uint64_t least_hits = shlm::default_least_hits;
    bool in_halves = false;  ///< the finished map stores halves in place of floats

    /// Whether both sum the same numbers of the same hits, and differ only in what is made of them.
    [[nodiscard]] bool fills_as(const ShlmMethod& other) const {
        return summed_order(basis) == summed_order(other.basis) && weight == other.weight && placement == other.placement &&
               texels == other.texels;
    }
};

enum class PhotonMapEngine {
    flann,             ///< one bulk build of KDTreeSingleIndex: how photon maps are made today
    nanoflann,         ///< the same with the library that people would choose today
    grid,              ///< cells of the gather's radius: for FixedRadius only
    compact,           ///< packed photons under our own tree: the strongest
    flann_incremental  ///< every photon inserted into KDTreeIndex: what the paper measures itself against
};

/// photonmap / flann nanoflann grid compact flann-incremental / kK kFACTORn23 rFRACTION / disc cone
/// epanechnikov
struct PhotonMapMethod {
    PhotonMapEngine engine = PhotonMapEngine::flann;
    photonmap::PhotonSelection selection;
    photonmap::Kernel kernel = photonmap::Kernel::disc;

    /// Whether one store can serve both: a grid is made for its radius.
    [[nodiscard]] bool fills_as(const PhotonMapMethod& other) const {
        return engine == other.engine && (engine != PhotonMapEngine::grid || selection == other.selection);
    }
};

struct Method {
    std::string name;  ///< in full
    std::variant<PhotonMapMethod, ShlmMethod> what;

    [[nodiscard]] const ShlmMethod* light_map() const { return std::get_if<ShlmMethod>(&what); }
    [[nodiscard]] const PhotonMapMethod* photon_map() const { return std::get_if<PhotonMapMethod>(&what); }
};

/// Whether one store can serve both.
[[nodiscard]] bool fill_alike(const Method& a, const Method& b);

/// Reads a name; what is left out at its end takes the default: "shlm" is shlm/L2/radiance/surface4, "photonmap"
/// is photonmap/flann/k50/disc. Throws InputError, naming the option and what may stand in the place that is
/// wrong.
[[nodiscard]] Method parse_method(const std::string& option, const std::string& name);

/// All of them, each once, in the order given.
[[nodiscard]] std::vector<Method> parse_methods(const std::string& option,
                                                const std::vector<std::string>& names);

}  // namespace bench
