// A light map's sums as OpenEXR, exact to the last bit.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "common/core/fnv.h"
#include "shlm/file/map_run.h"

namespace shlm {

/// A multi-part file; pixels are texels as TexelAtlas places them. Part "preview", to look at: R, G, B, the
/// first number over the photons, W. Parts "number.0" and so on, as a texel model sums them: R.low, R.high,
/// G.low, ..., the two halves of a 64-bit integer in quanta. Part "hits": hits.low, hits.high. Part
/// "checksum": one pixel. The run is in the header as text.
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

/// Writes beside the file, as FILE.part; `finish` puts it in the file's place. A file of that name stays as
/// it was until then, whatever happens. Throws InputError where it cannot be written.
class MapFileWriter {
  public:
    MapFileWriter(std::filesystem::path file, const MapRun& run, const MapFileSize& size);
    ~MapFileWriter();
    MapFileWriter(const MapFileWriter&) = delete;
    MapFileWriter& operator=(const MapFileWriter&) = delete;

    /// Number after number: the pixels of its three channels, one channel after the other.
    void write_number(std::span<const std::int64_t> channels);
    void write_hits(std::span<const std::int64_t> hits);

    /// Flushes everything to the disk and renames.
    void finish();

  private:
    class Output;

    /// Gone with the object, unless it was moved elsewhere.
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

/// Throws InputError, with the file's name and the reason, for a file that is not whole.
class MapFileReader {
  public:
    explicit MapFileReader(std::filesystem::path file);
    ~MapFileReader();
    MapFileReader(MapFileReader&&) noexcept;
    MapFileReader& operator=(MapFileReader&&) = delete;

    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    [[nodiscard]] const MapRun& run() const { return run_; }
    [[nodiscard]] const MapFileSize& size() const { return size_; }

    /// As the writer has them, and in its order.
    void read_number(std::span<std::int64_t> channels);
    void read_hits(std::span<std::int64_t> hits);

    /// Whether all that was read is what was written.
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

/// FILE.part, where a file is written.
[[nodiscard]] std::filesystem::path part_of(const std::filesystem::path& file);

/// Throws InputError, naming `option`, where a file cannot be put there. Whether one is there is not asked.
void check_map_output(const std::string& option, const std::filesystem::path& file);

}  // namespace shlm
