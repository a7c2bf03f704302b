// Order 1, fitted over the hemisphere above the surface.
#include "bench/contenders/light_map_store.h"
#include "shlm/basis/hemisphere_fit.h"

namespace bench {
namespace {

const RegisteredBasis registered(9, light_basis<shlm::HemisphereFit<1>, shlm::ShWeight::radiance>(
                                        "F1", "order 1, fitted over the hemisphere above the surface",
                                        {"#1f5fa8", "<"}));

}  // namespace
}  // namespace bench
