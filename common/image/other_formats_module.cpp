// All other image formats, by OpenImageIO: a module of its own (open_other_format).
#include <OpenImageIO/imageio.h>

#include <stdexcept>

#include "common/image/other_formats.h"

namespace {

using common::ImageHeader;

ImageHeader header_of(const OIIO::ImageSpec& spec) {
    ImageHeader header{{spec.x - spec.full_x, spec.y - spec.full_y, spec.width, spec.height, spec.full_width,
                        spec.full_height},
                       spec.channelnames,
                       spec.format.is_floating_point(),
                       {}};
    for (const OIIO::ParamValue& attribute : spec.extra_attribs)
        if (attribute.type() == OIIO::TypeString)
            header.notes[attribute.name().string()] = attribute.get_string();
    return header;
}

class Reader : public common::ImageReader {
  public:
    explicit Reader(std::unique_ptr<OIIO::ImageInput> input)
        : ImageReader(header_of(input->spec())), input_(std::move(input)) {}

    std::vector<float> read_values() override {
        const OIIO::ImageSpec& spec = input_->spec();
        std::vector<float> values(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
        if (!input_->read_image(0, 0, 0, spec.nchannels, OIIO::TypeFloat, values.data()))
            throw std::runtime_error(input_->geterror());
        return values;
    }

  private:
    std::unique_ptr<OIIO::ImageInput> input_;
};

}  // namespace

extern "C" common::ImageReader* shlmbench_open_other_format(const char* file, std::string& error) {
    auto input = OIIO::ImageInput::open(file);
    if (!input) {
        error = OIIO::geterror();
        return nullptr;
    }
    return new Reader(std::move(input));
}
