// The four-coefficient basis of the hemisphere.
#include "bench/contenders/light_map_store.h"
#include "shlm/basis/hemisphere_four.h"

namespace bench {
namespace {

const RegisteredBasis registered(
    5, light_basis<shlm::HemisphereFour, shlm::ShWeight::radiance>(
           "H4", "four numbers of a hemisphere's basis, fitted to order 2 (Habel and Wimmer 2010)",
           {"#8a5a00", "P"}));

}  // namespace
}  // namespace bench
