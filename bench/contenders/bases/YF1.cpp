// Order 1 of the luminance, fitted over the hemisphere above the surface, with one colour.
#include "bench/contenders/light_map_store.h"
#include "shlm/basis/luminance_fit.h"

namespace bench {
namespace {

const RegisteredBasis registered(11, light_basis<shlm::LuminanceFit<1>, shlm::ShWeight::radiance>(
                                         "YF1",
                                         "order 1 of the luminance, fitted over the hemisphere, one colour",
                                         {"#7a5cc0", "h"}));

}  // namespace
}  // namespace bench
