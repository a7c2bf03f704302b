#include "common/gltf/warnings.h"

#include <fmt/format.h>

#include <algorithm>

namespace common::gltf {

std::string one_line(std::string_view text) {
    constexpr std::size_t longest = 300;
    std::string line(text.substr(0, text.find('\n')));
    if (line.size() > longest) line = line.substr(0, longest) + "...";
    std::replace_if(
        line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; },
        ' ');
    return line;
}

void Warnings::add(const std::string& what, const std::string& where) {
    const auto [known, is_new] = entry_of_.try_emplace(what, entries_.size());
    if (is_new) {
        entries_.push_back({what, where, 1});
    } else {
        ++entries_[known->second].places;
    }
}

std::vector<std::string> Warnings::lines() const {
    std::vector<std::string> lines;
    for (const Entry& entry : entries_) {
        const std::string more = entry.places > 1 ? fmt::format(" and {} more", entry.places - 1) : "";
        lines.push_back(one_line(fmt::format("{}: {}{}", entry.what, entry.first_place, more)));
    }
    return lines;
}

}  // namespace common::gltf
