#include "common/gltf/source_files.h"

#include <nlohmann/json.hpp>
#include <string>

#include "common/core/input_error.h"
#include "common/gltf/container.h"
#include "common/gltf/uri.h"

namespace common {
namespace {

using Json = nlohmann::json;

std::vector<std::string> uris_in(const Json& document) {
    std::vector<std::string> uris;
    for (const char* list : {"buffers", "images"}) {
        if (!document.is_object() || !document.contains(list) || !document.at(list).is_array()) continue;
        for (const Json& item : document.at(list)) {
            if (!item.is_object() || !item.contains("uri") || !item.at("uri").is_string()) continue;
            std::string uri = item.at("uri").get<std::string>();
            if (!gltf::is_data_uri(uri)) uris.push_back(std::move(uri));
        }
    }
    return uris;
}

}  // namespace

std::vector<std::filesystem::path> source_files(const std::filesystem::path& gltf) {
    std::vector<std::filesystem::path> files = {gltf};
    try {
        const std::string text = gltf::read_container(gltf).json;
        // Both as written and as decoded, as reading tries both.
        for (const std::string& uri : uris_in(Json::parse(text, nullptr, false)))
            for (const std::string& name : {uri, gltf::percent_decoded(uri)})
                files.push_back(gltf.parent_path() / name);
    } catch (const InputError&) {  // loading the file reports it
    }
    return files;
}

}  // namespace common
