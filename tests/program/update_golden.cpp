// Writes the golden images again, for intended changes. Inspect them before they are committed.
#include "common/core/input_error.h"
#include "tests/support/golden.h"

int main(int argc, char**) {
    if (argc > 1) {
        fmt::print(stderr, "update_golden: takes no arguments\n");
        return 2;
    }
    try {
        std::filesystem::create_directories(SHLMBENCH_GOLDEN_FOLDER);
        for (const std::string scene : golden::scenes)
            for (const std::string method : golden::methods) {
                const golden::fs::path file = golden::file_of(scene, method);
                common::write_exr(file, golden::render(scene, method, golden::seed),
                                  {{"shlmbench:scene", scene}, {"shlmbench:method", method}});
                fmt::print("{}\n", file.string());
            }
        return 0;
    } catch (const common::InputError& e) {
        fmt::print(stderr, "update_golden: {}\n", e.what());
        return 2;
    }
}
