// shlmbench merge: merges light maps of consecutive photons into one.
#include <fmt/format.h>

#include <algorithm>

#include "bench/setup/command.h"
#include "bench/setup/commit.h"
#include "bench/setup/ending.h"
#include "common/core/input_error.h"
#include "common/core/interrupt.h"
#include "common/core/output_file.h"
#include "common/core/output_lock.h"
#include "common/core/standard_streams.h"
#include "shlm/file/map_file.h"
#include "shlm/sums/texel_sums.h"

namespace bench {
namespace {

namespace fs = std::filesystem;

struct MergeOptions {
    std::vector<std::string> files;
    std::string out;
};

/// Opens the pieces, ordered by their photons. Throws InputError if they are not pieces of one run without
/// gaps.
std::vector<shlm::MapFileReader> open_pieces(const std::vector<std::string>& files) {
    if (files.size() < 2) throw common::InputError("there are at least two files to merge");
    std::vector<shlm::MapFileReader> pieces;
    for (const std::string& file : files) pieces.emplace_back(file);
    std::vector<std::size_t> order(pieces.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return pieces[a].run().first_photon < pieces[b].run().first_photon;
    });
    std::vector<shlm::MapFileReader> sorted;
    for (const std::size_t i : order) sorted.push_back(std::move(pieces[i]));

    for (std::size_t i = 1; i < sorted.size(); ++i) {
        const shlm::MapFileReader &last = sorted[i - 1], &next = sorted[i];
        const std::string reason = last.run().identity.difference(next.run().identity);
        const std::string file = next.file().string();
        if (!reason.empty()) throw common::InputError(fmt::format("{}: cannot be used: {}", file, reason));
        if (next.size().width != last.size().width || next.size().height != last.size().height)
            throw common::InputError(fmt::format("{}: cannot be used: its texels lie elsewhere", file));
        const std::uint64_t end = last.run().end_photon(), begin = next.run().first_photon;
        if (begin < end)
            throw common::InputError(fmt::format("{} and {} both have photons {} to {}", last.file().string(),
                                                 file, begin, std::min(end, next.run().end_photon()) - 1));
        if (begin > end)
            throw common::InputError(fmt::format("photons {} to {} are missing between {} and {}", end,
                                                 begin - 1, last.file().string(), file));
    }
    return sorted;
}

/// Throws InputError if the file exists and contains anything but photons of `run`.
void require_nothing_is_lost(const fs::path& out, const shlm::MapRun& run) {
    if (!fs::exists(out)) return;
    const shlm::MapRun there = shlm::MapFileReader(out).run();
    if (!run.identity.difference(there.identity).empty() || there.first_photon < run.first_photon ||
        there.end_photon() > run.end_photon())
        throw common::InputError(fmt::format(
            "--out: {} is there already, with photons that the files to merge do not have", out.string()));
}

/// Adds up what `read(piece, planes)` reads of every piece.
template <class Read>
void add_up(std::vector<shlm::MapFileReader>& pieces, std::span<std::int64_t> sums,
            std::span<std::int64_t> addend, Read read) {
    read(pieces.front(), sums);
    for (std::size_t p = 1; p < pieces.size(); ++p) {
        if (common::interrupted()) throw Interrupted("merge stopped: nothing is written");
        read(pieces[p], addend);
        for (std::size_t i = 0; i < sums.size(); ++i)
            if (__builtin_add_overflow(sums[i], addend[i], &sums[i]) || sums[i] <= -shlm::max_texel_quanta ||
                sums[i] >= shlm::max_texel_quanta)
                throw common::InputError(
                    fmt::format("{}: its light is more than a sum can hold together with the others'",
                                pieces[p].file().string()));
    }
}

void run(const MergeOptions& options) {
    shlm::check_map_output("--out", options.out);
    const std::vector<fs::path> inputs(options.files.begin(), options.files.end());
    for (const fs::path& file : {fs::path(options.out), shlm::part_of(options.out)})
        common::refuse_input_as_output("--out", file, inputs);
    const common::OutputLock lock("--out", options.out);
    std::vector<shlm::MapFileReader> pieces = open_pieces(options.files);
    shlm::MapRun run = pieces.front().run();
    for (std::size_t i = 1; i < pieces.size(); ++i) run.append(pieces[i].run());
    run.program = build_commit;
    require_nothing_is_lost(options.out, run);

    const shlm::MapFileSize size = pieces.front().size();
    shlm::MapFileWriter out(options.out, run, size);
    std::vector<std::int64_t> sums(3 * size.pixels()), addend(sums.size());
    for (std::uint64_t number = 0; number < size.numbers; ++number) {
        add_up(pieces, sums, addend, [](auto& piece, auto planes) { piece.read_number(planes); });
        out.write_number(sums);
    }
    const auto hits = std::span(sums).first(size.pixels());
    add_up(pieces, hits, std::span(addend).first(size.pixels()),
           [](auto& piece, auto plane) { piece.read_hits(plane); });
    out.write_hits(hits);
    for (shlm::MapFileReader& piece : pieces) piece.check();
    out.finish();
    common::print_result(fmt::format("{}: {} hits of {} photons from number {}\n", options.out, run.hits,
                                     run.fates.emitted, run.first_photon));
}

const RegisteredCommand registered(
    4, {.name = "merge",
        .purpose = "Join light maps of adjoining photon ranges: the same map as one run over all of them",
        .add_to = [](Command& command) -> std::function<void()> {
            const auto options = std::make_shared<MergeOptions>();
            command.option("FILE", options->files, "Files that trace has written, in any order",
                           Need::required);
            command.option("--out", options->out, "File to write, .exr", Need::required);
            return [options] { run(*options); };
        }});

}  // namespace

}  // namespace bench
