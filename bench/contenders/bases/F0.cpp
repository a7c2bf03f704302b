// Order 0, fitted over the hemisphere above the surface.
#include "bench/contenders/light_map_store.h"
#include "shlm/basis/hemisphere_fit.h"

namespace bench {
namespace {

const RegisteredBasis registered(8, light_basis<shlm::HemisphereFit<0>, shlm::ShWeight::flux>(
                                        "F0", "the surface's irradiance, as uniform light from above",
                                        {"#2a7f9e", "p"}));

}  // namespace
}  // namespace bench
