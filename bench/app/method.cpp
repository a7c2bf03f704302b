#include "bench/app/method.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "bench/app/texel_options.h"
#include "common/core/input_error.h"

namespace bench {
namespace {

constexpr std::size_t most_neighbours = 100'000;
constexpr std::size_t most_texels = 1'000'000'000;
constexpr std::size_t most_hits = 1'000'000;

/// The parts of a name, taken one by one; each complaint says what was expected in its place.
class NameParts {
  public:
    NameParts(std::string option, const std::string& name) : option_(std::move(option)), name_(name) {
        for (std::size_t begin = 0; begin <= name.size();) {
            const std::size_t end = std::min(name.find('/', begin), name.size());
            parts_.push_back(name.substr(begin, end - begin));
            begin = end + 1;
        }
    }

    /// The next part without taking it; empty at the end of the name.
    [[nodiscard]] std::string peek() const { return next_ < parts_.size() ? parts_[next_] : ""; }

    /// The next part, or `otherwise` at the end of the name.
    std::string take(const std::string& otherwise) {
        return next_ < parts_.size() ? parts_[next_++] : otherwise;
    }

    [[nodiscard]] bool at_end() const { return next_ == parts_.size(); }

    [[noreturn]] void complain(const std::string& part, const std::string& expected) const {
        throw common::InputError(
            fmt::format("{}: '{}' in the method '{}' is not {}", option_, part, name_, expected));
    }

    /// The value of the next part, which is one of the given names; the first is the default.
    template <class Value, std::size_t N>
    Value take_one_of(const std::array<std::pair<const char*, Value>, N>& choices) {
        const std::string part = take(choices.front().first);
        std::vector<std::string> names;
        for (const auto& [name, value] : choices) {
            if (part == name) return value;
            names.emplace_back(name);
        }
        complain(part, fmt::format("one of {}", fmt::join(names, ", ")));
    }

