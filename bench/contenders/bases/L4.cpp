// Harmonics of irradiance up to order 4.
#include "bench/contenders/light_map_store.h"

namespace bench {
namespace {

using enum shlm::ShWeight;

const RegisteredBasis registered(4, light_basis<shlm::Harmonics<4>, radiance, flux, normalised>(
                                        "L4", "harmonics of order 4", {"#6d0f24", "D"}));

}  // namespace
}  // namespace bench
