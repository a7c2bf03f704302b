// Harmonics of irradiance up to order 1.
#include "bench/contenders/light_map_store.h"

namespace bench {
namespace {

using enum shlm::ShWeight;

const RegisteredBasis registered(3, light_basis<shlm::Harmonics<1>, radiance, flux, normalised>(
                                        "L1", "harmonics of order 1", {"#ef7d4f", "v"}));

}  // namespace
}  // namespace bench
