#include "bench/export/lightmap_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <nlohmann/json.hpp>

#include "bench/setup/provenance.h"
#include "common/core/output_file.h"
#include "common/image/image.h"

namespace bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* unit_text = "W/m^2 of irradiance, linear Rec. 709, not divided by pi";

constexpr const char* expansion_text =
    "the adaptive map's blocks are written as texels of order 2, in each region as large as its smallest "
    "block; "
    "relative_rms: how the texels' answers differ from the map's own at the points that the camera sees";

std::vector<std::string> channels_of(const ExportedMap& map) {
    std::vector<std::string> channels = {"R", "G", "B"};
    for (std::size_t i = 0; i < map.texels.numbers; ++i) channels.push_back(map.basis().number_name(i));
    channels.insert(channels.end(), {"covered.A", "hits"});
    return channels;
}

/// The channels' values of one pixel that shows `texel`.
void set_pixel(std::span<float> pixel, const StoredTexels& texels, std::size_t texel, bool its_own) {
    const common::Rgb& own = texels.own[texel];
    for (std::size_t c = 0; c < 3; ++c) pixel[c] = std::max(own[static_cast<int>(c)], 0.0f);
    for (std::size_t i = 0; i < texels.numbers; ++i)
        pixel[3 + i] = static_cast<float>(texels.number[texel * texels.numbers + i]) *
                       (i < texels.light_numbers ? texels.unit : 1);
    pixel[3 + texels.numbers] = its_own && texels.face[texel].area > 0 ? 1 : 0;
    pixel[4 + texels.numbers] = its_own ? static_cast<float>(texels.hits[texel]) : 0;
}

/// Calls `use(pixel, texel, its_own)` for all pixels that show a texel.
template <class Use>
void for_each_pixel(const LightAtlas& atlas, Use use) {
    std::vector<bool> own(atlas.pixel_count());
    atlas.places.for_each(
        [&](std::size_t texel, std::size_t pixel) { own[pixel] = atlas.shown[pixel] == texel; });
    for (std::size_t pixel = 0; pixel < atlas.pixel_count(); ++pixel)
        if (atlas.shown[pixel] != shlm::no_texel)
            use(pixel, std::size_t{atlas.shown[pixel]}, bool{own[pixel]});
}

}  // namespace

Json description_of(const ExportedMap& map) {
    Json names = Json::array();
    for (std::size_t i = 0; i < map.texels.numbers; ++i) names.push_back(map.basis().number_name(i));
    Json about = {
        {"method", map.method.name},
        {"fields", map.method->fields()},
        {"basis", map.basis().name},
        {"formula", map.basis().formula},
        {"numbers", names},
        {"light_numbers", map.texels.light_numbers},
        {"unit", map.texels.unit},
        {"unit_means",
         fmt::format("the first light_numbers of the half floats are in units of this many {}", unit_text)}};
    if (const auto& expansion = map.expansion)
        about["expansion"] = {{"bytes_of_map", expansion->bytes_of_map},
                              {"bytes_of_texels", expansion->bytes_of_texels},
                              {"relative_rms", expansion->relative_rms},
                              {"means", expansion_text}};
    return about;
}

Json description_of(const LightAtlas& atlas) {
    return {{"width", atlas.places.width()},
            {"height", atlas.places.height()},
            {"gutter", atlas.places.gutter()},
            {"rectangles", atlas.places.rectangles().size()}};
}

void write_lightmap_exr(const std::filesystem::path& file, const ExportedMap& map, const LightAtlas& atlas,
                        const ExportedRun& run) {
    common::Image image{static_cast<int>(atlas.places.width()),
                        static_cast<int>(atlas.places.height()),
                        channels_of(map),
                        {}};
    image.values.assign(image.pixel_count() * image.channels.size(), 0);
    for_each_pixel(atlas, [&](std::size_t pixel, std::size_t texel, bool its_own) {
        set_pixel(std::span(image.values).subspan(pixel * image.channels.size(), image.channels.size()),
                  map.texels, texel, its_own);
    });
    common::ImageNotes notes = provenance_notes();
    notes["shlmbench:scene"] = run.scene;
    notes["shlmbench:fingerprint"] = run.fingerprint;
    notes["shlmbench:method"] = map.method.name;
    notes["shlmbench:basis"] = map.basis().name;
    notes["shlmbench:formula"] = map.basis().formula;
    notes["shlmbench:unit"] = unit_text;
    notes["shlmbench:seed"] = std::to_string(run.seed);
    notes["shlmbench:hits"] = std::to_string(run.hits);
    notes["shlmbench:photons_emitted"] = std::to_string(run.photons);
    const std::string hits = "hits";  // a half holds no more than 2048 of them exactly
    common::write_exr(file, image, notes, common::Precision::half, std::span(&hits, 1));
}

void write_lightmap_npy(const std::filesystem::path& file, const ExportedMap& map, const LightAtlas& atlas) {
    static_assert(std::endian::native == std::endian::little);
    std::string header = fmt::format("{{'descr': '<f2', 'fortran_order': False, 'shape': ({}, {}, {}), }}",
                                     atlas.places.height(), atlas.places.width(), map.texels.numbers);
    constexpr std::size_t before = 10, aligned = 64;  // magic, version, length; as NumPy writes it
    header.resize((before + header.size() + 1 + aligned - 1) / aligned * aligned - before - 1, ' ');
    header += '\n';
    std::string bytes = "\x93NUMPY";
    bytes += {'\x01', '\x00', static_cast<char>(header.size() & 0xff), static_cast<char>(header.size() >> 8)};
    bytes += header;
    std::vector<shlm::half> values(atlas.pixel_count() * map.texels.numbers);
    for_each_pixel(atlas, [&](std::size_t pixel, std::size_t texel, bool) {
        std::copy_n(map.texels.number.begin() + static_cast<std::ptrdiff_t>(texel * map.texels.numbers),
                    map.texels.numbers,
                    values.begin() + static_cast<std::ptrdiff_t>(pixel * map.texels.numbers));
    });
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(shlm::half));
    common::write_whole_file(file, std::as_bytes(std::span(bytes)));
}

}  // namespace bench
