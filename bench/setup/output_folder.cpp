#include "bench/setup/output_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "common/core/input_error.h"
#include "common/core/output_file.h"

namespace bench {
namespace {

namespace fs = std::filesystem;

bool is_table(const fs::path& file) {
    std::ifstream in(file);
    const auto document = nlohmann::json::parse(in, nullptr, false);
    return document.is_object() && document.contains("context") && document["context"].is_object();
}

void check_files(const std::string& option, const fs::path& folder, const ResultNames& names) {
    const fs::path table = folder / names.table;
    common::check_output_file(option, table);
    const bool has_table = fs::exists(table);
    if (has_table && !is_table(table))
        throw common::InputError(
            fmt::format("{}: not a table of earlier results; remove it first", table.string()));
    for (const std::string& name : names.files) {
        const fs::path file = folder / name;
        common::check_output_file(option, file);
        if (!has_table && fs::exists(file))
            throw common::InputError(
                fmt::format("{}: is there without {}, not of an earlier run; remove it first", file.string(),
                            names.table));
    }
    for (const std::string& name : names.folders) {
        const fs::path within = folder / name;
        if (fs::exists(within) && !fs::is_directory(within))
            throw common::InputError(fmt::format("{}: {} is no folder", option, within.string()));
    }
}

/// Returns whether `file` is inside `folder`; both exist.
bool lies_in(const fs::path& file, const fs::path& folder) {
    std::error_code trouble;
    const fs::path whole_file = fs::canonical(file, trouble), whole_folder = fs::canonical(folder, trouble);
    return !trouble &&
           std::mismatch(whole_folder.begin(), whole_folder.end(), whole_file.begin(), whole_file.end())
                   .first == whole_folder.end();
}

}  // namespace

void check_results(const std::string& option, const fs::path& folder, const ResultNames& names,
                   std::span<const fs::path> inputs) {
    std::error_code ignored;
    if (!fs::exists(folder, ignored)) return;
    if (!fs::is_directory(folder, ignored))
        throw common::InputError(fmt::format("{}: {} is no folder", option, folder.string()));
    common::refuse_input_as_output(option, folder / names.table, inputs);
    for (const std::string& name : names.files) common::refuse_input_as_output(option, folder / name, inputs);
    for (const std::string& name : names.folders)
        for (const fs::path& input : inputs)
            if (fs::exists(input, ignored) && fs::exists(folder / name, ignored) &&
                lies_in(input, folder / name))
                throw common::InputError(fmt::format("{}: {}, which is read, lies in {}, where results go",
                                                     option, input.string(), (folder / name).string()));
    check_files(option, folder, names);
}

void prepare_output_folder(const std::string& option, const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        throw common::InputError(
            fmt::format("{}: {} cannot be made: {}", option, folder.string(), error.message()));
    if (!common::is_writable_folder(folder))
        throw common::InputError(fmt::format("{}: {} cannot be written to", option, folder.string()));
}

void write_text(const fs::path& file, const std::string& text) {
    common::write_whole_file(file, std::as_bytes(std::span(text)));
}

}  // namespace bench
