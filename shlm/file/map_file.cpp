#include "shlm/file/map_file.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <optional>

#include "common/core/input_error.h"
#include "common/core/output_file.h"
#include "common/image/exr_headers.h"
#include "shlm/sums/texel_sums.h"

namespace shlm {
namespace {

namespace fs = std::filesystem;
using common::InputError;

static_assert(std::endian::native == std::endian::little, "a number's halves are taken from memory");

/// OpenEXR's own stream does not report that the last bytes did not reach the disk.
class FileStream : public Imf::OStream {
  public:
    explicit FileStream(const fs::path& file)
        : Imf::OStream(file.c_str()), descriptor_(open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666)) {
        if (descriptor_ < 0) fail();
    }
    ~FileStream() override {
        if (descriptor_ >= 0) close(descriptor_);
    }
    FileStream(const FileStream&) = delete;
    FileStream& operator=(const FileStream&) = delete;

    void write(const char bytes[], int count) override {
        while (count > 0) {
            const auto written = ::write(descriptor_, bytes, static_cast<std::size_t>(count));
            if (written < 0 && errno == EINTR) continue;
            if (written <= 0) fail();
            bytes += written;
            count -= static_cast<int>(written);
        }
    }
    std::uint64_t tellp() override { return static_cast<std::uint64_t>(lseek(descriptor_, 0, SEEK_CUR)); }
    void seekp(std::uint64_t position) override {
        if (lseek(descriptor_, static_cast<off_t>(position), SEEK_SET) < 0) fail();
    }

    /// To be called when OpenEXR is done, as its destructors do not report errors.
    void flush() {
        if (!failure_.empty()) throw InputError(failure_);
        if (fsync(descriptor_) != 0) fail();
    }

  private:
    [[noreturn]] void fail() {
        failure_ = std::strerror(errno);
        throw InputError(failure_);
    }

    int descriptor_;
    std::string failure_;
};

constexpr std::array<const char*, 3> colors = {"R", "G", "B"};

/// Limit of a map's picture: 2^32 texels on shelves (TexelAtlas) need no more.
constexpr int largest_side = 1 << 18;

// Parts, in the file's order.
constexpr int preview_part = 0, first_number_part = 1;
int hits_part(const MapFileSize& size) {
    return first_number_part + static_cast<int>(size.numbers);
}
int checksum_part(const MapFileSize& size) {
    return hits_part(size) + 1;
}

std::vector<std::string> names_in(int part, const MapFileSize& size) {
    if (part == checksum_part(size)) return {"checksum"};
    if (part == hits_part(size)) return {"hits"};
    return {colors.begin(), colors.end()};
}

std::string name_of(int part, const MapFileSize& size) {
    if (part == preview_part) return "preview";
    if (part < hits_part(size)) return fmt::format("number.{}", part - first_number_part);
    return part == hits_part(size) ? "hits" : "checksum";
}

MapFileSize size_of(int part, const MapFileSize& size) {
    return part == checksum_part(size) ? MapFileSize{1, 1, size.numbers} : size;
}

Imf::Header header_of(int part, const MapFileSize& size) {
    const MapFileSize pixels = size_of(part, size);
    const Imath::Box2i window({0, 0},
                              {static_cast<int>(pixels.width) - 1, static_cast<int>(pixels.height) - 1});
    const Imath::Box2i display({0, 0}, {static_cast<int>(size.width) - 1, static_cast<int>(size.height) - 1});
    Imf::Header header(display, window);
    header.compression() = Imf::RLE_COMPRESSION;  // high halves are runs; more would cost seconds
    header.setType(Imf::SCANLINEIMAGE);
    header.setName(name_of(part, size));
    for (const std::string& name : names_in(part, size))
        if (part == preview_part) {
            header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        } else {
            header.channels().insert(name + ".low", Imf::Channel(Imf::UINT));
            header.channels().insert(name + ".high", Imf::Channel(Imf::UINT));
        }
    return header;
}

/// Returns the halves of 64-bit integers in place, one plane per name.
Imf::FrameBuffer buffer_of(int part, const MapFileSize& size, const std::int64_t* planes) {
    const MapFileSize pixels = size_of(part, size);
    Imf::FrameBuffer buffer;
    auto* base = reinterpret_cast<char*>(const_cast<std::int64_t*>(planes));  // OpenEXR takes no const
    for (const std::string& name : names_in(part, size)) {
        const std::size_t row = sizeof(std::int64_t) * pixels.width;
        buffer.insert(name + ".low", Imf::Slice(Imf::UINT, base, sizeof(std::int64_t), row));
        buffer.insert(name + ".high", Imf::Slice(Imf::UINT, base + 4, sizeof(std::int64_t), row));
        base += row * pixels.height;
    }
    return buffer;
}

/// Returns the text that the checksum covers: the run without the program that wrote it.
std::string checked_text(const MapRun& run) {
    MapRun checked = run;
    checked.program.clear();
    std::string text;
    for (const auto& [key, value] : to_notes(checked)) text += key + '=' + value + '\n';
    return text;
}

}  // namespace

