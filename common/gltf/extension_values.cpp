#include "common/gltf/extension_values.h"

namespace common::gltf {

const tinygltf::Value& extension_object(const tinygltf::ExtensionMap& extensions, const char* extension) {
    static const tinygltf::Value nothing;
    const auto found = extensions.find(extension);
    return found == extensions.end() ? nothing : found->second;
}

double number_or(const tinygltf::Value& object, const char* key, double missing) {
    return object.Has(key) ? object.Get(std::string(key)).GetNumberAsDouble() : missing;
}

std::vector<double> numbers_or(const tinygltf::Value& object, const char* key,
                               const std::vector<double>& missing) {
    if (!object.Has(key)) return missing;
    const tinygltf::Value& list = object.Get(std::string(key));
    if (list.ArrayLen() != missing.size()) return missing;
    std::vector<double> numbers(missing.size());
    for (std::size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = list.Get(static_cast<int>(i)).GetNumberAsDouble();
    return numbers;
}

tinygltf::TextureInfo texture_info(const tinygltf::Value& object, const char* key) {
    tinygltf::TextureInfo info;
    if (!object.Has(key)) return info;
    const tinygltf::Value& source = object.Get(std::string(key));
    if (!source.Has("index")) return info;
    info.index = source.Get("index").GetNumberAsInt();
    if (source.Has("texCoord")) info.texCoord = source.Get("texCoord").GetNumberAsInt();
    if (source.Has("extensions") && source.Get("extensions").IsObject())
        info.extensions = source.Get("extensions").Get<tinygltf::Value::Object>();
    return info;
}

}  // namespace common::gltf
