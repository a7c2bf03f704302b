#include "bench/experiments/stability/stability_case.h"

#include <map>

#include "bench/setup/register_once.h"

namespace bench::stability {
namespace {

std::map<int, StabilityCase>& registered_cases() {
    static std::map<int, StabilityCase> cases;
    return cases;
}

}  // namespace

RegisteredCase::RegisteredCase(int number, const StabilityCase& stability_case) {
    register_once(registered_cases(), number, stability_case);
}

std::vector<const StabilityCase*> stability_cases() {
    std::vector<const StabilityCase*> cases;
    for (const auto& [number, stability_case] : registered_cases()) cases.push_back(&stability_case);
    return cases;
}

}  // namespace bench::stability
