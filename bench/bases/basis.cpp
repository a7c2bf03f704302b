#include "bench/bases/basis.h"

namespace bench {
namespace {

template <int Order, shlm::ShWeight Weight>
Basis basis(const std::string& name) {
    using Model = shlm::TexelModel<Order, Weight>;
    return {name, Model::harmonics, &ask<Model>};
}

}  // namespace

std::vector<Basis> all_bases() {
    using enum shlm::ShWeight;
    return {basis<0, normalised>("L0/normalised"), basis<1, radiance>("L1/radiance"),
            basis<2, radiance>("L2/radiance"),     basis<4, radiance>("L4/radiance"),
            basis<2, normalised>("L2/normalised"), basis<2, flux>("L2/flux")};
}

}  // namespace bench
