// shlmbench trace: fills a light map for as long as one likes, and keeps it in a file.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "bench/contenders/contender_options.h"
#include "bench/contenders/light_map.h"
#include "bench/contenders/memory_need.h"
#include "bench/contenders/trace_into.h"
#include "bench/contenders/warnings.h"
#include "bench/setup/command.h"
#include "bench/setup/commit.h"
#include "bench/setup/ending.h"
#include "bench/setup/numbers.h"
#include "bench/setup/run_options.h"
#include "common/core/input_error.h"
#include "common/core/interrupt.h"
#include "common/core/memory_use.h"
#include "common/core/output_lock.h"
#include "common/core/progress.h"
#include "common/core/standard_streams.h"
#include "common/core/stopwatch.h"
#include "common/core/threads.h"
#include "shlm/file/map_file.h"

namespace bench {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct TraceOptions {
    std::string file, method = "shlm", hits, photons, first_photon, checkpoint, resume, every = "60s";
    SceneOptions scene;
    TexelOptions texels;
    RunOptions run;
    bool json = false;
};

/// The checked options.
struct TracePlan {
    const TraceOptions& options;
    Contender method;
    ContenderSettings settings;
    common::TraceTarget target;
    fs::path checkpoint;  ///< file to write; empty: none
    double seconds_between_checkpoints;
};

common::TraceTarget target_of(const TraceOptions& options) {
    if (options.hits.empty() == options.photons.empty())
        throw common::InputError("one of --hits and --photons says how much to trace");
    common::TraceTarget target;
    if (!options.hits.empty()) target.hits = parse_count("--hits", options.hits);
    if (!options.photons.empty()) target.photons = parse_count("--photons", options.photons);
    if (!options.first_photon.empty() && options.first_photon != "0")
        target.first_photon = parse_count("--first-photon", options.first_photon);
    return target;
}

/// Resolves symbolic links, so that writing replaces the file itself and not a link.
fs::path followed(const fs::path& file) {
    std::error_code not_there;
    return fs::is_symlink(file, not_there) ? fs::canonical(file, not_there) : file;
}

TracePlan make_plan(const TraceOptions& options) {
    TracePlan plan{options,
                   parse_contender("--method", options.method),
                   {.texels = options.texels.choice()},
                   target_of(options),
                   options.checkpoint.empty() || options.checkpoint == options.resume
                       ? followed(options.resume)
                       : fs::path(options.checkpoint),
                   parse_seconds("--every", options.every)};
    if (!plan.method.light_map())
        throw common::InputError("--method: only a light map, shlm/..., is traced so");
    require_memory(plan.method, plan.settings, 0, default_max_bytes());
    return plan;
}

/// Locks the checkpoint for this run; returns null if there is none. Throws InputError if another run holds
/// it, or if it is left over from an earlier run and this run does not continue it.
std::unique_ptr<const common::OutputLock> claim_checkpoint(const TracePlan& plan) {
    if (plan.checkpoint.empty()) return nullptr;
    const std::string option = plan.options.checkpoint.empty() ? "--resume" : "--checkpoint";
    shlm::check_map_output(option, plan.checkpoint);
    auto lock = std::make_unique<const common::OutputLock>(option, plan.checkpoint);
    // Checked under the lock, when no other run can create it any more.
    if (!plan.options.checkpoint.empty() && plan.options.checkpoint != plan.options.resume &&
        fs::exists(plan.checkpoint))
        throw common::InputError(fmt::format("--checkpoint: {} is there already; --resume goes on from it",
                                             plan.checkpoint.string()));
    return lock;
}

/// The sums that are being filled, with what is needed to write them.
class MapTrace {
  public:
    /// Takes over the sums of the file to resume.
    MapTrace(const TracePlan& plan, const shlm::MapIdentity& identity, PreparedScene& scene,
             const common::PhotonSource& source)
        : plan_(plan),
          sums_(plan.method.light_map()->make_sums(scene, source)),
          atlas_(plan.method.light_map()->texels_of(scene).layout) {
        run_.identity = identity;
        run_.first_photon = plan.target.first_photon;
        if (!plan.options.resume.empty()) resume();
    }

