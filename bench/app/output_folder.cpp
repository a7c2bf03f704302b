#include "bench/app/output_folder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>

#include "common/core/input_error.h"
#include "common/core/output_file.h"

namespace bench {

namespace fs = std::filesystem;

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
    const fs::path temporary = file.string() + fmt::format(".{}.tmp", getpid());
    std::ofstream out(temporary, std::ios::binary);
    out << text;
    out.close();
    std::error_code error;
    if (out) fs::rename(temporary, file, error);
    if (!out || error) {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        throw common::InputError(fmt::format("{}: cannot be written", file.string()));
    }
}

}  // namespace bench
