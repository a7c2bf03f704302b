// A light map's sums as an OpenEXR file, exact to the last bit.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "common/core/fnv.h"
#include "shlm/file/map_run.h"

namespace shlm {

/// The size of a multi-part file whose pixels are texels as TexelAtlas places them. Part "preview", for
/// viewing: R, G, B, the first number divided by the photons, W. Parts "number.0" and so on, the sums of a
/// texel model: R.low, R.high, G.low, ..., the two halves of a 64-bit integer in quanta. Part "hits":
/// hits.low, hits.high. Part "checksum": one pixel. The run is in the header as text.
struct MapFileSize {
    std::uint32_t width = 0, height = 0;
    std::uint64_t numbers = 0;  ///< per texel and channel

    [[nodiscard]] std::size_t pixels() const { return std::size_t{width} * height; }
};

/// 64-bit FNV-1a over words instead of bytes.
class Checksum {
  public:
    void add(const std::string& text);
    void add(std::span<const std::int64_t> values);
    [[nodiscard]] std::int64_t value() const { return static_cast<std::int64_t>(hash_); }

  private:
    std::uint64_t hash_ = common::fnv_start;
};

/// Writes beside the file, as FILE.part, which `finish` renames. An existing file of that name stays as it
/// was until then, whatever happens. Throws InputError if it cannot be written.
class MapFileWriter {
  public:
    MapFileWriter(std::filesystem::path file, const MapRun& run, const MapFileSize& size);
    ~MapFileWriter();
    MapFileWriter(const MapFileWriter&) = delete;
    MapFileWriter& operator=(const MapFileWriter&) = delete;

    /// Writes one number after the other: the pixels of its three channels, one channel after the other.
    void write_number(std::span<const std::int64_t> channels);
    void write_hits(std::span<const std::int64_t> hits);

    /// Flushes everything to the disk and renames.
    void finish();

  private:
    class Output;

    /// Removes the file when it is destroyed, unless the file has been renamed.
    struct TemporaryFile {
        std::filesystem::path path;
        ~TemporaryFile();
    };

    template <class Work>
    void guarded(Work work);
    void write_planes(int part, std::span<const std::int64_t> planes);
    void write_preview(std::span<const std::int64_t> channels);

    std::filesystem::path file_;
    TemporaryFile temporary_;
    MapRun run_;
    MapFileSize size_;
    Checksum checksum_;
    int next_number_ = 0;
    std::unique_ptr<Output> output_;
};

/// Throws InputError, with the file's name and the reason, for a file that is not complete.
class MapFileReader {
  public:
    explicit MapFileReader(std::filesystem::path file);
    ~MapFileReader();
    MapFileReader(MapFileReader&&) noexcept;
    MapFileReader& operator=(MapFileReader&&) = delete;

    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    [[nodiscard]] const MapRun& run() const { return run_; }
    [[nodiscard]] const MapFileSize& size() const { return size_; }

    /// Reads in the writer's layout and order.
    void read_number(std::span<std::int64_t> channels);
    void read_hits(std::span<std::int64_t> hits);

    /// Throws InputError unless all that was read is what was written.
    void check();

  private:
    class Input;

    template <class Work>
    void guarded(Work work) const;
    [[noreturn]] void refuse(const std::string& reason) const;
    void read_planes(int part, std::span<std::int64_t> planes);

    std::filesystem::path file_;
    MapRun run_;
    MapFileSize size_;
    Checksum checksum_;
    int next_number_ = 0;
    std::unique_ptr<Input> input_;
};

/// Returns FILE.part, the name under which a file is written.
[[nodiscard]] std::filesystem::path part_of(const std::filesystem::path& file);

/// Throws InputError, naming `option`, if a file cannot be written there. Does not ask whether one exists.
void check_map_output(const std::string& option, const std::filesystem::path& file);

}  // namespace shlm