    common::TraceReport trace(const LoadedScene& loaded, const common::PhotonSource& source) {
        common::TraceTarget target = plan_.target;
        target.first_photon = run_.first_photon;
        const auto done = [&](const common::TraceReport& r) {
            return target.hits ? r.hits : r.fates.emitted;
        };
        const std::uint64_t before = done(run_.report()), total = target.hits ? target.hits : target.photons;
        common::Progress progress("tracing", target.hits ? "hits" : "photons",
                                  total - std::min(total, before));
        common::Stopwatch since_checkpoint;
        const auto show_and_keep = [&](const common::TraceReport& so_far) {
            progress.show(done(so_far) - before);
            if (!plan_.checkpoint.empty() &&
                since_checkpoint.seconds() >= plan_.seconds_between_checkpoints) {
                write(so_far);
                since_checkpoint = common::Stopwatch();
            }
            return !common::interrupted();
        };
        const common::TraceReport report = trace_into(
            *sums_, {loaded.rays, source, run_.identity.seed, target, show_and_keep, run_.report()});
        if (!plan_.checkpoint.empty()) write(report);
        return report;
    }

    [[nodiscard]] const shlm::MapRun& run() const { return run_; }
    [[nodiscard]] StoreFacts facts() const { return sums_->facts(); }
    [[nodiscard]] double checkpoint_seconds() const { return checkpoint_seconds_; }
    [[nodiscard]] int checkpoints() const { return checkpoints_; }

  private:
    void resume() {
        const std::string& file = plan_.options.resume;
        run_ = sums_->read(file, run_.identity, atlas_);
        if (!plan_.options.first_photon.empty() && run_.first_photon != plan_.target.first_photon)
            throw common::InputError(fmt::format("{}: cannot be used: it begins at photon {}, not {}", file,
                                                 run_.first_photon, plan_.target.first_photon));
        if (plan_.target.photons > 0 && run_.fates.emitted > plan_.target.photons)
            throw common::InputError(
                fmt::format("{}: cannot be used: it has {} photons already", file, run_.fates.emitted));
    }

    void write(const common::TraceReport& so_far) {
        const common::Stopwatch watch;
        shlm::MapRun run = run_;
        run.fates = so_far.fates;
        run.hits = so_far.hits;
        run.program = build_commit;
        sums_->write(plan_.checkpoint, run, atlas_);
        checkpoint_seconds_ += watch.seconds();
        ++checkpoints_;
    }