void Checksum::add(const std::string& text) {
    for (const char c : text) hash_ = common::fnv_step(hash_, static_cast<unsigned char>(c));
}

void Checksum::add(std::span<const std::int64_t> values) {
    for (const std::int64_t value : values) {
        hash_ = common::fnv_step(hash_, static_cast<std::uint64_t>(value));
        hash_ ^= hash_ >> 32;  // a multiplication only affects higher bits
    }
}

// --- writing

class MapFileWriter::Output {
  public:
    Output(const fs::path& file, std::span<const Imf::Header> headers)
        : stream_(file), exr_(std::in_place, stream_, headers.data(), static_cast<int>(headers.size())) {}

    void write(int part, const Imf::FrameBuffer& buffer, int rows) {
        Imf::OutputPart out(*exr_, part);
        out.setFrameBuffer(buffer);
        out.writePixels(rows);
    }

    void finish() {
        exr_.reset();
        stream_.flush();
    }

  private:
    FileStream stream_;
    std::optional<Imf::MultiPartOutputFile> exr_;
};

template <class Work>
void MapFileWriter::guarded(Work work) {
    try {
        work();
    } catch (const std::exception& e) {
        throw InputError(fmt::format("{}: cannot be written: {}", file_.string(), e.what()));
    }
}

MapFileWriter::MapFileWriter(fs::path file, const MapRun& run, const MapFileSize& size)
    : file_(std::move(file)), temporary_{part_of(file_)}, run_(run), size_(size) {
    checksum_.add(checked_text(run));
    std::vector<Imf::Header> headers;
    for (int part = 0; part <= checksum_part(size); ++part) headers.push_back(header_of(part, size));
    for (const auto& [key, text] : to_notes(run)) headers[0].insert(key, Imf::StringAttribute(text));
    guarded([&] { output_ = std::make_unique<Output>(temporary_.path, headers); });
}

MapFileWriter::~MapFileWriter() = default;

MapFileWriter::TemporaryFile::~TemporaryFile() {
    unlink(path.c_str());
}

void MapFileWriter::write_planes(int part, std::span<const std::int64_t> planes) {
    guarded([&] {
        output_->write(part, buffer_of(part, size_, planes.data()),
                       static_cast<int>(size_of(part, size_).height));
    });
}

/// Row by row, as another set of planes would be too large with millions of texels.
void MapFileWriter::write_preview(std::span<const std::int64_t> channels) {
    const double per_photon = 1 / static_cast<double>(std::max<std::uint64_t>(run_.fates.emitted, 1));
    std::vector<float> row(3 * std::size_t{size_.width});
    Imf::FrameBuffer buffer;
    for (std::size_t c = 0; c < 3; ++c)
        buffer.insert(colors[c], Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(row.data() + c * size_.width),
                                            sizeof(float), 0));
    for (std::size_t y = 0; y < size_.height; ++y) {
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t x = 0; x < size_.width; ++x)
                row[c * size_.width + x] = static_cast<float>(std::ldexp(
                    static_cast<double>(channels[c * size_.pixels() + y * size_.width + x]) * per_photon,
                    run_.identity.quantum[c]));
        guarded([&] { output_->write(preview_part, buffer, 1); });
    }
}

void MapFileWriter::write_number(std::span<const std::int64_t> channels) {
    if (next_number_ == 0) write_preview(channels);
    write_planes(first_number_part + next_number_++, channels);
    checksum_.add(channels);
}

void MapFileWriter::write_hits(std::span<const std::int64_t> hits) {
    write_planes(hits_part(size_), hits);
    checksum_.add(hits);
}

void MapFileWriter::finish() {
    const std::int64_t checksum = checksum_.value();
    write_planes(checksum_part(size_), std::span(&checksum, 1));
    guarded([&] {
        output_->finish();
        fs::rename(temporary_.path, file_);
        output_.reset();
        // The rename reaches the disk only with the folder.
        const fs::path folder = file_.has_parent_path() ? file_.parent_path() : ".";
        if (const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY); descriptor >= 0) {
            fsync(descriptor);
            close(descriptor);
        }
    });
}

// --- reading

class MapFileReader::Input {
  public:
    explicit Input(const fs::path& file) : exr_(file.c_str()) {}

    [[nodiscard]] const Imf::MultiPartInputFile& exr() const { return exr_; }

    void read(int part, const Imf::FrameBuffer& buffer, int rows) {
        Imf::InputPart in(exr_, part);
        in.setFrameBuffer(buffer);
        in.readPixels(0, rows - 1);
    }

  private:
    Imf::MultiPartInputFile exr_;
};

namespace {

std::map<std::string, std::string> notes_in(const Imf::Header& header) {
    std::map<std::string, std::string> notes;
    for (auto attribute = header.begin(); attribute != header.end(); ++attribute)
        if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute.attribute()))
            notes[attribute.name()] = text->value();
    return notes;
}

