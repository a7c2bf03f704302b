// Order 2, fitted over the hemisphere above the surface.
#include "bench/contenders/light_map_store.h"
#include "shlm/basis/hemisphere_fit.h"

namespace bench {
namespace {

const RegisteredBasis registered(10, light_basis<shlm::HemisphereFit<2>, shlm::ShWeight::radiance>(
                                         "F2", "order 2, fitted over the hemisphere above the surface",
                                         {"#12306b", ">"}));

}  // namespace
}  // namespace bench
