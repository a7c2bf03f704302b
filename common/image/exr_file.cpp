// Writes and reads OpenEXR files.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfTestFile.h>

#include <algorithm>

#include "common/core/output_file.h"
#include "common/image/exr_headers.h"
#include "common/image/image_reader.h"
#include "common/image/memory_stream.h"

namespace common {
namespace {

namespace fs = std::filesystem;

/// Returns the slice of `type` whose pixel at `corner` is at `first`. OpenEXR expects the address of pixel
/// (0, 0).
Imf::Slice slice(Imf::PixelType type, char* first, std::size_t pixel, int width, const Imath::V2i& corner) {
    const std::size_t row = pixel * static_cast<std::size_t>(width);
    char* const origin =
        first - static_cast<std::ptrdiff_t>(pixel) * corner.x - static_cast<std::ptrdiff_t>(row) * corner.y;
    return {type, origin, pixel, row};
}

/// Returns the channels of each layer in the order R, G, B, A; the file has them alphabetically.
std::vector<std::string> ordered_channels(const Imf::ChannelList& list) {
    std::vector<std::string> names;
    for (auto channel = list.begin(); channel != list.end(); ++channel) names.emplace_back(channel.name());
    const auto place = [](const std::string& name) {
        const std::size_t dot = name.rfind('.');
        const std::string layer = dot == std::string::npos ? "" : name.substr(0, dot);
        const std::string last = dot == std::string::npos ? name : name.substr(dot + 1);
        constexpr std::string_view order = "RGBA";
        const std::size_t rank = last.size() == 1 ? order.find(last[0]) : std::string_view::npos;
        return std::pair(layer, std::min(rank, order.size()));
    };
    std::stable_sort(names.begin(), names.end(),
                     [&](const std::string& a, const std::string& b) { return place(a) < place(b); });
    return names;
}

PictureWindow window_of(const Imf::Header& header) {
    const Imath::Box2i &data = header.dataWindow(), &display = header.displayWindow();
    return {data.min.x - display.min.x, data.min.y - display.min.y, data.size().x + 1,
            data.size().y + 1,          display.size().x + 1,       display.size().y + 1};
}

ImageHeader header_of(const Imf::Header& header) {
    ImageHeader read{window_of(header), ordered_channels(header.channels()), false, {}};
    for (auto attribute = header.begin(); attribute != header.end(); ++attribute)
        if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute.attribute()))
            read.notes[attribute.name()] = text->value();
    for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel)
        if (channel.channel().type != Imf::UINT) read.has_linear_values = true;
    return read;
}

bool is_flat(const Imf::Header& header) {
    if (header.hasType() && Imf::isDeepData(header.type())) return false;
    for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel)
        if (channel.channel().xSampling != 1 || channel.channel().ySampling != 1) return false;
    return true;
}

class ExrReader : public ImageReader {
  public:
    ExrReader(std::unique_ptr<Imf::MultiPartInputFile> exr, std::uintmax_t file_bytes)
        : ImageReader(header_of(exr->header(0))), exr_(std::move(exr)), file_bytes_(file_bytes) {}

    std::vector<float> read_values() override {
        const PictureWindow& window = header().window;
        const std::vector<std::string>& channels = header().channels;
        const double bytes =
            sizeof(float) * static_cast<double>(channels.size()) * window.width * window.height;
        constexpr double most_packed = 1e5;  // hardly any picture compresses further
        check_can_hold(file_bytes_, bytes, most_packed);
        std::vector<float> values(channels.size() * static_cast<std::size_t>(window.width) *
                                  static_cast<std::size_t>(window.height));
        const Imath::Box2i& data = exr_->header(0).dataWindow();
        Imf::FrameBuffer buffer;
        for (std::size_t c = 0; c < channels.size(); ++c)
            buffer.insert(channels[c], slice(Imf::FLOAT, reinterpret_cast<char*>(values.data() + c),
                                             sizeof(float) * channels.size(), window.width, data.min));
        Imf::InputPart part(*exr_, 0);
        part.setFrameBuffer(buffer);
        part.readPixels(data.min.y, data.max.y);
        return values;
    }

  private:
    std::unique_ptr<Imf::MultiPartInputFile> exr_;
    std::uintmax_t file_bytes_;
};

}  // namespace

void write_exr(const fs::path& file, const Image& image, const ImageNotes& notes, Precision precision,
               std::span<const std::string> always_single) {
    const bool half = precision == Precision::half && fits_in_halves(image);
    const auto type_of = [&](const std::string& channel) {
        return half && std::ranges::find(always_single, channel) == always_single.end() ? Imf::HALF
                                                                                        : Imf::FLOAT;
    };
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const auto& [name, text] : notes) header.insert(name, Imf::StringAttribute(text));
    for (const std::string& channel : image.channels)
        header.channels().insert(channel, Imf::Channel(type_of(channel)));

    // OpenEXR takes no const pointers.
    std::vector<Imath::half> halves = half
                                          ? std::vector<Imath::half>(image.values.begin(), image.values.end())
                                          : std::vector<Imath::half>();
    auto* const values = const_cast<float*>(image.values.data());
    const std::size_t count = image.channels.size();
    Imf::FrameBuffer buffer;
    for (std::size_t c = 0; c < count; ++c) {
        const Imf::PixelType type = type_of(image.channels[c]);
        const auto insert = [&](auto* first) {
            buffer.insert(image.channels[c], slice(type, reinterpret_cast<char*>(first + c),
                                                   sizeof(*first) * count, image.width, {0, 0}));
        };
        if (type == Imf::HALF)
            insert(halves.data());
        else
            insert(values);
    }
    MemoryStream stream(file.c_str());
    {
        Imf::OutputFile exr(stream, header);
        exr.setFrameBuffer(buffer);
        exr.writePixels(image.height);
    }
    write_whole_file(file, stream.bytes());
}

std::unique_ptr<ImageReader> open_exr(const fs::path& file) {
    if (!Imf::isOpenExrFile(file.c_str())) return nullptr;
    check_exr_headers(file);
    auto exr = std::make_unique<Imf::MultiPartInputFile>(file.c_str());
    if (!is_flat(exr->header(0))) return nullptr;
    return std::make_unique<ExrReader>(std::move(exr), fs::file_size(file));
}

}  // namespace common
