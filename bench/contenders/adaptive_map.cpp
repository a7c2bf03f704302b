#include "bench/contenders/adaptive_map.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "bench/contenders/light_map_names.h"
#include "bench/contenders/light_map_store.h"
#include "common/core/stopwatch.h"
#include "shlm/adaptive/block_costs.h"

namespace bench {
namespace {

constexpr const char* summed_basis = "L2";  // shlm::AdaptiveModel
using Sums = SumsStore<shlm::AdaptiveModel>;

/// Peak bytes per texel while the map is made: a pyramid of blocks, each with its costs and the decision on
/// it.
constexpr double pyramid_bytes =
    4.0 / 3 * (sizeof(shlm::LightBlock) + sizeof(shlm::BlockCosts) + 3 * sizeof(double));

/// The search from which adaptive maps of any error are made.
struct Search {
    shlm::BlockSearch blocks;
    double seconds;
};

const Search& search_of(LightMapStore& store, const common::TraceReport& trace) {
    std::any& shared = store.shared();
    if (!shared.has_value()) {
        const common::Stopwatch searching;
        const auto& sink = static_cast<const Sums&>(store).sink();
        auto search = std::make_shared<Search>(
            Search{{sink.accumulator().sums(), sink.texels(), trace.watts_per_flux()}, 0});
        search->seconds = searching.seconds();
        shared = std::shared_ptr<const Search>(std::move(search));
    }
    return *std::any_cast<const std::shared_ptr<const Search>&>(shared);
}

std::shared_ptr<const Technique> parse(NameParts& parts) {
    const auto percent = number_between("a", parts.peek(), "");
    if (!percent || *percent <= 0) return nullptr;
    (void)parts.take("");
    TexelSetting setting{&basis_named(summed_basis), shlm::ShWeight::normalised, shlm::Bilinear{}, {}, 0};
    if (const std::string weight = parts.take("normalised"); weight != "normalised")
        parts.complain(weight, "normalised, the only weight of an adaptive map");
    const std::string gather = parts.take("bilinear");
    if (gather == "own")
        setting.gather = shlm::OwnTexel{};
    else if (gather != "bilinear")
        parts.complain(gather, "bilinear or own: an adaptive map has no index of its texels");
    take_texels(parts, setting);
    if (!parts.at_end())
        parts.complain(parts.peek(), "uv, face, or a number of texels such as t65536, in this order");
    return std::make_shared<AdaptiveLightMap>(setting, *percent);
}

const RegisteredLightMapKind registered({"aPERCENT, an adaptive map of that error as it estimates it itself",
                                         "shlm/a5", parse});

}  // namespace

shlm::AdaptiveMap AdaptiveLightMap::map_of(Store& store, const common::TraceReport& trace) const {
    auto& sums = static_cast<Sums&>(store);
    return {search_of(sums, trace).blocks, sums.sink().texels().layout, wanted_error_percent_ / 100,
            std::holds_alternative<shlm::Bilinear>(setting().gather)};
}

std::string AdaptiveLightMap::name() const {
    return fmt::format("shlm/a{}/normalised/{}", wanted_error_percent_, texel_name());
}

nlohmann::ordered_json AdaptiveLightMap::fields() const {
    nlohmann::ordered_json fields = {
        {"family", "shlm"}, {"basis", "adaptive"}, {"wanted_error_percent", wanted_error_percent_}};
    fields.update(texel_fields());
    return fields;
}

double AdaptiveLightMap::needed_bytes(const ContenderSettings& settings, std::uint64_t) const {
    const double filled =
        static_cast<double>(setting().basis->sum_bytes(setting().weight)) + sizeof(shlm::TexelGeometry);
    return static_cast<double>(texel_choice(settings).count) * (filled + pyramid_bytes);
}

FinishedMap AdaptiveLightMap::finish(Store& store, const common::TraceReport& trace) const {
    const double shared_seconds = search_of(static_cast<LightMapStore&>(store), trace).seconds;
    const common::Stopwatch build;
    auto answers = answers_of(map_of(store, trace));
    return {std::move(answers), shared_seconds + build.seconds()};
}

}  // namespace bench
