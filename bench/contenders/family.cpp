#include "bench/contenders/family.h"

namespace bench {
namespace {

std::map<std::string, Family>& families() {
    static std::map<std::string, Family> all;
    return all;
}

}  // namespace

const std::map<std::string, Family>& all_families() {
    return families();
}

RegisteredFamily::RegisteredFamily(const std::string& name, Family family) {
    families().emplace(name, std::move(family));
}

}  // namespace bench
