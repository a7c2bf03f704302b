// Harmonics of irradiance up to order 0.
#include "bench/contenders/light_map_store.h"

namespace bench {
namespace {

using enum shlm::ShWeight;

const RegisteredBasis registered(2, light_basis<shlm::Harmonics<0>, radiance, flux, normalised>(
                                        "L0", "order 0; normalised it is what a traditional light map keeps",
                                        {"#b59f10", "s"}));

}  // namespace
}  // namespace bench
