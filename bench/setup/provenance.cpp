#include "bench/setup/provenance.h"

#include <Imath/ImathConfig.h>
#include <OpenEXR/OpenEXRConfig.h>
#include <OpenImageIO/oiioversion.h>
#include <flann/config.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <oneapi/tbb/version.h>
#include <sys/stat.h>
#include <unistd.h>

#include <ctime>
#include <fstream>
#include <nanoflann.hpp>
#include <nlohmann/json.hpp>
#include <thread>

#include "bench/setup/build_info.h"
#include "bench/setup/commit.h"
#include "common/tracer/embree.h"
#include "common/tracer/embree_scene.h"

namespace bench {
namespace {

using Json = nlohmann::ordered_json;

std::string cpu_name() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "unknown";
}

std::string utc_text(std::time_t time) {
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(time));
}

/// Returns when the running program was built.
std::string build_time() {
    struct stat program {};
    return stat("/proc/self/exe", &program) == 0 ? utc_text(program.st_mtime) : "unknown";
}

Json libraries() {
    return {{"embree", RTC_VERSION_STRING},
            {"flann", FLANN_VERSION_},
            {"nanoflann", fmt::format("{:x}.{:x}.{:x}", NANOFLANN_VERSION >> 8, NANOFLANN_VERSION >> 4 & 0xf,
                                      NANOFLANN_VERSION & 0xf)},
            {"openimageio", OIIO_VERSION_STRING},
            {"openexr", OPENEXR_VERSION_STRING},
            {"imath", IMATH_VERSION_STRING},
            {"tbb", fmt::format("{}.{}", TBB_VERSION_MAJOR, TBB_VERSION_MINOR)},
            {"fmt", FMT_VERSION}};
}

}  // namespace

Json provenance() {
    return {{"machine", cpu_name()},
            {"instruction_set", common::instruction_set(common::start_embree().get())},
            {"cores", std::thread::hardware_concurrency()},
            {"memory_bytes", static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES)) *
                                 static_cast<std::size_t>(sysconf(_SC_PAGE_SIZE))},
            {"compiler", build_compiler},
            {"flags", build_flags},
            {"libraries", libraries()},
            {"commit", build_commit},
            {"built", build_time()},
            {"date", utc_text(std::time(nullptr))}};
}

std::map<std::string, std::string> provenance_notes() {
    std::map<std::string, std::string> notes;
    const Json facts = provenance();
    for (const auto& [key, value] : facts.items())
        notes["shlmbench:" + key] = value.is_string() ? value.get<std::string>() : value.dump();
    return notes;
}

}  // namespace bench
