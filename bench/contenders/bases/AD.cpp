// An ambient term and one direction.
#include "bench/contenders/light_map_store.h"
#include "shlm/basis/ambient_and_direction.h"

namespace bench {
namespace {

const RegisteredBasis registered(7,
                                 light_basis<shlm::AmbientAndDirection, shlm::ShWeight::radiance>(
                                     "AD", "ambient and one direction, fitted to order 1", {"#3c7d5a", "d"}));

}  // namespace
}  // namespace bench