/// Throws InputError unless the file has exactly the parts that a map of this size has.
void check_parts(const Imf::MultiPartInputFile& exr, const MapFileSize& size) {
    if (exr.parts() != checksum_part(size) + 1)
        throw InputError(fmt::format("it has {} parts, not {}", exr.parts(), checksum_part(size) + 1));
    for (int part = 0; part < exr.parts(); ++part) {
        const Imf::Header& found = exr.header(part);
        const Imf::Header expected = header_of(part, size);
        if (!found.hasName() || found.name() != expected.name() || !found.hasType() ||
            found.type() != expected.type() || found.dataWindow() != expected.dataWindow() ||
            !(found.channels() == expected.channels()))
            throw InputError(fmt::format("part {} is not what it should be", expected.name()));
    }
}

}  // namespace

void MapFileReader::refuse(const std::string& reason) const {
    throw InputError(fmt::format("{}: cannot be used: {}", file_.string(), reason));
}

template <class Work>
void MapFileReader::guarded(Work work) const {
    try {
        work();
    } catch (const std::bad_alloc&) {
        refuse("its header asks for more memory than there is");
    } catch (const std::exception& e) {
        std::string reason = e.what();
        std::replace(reason.begin(), reason.end(), '\n', ' ');
        refuse(reason);
    }
}

MapFileReader::MapFileReader(fs::path file) : file_(std::move(file)) {
    guarded([&] {
        std::error_code error;
        const auto bytes = fs::file_size(file_, error);
        if (error) throw InputError(error.message());
        // OpenEXR allocates what a header asks for before it checks the file's length.
        common::check_exr_headers(file_);
        Imf::Header::setMaxImageSize(largest_side, largest_side);
        input_ = std::make_unique<Input>(file_);
        const Imf::Header& first = input_->exr().header(0);
        run_ = map_run_of(notes_in(first));
        const Imath::V2i size = first.dataWindow().size() + Imath::V2i(1, 1);
        if (size.x < 1 || size.y < 1 || run_.identity.numbers < 1 || run_.identity.numbers > 64)
            throw InputError("its size is none that a light map has");
        size_ = {static_cast<std::uint32_t>(size.x), static_cast<std::uint32_t>(size.y),
                 run_.identity.numbers};
        // Runs of up to 128 equal bytes become 2: no file compresses better than that.
        if (static_cast<double>(size_.pixels()) * static_cast<double>(24 * size_.numbers) >
                64.0 * static_cast<double>(bytes) ||
            run_.identity.texels > size_.pixels())
            throw InputError("it is shorter than its header says");
        check_parts(input_->exr(), size_);
        if (!input_->exr().partComplete(checksum_part(size_))) throw InputError("it is cut off");
    });
    checksum_.add(checked_text(run_));
}

MapFileReader::~MapFileReader() = default;
MapFileReader::MapFileReader(MapFileReader&&) noexcept = default;

void MapFileReader::read_planes(int part, std::span<std::int64_t> planes) {
    guarded([&] {
        input_->read(part, buffer_of(part, size_, planes.data()),
                     static_cast<int>(size_of(part, size_).height));
    });
}

void MapFileReader::read_number(std::span<std::int64_t> channels) {
    read_planes(first_number_part + next_number_++, channels);
    if (std::any_of(channels.begin(), channels.end(), [](std::int64_t quanta) {
            return quanta <= -max_texel_quanta || quanta >= max_texel_quanta;
        }))
        refuse("it is damaged: a sum is beyond what sums reach");
    checksum_.add(channels);
}

void MapFileReader::read_hits(std::span<std::int64_t> hits) {
    read_planes(hits_part(size_), hits);
    checksum_.add(hits);
}

void MapFileReader::check() {
    std::int64_t written = 0;
    read_planes(checksum_part(size_), std::span(&written, 1));
    if (written != checksum_.value()) refuse("it is damaged: its checksum does not fit");
}

namespace {

/// Returns whether the file begins as an OpenEXR file does, as far as it goes: a killed run leaves such a
/// file.
bool is_begun_exr(const fs::path& file) {
    constexpr std::string_view magic = "\x76\x2f\x31\x01";
    std::error_code ignored;
    if (!fs::is_regular_file(file, ignored)) return false;
    std::array<char, magic.size()> start{};
    std::ifstream in(file, std::ios::binary);
    in.read(start.data(), start.size());
    return magic.starts_with(std::string_view(start.data(), static_cast<std::size_t>(in.gcount())));
}

}  // namespace

fs::path part_of(const fs::path& file) {
    return file.string() + ".part";
}

void check_map_output(const std::string& option, const fs::path& file) {
    if (file.extension() != ".exr")
        throw InputError(fmt::format("{}: {} is not an .exr file", option, file.string()));
    common::check_output_file(option, file);
    if (const fs::path part = part_of(file); fs::exists(part) && !is_begun_exr(part))
        throw InputError(fmt::format("{}: {} is in the way, and not of an earlier run; remove it first",
                                     option, part.string()));
}

}  // namespace shlm