  private:
    std::string option_, name_;
    std::vector<std::string> parts_;
    std::size_t next_ = 0;
};

/// The number in `text` between a prefix and a suffix, where that is all there is.
std::optional<double> number_between(std::string_view prefix, std::string_view text,
                                     std::string_view suffix) {
    if (!text.starts_with(prefix) || !text.ends_with(suffix) || text.size() <= prefix.size() + suffix.size())
        return std::nullopt;
    const char* const end = text.data() + text.size() - suffix.size();
    double value = 0;
    const auto [stop, error] = std::from_chars(text.data() + prefix.size(), end, value);
    if (error != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
    return value;
}

/// The same for a whole number within bounds.
std::optional<std::size_t> count_between(std::string_view prefix, std::string_view text, std::size_t least,
                                         std::size_t most) {
    const auto value = number_between(prefix, text, "");
    if (!value || *value < static_cast<double>(least) || *value > static_cast<double>(most) ||
        *value != std::floor(*value))
        return std::nullopt;
    return static_cast<std::size_t>(*value);
}

constexpr std::array<std::pair<const char*, LightBasis>, 9> bases = {{{"L2", LightBasis::L2},
                                                                      {"L0", LightBasis::L0},
                                                                      {"L1", LightBasis::L1},
                                                                      {"L4", LightBasis::L4},
                                                                      {"H4", LightBasis::H4},
                                                                      {"H6", LightBasis::H6},
                                                                      {"YH4", LightBasis::YH4},
                                                                      {"YL2", LightBasis::YL2},
                                                                      {"AD", LightBasis::AD}}};
constexpr std::array<std::pair<const char*, shlm::ShWeight>, 3> weights = {
    {{"radiance", shlm::ShWeight::radiance},
     {"flux", shlm::ShWeight::flux},
     {"normalised", shlm::ShWeight::normalised}}};
constexpr std::array<std::pair<const char*, PhotonMapEngine>, 5> engines = {
    {{"flann", PhotonMapEngine::flann},
     {"nanoflann", PhotonMapEngine::nanoflann},
     {"grid", PhotonMapEngine::grid},
     {"compact", PhotonMapEngine::compact},
     {"flann-incremental", PhotonMapEngine::flann_incremental}}};
constexpr std::array<std::pair<const char*, photonmap::Kernel>, 3> kernels = {
    {{"disc", photonmap::Kernel::disc},
     {"cone", photonmap::Kernel::cone},
     {"epanechnikov", photonmap::Kernel::epanechnikov}}};

template <class Value, std::size_t N>
const char* name_of(const std::array<std::pair<const char*, Value>, N>& choices, Value value) {
    return std::find_if(choices.begin(), choices.end(), [&](const auto& c) { return c.second == value; })
        ->first;
}

// --- light maps

shlm::Gather take_gather(NameParts& parts) {
    const std::string part = parts.take("surface4");
    if (part == "own") return shlm::OwnTexel{};
    if (part == "bilinear") return shlm::Bilinear{};
    for (const auto& [prefix, of_own_surface] : {std::pair("surface", true), std::pair("knn", false)})
        if (const auto count = count_between(prefix, part, 1, most_neighbours))
            return shlm::NearestTexels{*count, of_own_surface};
    parts.complain(part,
                   fmt::format("own, bilinear, surfaceK or knnK with K from 1 to {}", most_neighbours));
}

/// What may follow a light map's gather: uv or face, then tTEXELS.
void take_texels(NameParts& parts, ShlmMethod& method) {
    if (const std::string part = parts.peek(); part == "uv" || part == "face") {
        method.placement = part == "uv" ? shlm::TexelPlacement::uv : shlm::TexelPlacement::face;
        (void)parts.take("");
    }
    if (const auto texels = count_between("t", parts.peek(), 1, most_texels)) {
        method.texels = *texels;
        (void)parts.take("");
    }
}

/// What may follow that: hHITS, then half.
void take_finish(NameParts& parts, ShlmMethod& method) {
    if (const auto hits = count_between("h", parts.peek(), 0, most_hits)) {
        method.least_hits = *hits;
        (void)parts.take("");
    }
    if (parts.peek() == "half") {
        method.in_halves = true;
        (void)parts.take("");
    }
    if (!parts.at_end())
        parts.complain(parts.peek(),
                       "uv, face, a number of texels such as t65536, of hits to a block such as "
                       "h0, or half, in this order");
}

bool is_harmonics(LightBasis basis) {
    return basis == LightBasis::L0 || basis == LightBasis::L1 || basis == LightBasis::L2 ||
           basis == LightBasis::L4;
}

shlm::ShWeight take_weight(NameParts& parts, LightBasis basis) {
    const shlm::ShWeight weight = parts.take_one_of(weights);
    if (weight != shlm::ShWeight::radiance && !is_harmonics(basis))
        parts.complain(name_of(weights, weight),
                       fmt::format("radiance, the only weight that {} has", name_of(bases, basis)));
    return weight;
}

std::string name_of(const shlm::Gather& gather) {
    if (const auto* nearest = std::get_if<shlm::NearestTexels>(&gather))
        return fmt::format("{}{}", nearest->of_own_surface ? "surface" : "knn", nearest->count);
    return std::holds_alternative<shlm::Bilinear>(gather) ? "bilinear" : "own";
}

std::string name_of(const ShlmMethod& method) {
    const std::string basis = method.basis == LightBasis::adaptive
                                  ? fmt::format("a{}", method.wanted_error_percent)
                                  : name_of(bases, method.basis);
    std::string name =
        fmt::format("shlm/{}/{}/{}", basis, name_of(weights, method.weight), name_of(method.gather));
    if (method.placement) name += fmt::format("/{}", bench::name_of(*method.placement));
    if (method.texels > 0) name += fmt::format("/t{}", method.texels);
    if (method.least_hits != shlm::default_least_hits) name += fmt::format("/h{}", method.least_hits);
    if (method.in_halves) name += "/half";
    return name;
}

ShlmMethod take_adaptive(NameParts& parts, double wanted_error_percent) {
    ShlmMethod method;
    method.basis = LightBasis::adaptive;
    method.wanted_error_percent = wanted_error_percent;
    method.weight = shlm::ShWeight::normalised;
    method.gather = shlm::Bilinear{};
    (void)parts.take("");
    if (const std::string weight = parts.take("normalised"); weight != "normalised")
        parts.complain(weight, "normalised, the only weight of an adaptive map");
    const std::string gather = parts.take("bilinear");
    if (gather == "own")
        method.gather = shlm::OwnTexel{};
    else if (gather != "bilinear")
        parts.complain(gather, "bilinear or own: an adaptive map has no index of its texels");
    take_texels(parts, method);
    if (!parts.at_end())
        parts.complain(parts.peek(), "uv, face, or a number of texels such as t65536, in this order");
    return method;
}

ShlmMethod take_shlm(NameParts& parts) {
    ShlmMethod method;
    if (const auto percent = number_between("a", parts.peek(), ""); percent && *percent > 0)
        return take_adaptive(parts, *percent);
    method.basis = parts.take_one_of(bases);
    method.weight = take_weight(parts, method.basis);
    method.gather = take_gather(parts);
    take_texels(parts, method);
    take_finish(parts, method);
    return method;
}

// --- photon maps

std::optional<photonmap::FixedRadius> fixed_radius(const std::string& part) {
    const auto fraction = number_between("r", part, "");
    if (!fraction || *fraction < 1e-6 || *fraction > 1) return std::nullopt;
    return photonmap::FixedRadius{*fraction};
}

/// A grid finds what lies within the radius that its cells were made for, and knows no k nearest.
photonmap::PhotonSelection take_radius(NameParts& parts) {
    const std::string part = parts.take("r0.003");
    if (const auto radius = fixed_radius(part)) return *radius;
    parts.complain(part, "a radius rF of F scene diagonals, from 1e-6 to 1: a grid knows no other selection");
}

photonmap::PhotonSelection take_selection(NameParts& parts) {
    const std::string part = parts.take("k50");
    if (const auto count = count_between("k", part, 2, most_neighbours))
        return photonmap::NearestPhotons{*count};
    if (const auto factor = number_between("k", part, "n23"); factor && *factor > 0 && *factor <= 1)
        return photonmap::GrowingNumber{*factor};
    if (const auto radius = fixed_radius(part)) return *radius;
    parts.complain(
        part,
        fmt::format("kK with K from 2 to {} (one photon has no density), kCn23 for k = C N^(2/3), or rF for "
                    "a radius of F scene diagonals, from 1e-6 to 1",
                    most_neighbours));
}

std::string name_of(const photonmap::PhotonSelection& selection) {
    if (const auto* nearest = std::get_if<photonmap::NearestPhotons>(&selection))
        return fmt::format("k{}", nearest->count);
    if (const auto* growing = std::get_if<photonmap::GrowingNumber>(&selection))
        return fmt::format("k{}n23", growing->factor);
    return fmt::format("r{}", std::get<photonmap::FixedRadius>(selection).diagonal_fraction);
}

std::string name_of(const PhotonMapMethod& method) {
    return fmt::format("photonmap/{}/{}/{}", name_of(engines, method.engine), name_of(method.selection),
                       name_of(kernels, method.kernel));
}

PhotonMapMethod take_photon_map(NameParts& parts) {
    PhotonMapMethod method;
    method.engine = parts.take_one_of(engines);
    method.selection = method.engine == PhotonMapEngine::grid ? take_radius(parts) : take_selection(parts);
    method.kernel = parts.take_one_of(kernels);
    return method;
}

}  // namespace

bool fill_alike(const Method& a, const Method& b) {
    if (a.light_map() && b.light_map()) return a.light_map()->fills_as(*b.light_map());
    if (a.photon_map() && b.photon_map()) return a.photon_map()->fills_as(*b.photon_map());
    return false;
}

Method parse_method(const std::string& option, const std::string& name) {
    NameParts parts(option, name);
    Method method;
    if (const std::string family = parts.take(""); family == "shlm")
        method.what = take_shlm(parts);
    else if (family == "photonmap")
        method.what = take_photon_map(parts);
    else
        parts.complain(family, "shlm or photonmap");
    if (!parts.at_end()) parts.complain(parts.take(""), "expected after a whole name");
    method.name = std::visit([](const auto& what) { return name_of(what); }, method.what);
    return method;
}

std::vector<Method> parse_methods(const std::string& option, const std::vector<std::string>& names) {
    std::vector<Method> methods;
    for (const std::string& name : names) {
        Method method = parse_method(option, name);
        const auto same = [&](const Method& m) { return m.name == method.name; };
        if (std::none_of(methods.begin(), methods.end(), same)) methods.push_back(std::move(method));
    }
    return methods;
}

}  // namespace bench
