// Harmonics of irradiance up to order 2.
#include "bench/contenders/light_map_store.h"

namespace bench {
namespace {

using enum shlm::ShWeight;

const RegisteredBasis registered(1, light_basis<shlm::Harmonics<2>, radiance, flux, normalised>(
                                        "L2", "harmonics of order 2, as in the paper", {"#cf2f2a", "^"}));

}  // namespace
}  // namespace bench