    const TracePlan& plan_;
    shlm::MapRun run_;  ///< as it was when this command started
    std::unique_ptr<LightMapStore> sums_;
    shlm::TexelAtlas atlas_;
    double checkpoint_seconds_ = 0;
    int checkpoints_ = 0;
};

/// Returns what the command reports at its end.
Json summary(const TracePlan& plan, const LoadedScene& loaded, const MapTrace& traced,
             const StoreFacts& facts, const common::TraceReport& report, double seconds) {
    const std::uint64_t hits = report.hits - traced.run().hits;
    Json all = {{"scene", loaded.name},
                {"scene_fingerprint", traced.run().identity.scene},
                {"method", plan.method.name},
                {"texels", traced.run().identity.texels},
                {"seed", traced.run().identity.seed},
                {"threads", plan.options.run.thread_count()},
                {"first_photon", traced.run().first_photon},
                {"photons", report.fates.emitted},
                {"hits", report.hits},
                {"hits_rejected", facts.rejected.total()},
                {"clamped_share", facts.clamped_share},
                {"resumed_at_hits", traced.run().hits},
                {"seconds", seconds},
                {"hits_per_second", static_cast<double>(hits) / seconds},
                {"insert_bytes", facts.bytes},
                {"peak_resident_bytes", common::peak_resident_bytes()}};
    if (!plan.checkpoint.empty()) {
        all["checkpoint"] = plan.checkpoint.string();
        all["checkpoints_written"] = traced.checkpoints();
        all["checkpoint_seconds"] = traced.checkpoint_seconds();
    }
    return all;
}

void print(const Json& all) {
    common::print_result(fmt::format(
        "{}: {} hits of {} photons from number {}, {} of them rejected\n", all["scene"].get<std::string>(),
        all["hits"].get<std::uint64_t>(), all["photons"].get<std::uint64_t>(),
        all["first_photon"].get<std::uint64_t>(), all["hits_rejected"].get<std::uint64_t>()));
    common::print_result(fmt::format("{:.1f} s, {:.3g} M hits/s, peak memory {:.0f} MiB\n",
                                     all["seconds"].get<double>(), all["hits_per_second"].get<double>() / 1e6,
                                     all["peak_resident_bytes"].get<double>() * 0x1p-20));
    if (all.contains("checkpoint"))
        common::print_result(
            fmt::format("{}: written {} times in {:.1f} s\n", all["checkpoint"].get<std::string>(),
                        all["checkpoints_written"].get<int>(), all["checkpoint_seconds"].get<double>()));
}

[[noreturn]] void end_interrupted(const TracePlan& plan, const common::TraceReport& report) {
    if (plan.checkpoint.empty()) throw Interrupted("trace stopped: nothing is kept without --checkpoint");
    throw Interrupted(
        fmt::format("trace stopped at {} hits; --resume {} goes on", report.hits, plan.checkpoint.string()));
}

void run(const TraceOptions& options) {
    const TracePlan plan = make_plan(options);
    const auto lock = claim_checkpoint(plan);
    common::ThreadPool pool(options.run.thread_count());
    pool.run([&] {
        const LoadedScene loaded(options.file, options.scene);
        const common::PhotonSource source(loaded.rays);
        PreparedScene prepared(loaded, plan.settings);
        (void)plan.method->prepare(prepared);
        MapTrace traced(plan, plan.method.light_map()->identity(prepared, source, options.run.seed), prepared,
                        source);
        print_scene_warnings(loaded);
        print_light_warnings(loaded, source);
        print_lightmap_warnings(loaded, prepared);
        if (!options.resume.empty() && traced.run().program != build_commit)
            print_warning(loaded, fmt::format("{} was written by version {}, this is {}", options.resume,
                                              traced.run().program, build_commit));
        const common::Stopwatch watch;
        const common::TraceReport report = traced.trace(loaded, source);
        if (report.interrupted) end_interrupted(plan, report);
        const double seconds = watch.seconds();
        const StoreFacts facts = traced.facts();
        Json all = summary(plan, loaded, traced, facts, report, seconds);
        std::vector<std::string> warnings = loaded.scene.warnings;
        const auto add = [&](const std::vector<std::string>& lines) {
            warnings.insert(warnings.end(), lines.begin(), lines.end());
        };
        add(light_trouble(source));
        add(prepared.lightmap_trouble());
        const std::vector<std::string> of_run = run_trouble(report, facts.rejected, source);
        add(of_run);
        all["warnings"] = warnings;
        for (const std::string& line : of_run) print_warning(loaded, line);
        if (options.json)
            common::print_result(fmt::format(
                "{}\n", all.dump(2, ' ', false, Json::error_handler_t::replace)));  // odd file names
        else
            print(all);
    });
}

const RegisteredCommand registered(
    3, {.name = "trace",
        .purpose = "Fill a light map with any number of hits, kept in a file on the way",
        .add_to = [](Command& command) -> std::function<void()> {
            const auto options = std::make_shared<TraceOptions>();
            command.option("SCENE", options->file, "glTF 2.0 file, .gltf or .glb", Need::required);
            command.option("--method", options->method, "Which light map: shlm/...");
            command.option("--hits", options->hits,
                           "Trace until there are at least this many hits, e.g. 1e9");
            command.option("--photons", options->photons, "Trace exactly this many photons");
            command.option("--first-photon", options->first_photon,
                           "Begin at this photon of the run: for pieces that are merged later");
            command.option("--checkpoint", options->checkpoint, "Keep the sums in this file, .exr");
            command.option("--every", options->every, "How often to write it: 60s, 5min, 1h");
            command.option("--resume", options->resume,
                           "Go on from this file, and in it unless --checkpoint names another");
            options->scene.add_to(command);
            options->texels.add_to(command);
            options->run.add_to(command);
            command.flag("--json", options->json, "Print JSON");
            return [options] { run(*options); };
        }});

}  // namespace

}  // namespace bench
