// Writes a light map's sums to a file and reads them back.
#pragma once

#include <fmt/format.h>

#include "common/core/input_error.h"
#include "shlm/file/map_file.h"
#include "shlm/file/texel_atlas.h"
#include "shlm/sums/accumulator.h"

namespace shlm {

/// Throws InputError if the file cannot be written; an existing file then stays as it was.
template <class Model>
void write_checkpoint(const std::filesystem::path& file, MapRun run, const TexelAtlas& atlas,
                      const Accumulator<Model>& accumulator) {
    run.rejected = accumulator.rejected();
    run.clamped = accumulator.clamped();
    const MapFileSize size{atlas.width(), atlas.height(), Model::summed};
    MapFileWriter out(file, run, size);
    const TexelSums<Model>& sums = accumulator.sums();
    std::vector<std::int64_t> planes(3 * size.pixels());
    for (std::size_t number = 0; number < Model::summed; ++number) {
        atlas.for_each([&](std::size_t texel, std::size_t pixel) {
            for (std::size_t c = 0; c < 3; ++c)
                planes[c * size.pixels() + pixel] = sums.quanta(texel, 3 * number + c);
        });
        out.write_number(planes);
    }
    const auto hits = std::span(planes).first(size.pixels());
    std::fill(hits.begin(), hits.end(), 0);
    atlas.for_each([&](std::size_t texel, std::size_t pixel) {
        hits[pixel] = static_cast<std::int64_t>(sums.hits(texel));
    });
    out.write_hits(hits);
    out.finish();
}

/// Adds a file's sums to those of an accumulator. Throws InputError for a file of anything other than
/// `expected`, and for a broken one; the accumulator is then unusable.
template <class Model>
MapRun read_checkpoint(const std::filesystem::path& file, const MapIdentity& expected,
                       const TexelAtlas& atlas, Accumulator<Model>& accumulator) {
    MapFileReader in(file);
    if (const std::string reason = expected.difference(in.run().identity); !reason.empty())
        throw common::InputError(fmt::format("{}: cannot be used: {}", file.string(), reason));
    if (in.size().width != atlas.width() || in.size().height != atlas.height())
        throw common::InputError(fmt::format("{}: cannot be used: its texels lie elsewhere", file.string()));
    TexelSums<Model>& sums = accumulator.sums();
    std::vector<std::int64_t> planes(3 * in.size().pixels());
    for (std::size_t number = 0; number < Model::summed; ++number) {
        in.read_number(planes);
        atlas.for_each([&](std::size_t texel, std::size_t pixel) {
            for (std::size_t c = 0; c < 3; ++c)
                sums.add_quanta(texel, 3 * number + c, planes[c * in.size().pixels() + pixel]);
        });
    }
    const auto hits = std::span(planes).first(in.size().pixels());
    in.read_hits(hits);
    atlas.for_each([&](std::size_t texel, std::size_t pixel) {
        sums.add_hits(texel, static_cast<std::uint64_t>(hits[pixel]));
    });
    in.check();
    accumulator.add_counts(in.run().rejected, in.run().clamped);
    return in.run();
}

}  // namespace shlm
