#include "bench/contenders/direct_light.h"

#include <bit>
#include <nlohmann/json.hpp>

#include "common/core/fnv.h"
#include "common/core/input_error.h"
#include "common/reference/path.h"

namespace bench {
namespace {

using common::Rgb;
using common::SurfacePoint;

/// Keeps the random numbers of direct light apart from those of a reference with the same seed.
constexpr std::uint64_t own_numbers = 0x9e3779b97f4a7c15u;

/// Identifies a point, whichever other points are asked.
std::uint32_t number_of(const SurfacePoint& point) {
    std::uint64_t hash = common::fnv_start;
    for (int i = 0; i < 3; ++i)
        hash = common::fnv_step(hash, std::bit_cast<std::uint32_t>(point.position[i]));
    return static_cast<std::uint32_t>(hash ^ (hash >> 32));
}

class WithDirectLight final : public Answers {
  public:
    WithDirectLight(std::unique_ptr<const Answers> indirect, PreparedScene& scene, std::uint64_t seed)
        : indirect_(std::move(indirect)),
          rays_(scene.rays()),
          lights_(scene.lights()),
          passes_(scene.settings().direct.samples / common::reference::samples_per_pass),
          seed_(seed ^ own_numbers) {}

    void irradiance(std::span<const SurfacePoint> points, std::span<Rgb> answers) const override {
        indirect_->irradiance(points, answers);
        for (std::size_t i = 0; i < points.size(); ++i) answers[i] += direct(points[i]);
    }

    [[nodiscard]] std::size_t bytes() const override { return indirect_->bytes(); }

  private:
    [[nodiscard]] Rgb direct(const SurfacePoint& point) const {
        using namespace common::reference;
        const std::uint32_t number = number_of(point);
        Imath::V3d sum(0, 0, 0);
        for (std::uint32_t pass = 0; pass < passes_; ++pass) {
            const PassStrata strata(seed_, number, pass);
            for (std::uint32_t i = 0; i < samples_per_pass; ++i) {
                RandomStream stream(seed_, number, pass, i);
                sum += sample_irradiance(rays_, lights_, point, strata.numbers(i, stream), stream,
                                         max_surfaces, LightPart::direct);
            }
        }
        return Rgb(sum / (passes_ * samples_per_pass));
    }

    std::unique_ptr<const Answers> indirect_;
    const common::RayScene& rays_;
    const common::reference::Lights& lights_;
    std::uint32_t passes_;
    std::uint64_t seed_;
};

}  // namespace

void DirectOptions::add_to(Command& command) {
    command.option("--direct", direct,
                   "photons: they bring all light; traced: they bring indirect light, and direct light is "
                   "sampled at each point");
    command.whole_number("--direct-samples", samples,
                         "Samples of direct light at each point: a multiple of 64");
}

DirectSetting DirectOptions::setting() const {
    if (direct != "photons" && direct != "traced")
        throw common::InputError("--direct: '" + direct + "' is neither photons nor traced");
    constexpr int in_a_pass = common::reference::samples_per_pass, most = 1'000'000;
    if (samples < in_a_pass || samples > most || samples % in_a_pass != 0)
        throw common::InputError("--direct-samples: a multiple of 64, from 64 to 1000000");
    return {direct == "traced", static_cast<std::uint32_t>(samples)};
}

common::RecordedHits recorded_hits(const DirectSetting& direct) {
    return direct.is_traced ? common::RecordedHits::indirect : common::RecordedHits::all;
}

void add_run_facts(nlohmann::ordered_json& row, const ContenderSettings& settings) {
    if (settings.direct.is_traced) {
        row["direct"] = "traced";
        row["direct_samples"] = settings.direct.samples;
    }
    if (settings.emission == common::EmissionSequence::sobol) row["emission"] = "sobol";
}

FinishedMap finish_with_direct(const Contender& contender, Store& store, const common::TraceReport& trace,
                               PreparedScene& scene, std::uint64_t seed) {
    FinishedMap map = contender->finish(store, trace);
    if (scene.settings().direct.is_traced)
        map.answers = std::make_unique<const WithDirectLight>(std::move(map.answers), scene, seed);
    return map;
}

}  // namespace bench
