// Order 2 of the luminance, with one colour.
#include "bench/contenders/light_map_store.h"
#include "shlm/basis/luminance_nine.h"

namespace bench {
namespace {

const RegisteredBasis registered(6, light_basis<shlm::LuminanceNine, shlm::ShWeight::radiance>(
                                        "YL2", "order 2 of the luminance, one colour", {"#b06cc4", "X"}));

}  // namespace
}  // namespace bench
