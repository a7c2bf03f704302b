#include "bench/setup/image_output.h"

#include <fmt/format.h>

#include "common/core/input_error.h"
#include "common/core/output_file.h"
#include "common/image/image.h"

namespace bench {
namespace {

namespace fs = std::filesystem;
using common::InputError;

/// Returns the notes of the file, or none if it cannot be read.
common::ImageNotes notes_of(const fs::path& file) {
    try {
        return common::read_notes(file);
    } catch (const InputError&) {
        return {};
    }
}

std::string note(const common::ImageNotes& notes, const std::string& key) {
    const auto found = notes.find(key);
    return found == notes.end() ? "" : found->second;
}

}  // namespace

fs::path picture_of(const fs::path& image) {
    return fs::path(image).replace_extension(".png");
}

void check_image_output(const std::string& out, int width, int height,
                        const std::function<std::vector<fs::path>()>& inputs) {
    if (fs::path(out).extension() != ".exr") throw InputError("--out: the image is an .exr file");
    common::check_output_file("--out", out);
    check_png_output("--out", picture_of(out), common::picture_of_light);
    for (const fs::path& file : {fs::path(out), picture_of(out)})
        if (fs::exists(file)) common::refuse_input_as_output("--out", file, inputs());
    if (width < 1 || height < 1 || width > 16384 || height > 16384)
        throw InputError("--width and --height: from 1 to 16384");
}

void check_replaces_a_rendered_image(const std::string& out) {
    if (!fs::exists(out)) return;
    const common::ImageNotes notes = notes_of(out);
    const std::string method = note(notes, "shlmbench:method");
    if (method.empty() || method == "reference" || notes.contains("shlmbench:map_format"))
        throw InputError(fmt::format("--out: {} is there already and no image that render made", out));
}

void check_png_output(const std::string& option, const fs::path& file, const std::string& shows) {
    common::check_output_file(option, file);
    if (fs::exists(file) && note(notes_of(file), common::shown_note) != shows)
        throw InputError(
            fmt::format("{}: {} is there already and was not made by this command", option, file.string()));
}

}  // namespace bench
