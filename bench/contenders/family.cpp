#include "bench/contenders/family.h"

#include "bench/setup/register_once.h"

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
    register_once(families(), name, std::move(family));
}

}  // namespace bench
