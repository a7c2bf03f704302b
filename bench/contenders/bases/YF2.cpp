// Order 2 of the luminance, fitted over the hemisphere above the surface, with one colour.
#include "bench/contenders/light_map_store.h"
#include "shlm/basis/luminance_fit.h"

namespace bench {
namespace {

const RegisteredBasis registered(12, light_basis<shlm::LuminanceFit<2>, shlm::ShWeight::radiance>(
                                         "YF2",
                                         "order 2 of the luminance, fitted over the hemisphere, one colour",
                                         {"#4b2a8c", "H"}));

}  // namespace
}  // namespace bench
