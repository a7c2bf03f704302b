#include "bench/app/map_identity.h"

#include <fmt/format.h>

#include "common/scene/fingerprint.h"

namespace bench {
namespace {

const char* name_of(shlm::ShWeight weight) {
    switch (weight) {
        case shlm::ShWeight::flux:
            return "flux";
        case shlm::ShWeight::normalised:
            return "normalised";
        case shlm::ShWeight::radiance:
            break;
    }
    return "radiance";
}

}  // namespace

shlm::MapIdentity map_identity(const ShlmMethod& method, PreparedMethods& prepared,
                               const common::PhotonSource& source, std::uint64_t seed) {
    return {.scene = common::fingerprint(prepared.scene()),
            .model = fmt::format("L{}/{}", summed_order(method.basis), name_of(method.weight)),
            .texels_wanted = describe(PreparedMethods::texel_choice(method, prepared.settings())),
            .texels = prepared.texels_of(method).layout.texel_count(),
            .numbers = with_model(method, [](auto model) { return decltype(model)::summed; }),
            .quantum = shlm::Quantum(source.power()).exponents(),
            .seed = seed};
}

}  // namespace bench
