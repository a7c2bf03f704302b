#include "common/gltf/source_files.h"

#include <charconv>
#include <nlohmann/json.hpp>
#include <string>

#include "common/core/input_error.h"
#include "common/gltf/container.h"

namespace common {
namespace {

using Json = nlohmann::json;

/// The file name that a relative URI stands for (RFC 3986, section 2.1).
std::string percent_decoded(const std::string& uri) {
    std::string name;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        unsigned char byte = 0;
        const char* digits = uri.data() + i + 1;
        if (uri[i] == '%' && i + 2 < uri.size() &&
            std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
            name += static_cast<char>(byte);
            i += 2;
        } else {
            name += uri[i];
        }
    }
    return name;
}

std::vector<std::string> uris_in(const Json& document) {
    std::vector<std::string> uris;
    for (const char* list : {"buffers", "images"}) {
        if (!document.is_object() || !document.contains(list) || !document.at(list).is_array()) continue;
        for (const Json& item : document.at(list)) {
            if (!item.is_object() || !item.contains("uri") || !item.at("uri").is_string()) continue;
            std::string uri = item.at("uri").get<std::string>();
            if (!uri.starts_with("data:")) uris.push_back(std::move(uri));
        }
    }
    return uris;
}

}  // namespace

std::vector<std::filesystem::path> source_files(const std::filesystem::path& gltf) {
    std::vector<std::filesystem::path> files = {gltf};
    try {
        const std::string text = gltf::read_container(gltf).json;
        // As written and as decoded: both are asked for where files are read.
        for (const std::string& uri : uris_in(Json::parse(text, nullptr, false)))
            for (const std::string& name : {uri, percent_decoded(uri)})
                files.push_back(gltf.parent_path() / name);
    } catch (const InputError&) {  // as the one who loads it will say
    }
    return files;
}

}  // namespace common
