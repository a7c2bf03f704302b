#include "common/tracer/photon_batch.h"

namespace common {
namespace {

template <class T>
void gather(std::vector<T>& to, const std::vector<T>& from, std::span<const std::uint32_t> order) {
    T* const out = to.data();
    const T* const in = from.data();
    const std::uint32_t* const index = order.data();
    for (std::size_t i = 0; i < order.size(); ++i) out[i] = in[index[i]];
}

void gather(Vec3Array& to, const Vec3Array& from, std::span<const std::uint32_t> order) {
    gather(to.x, from.x, order);
    gather(to.y, from.y, order);
    gather(to.z, from.z, order);
}

}  // namespace

void PhotonBatch::gather(const PhotonBatch& from, std::span<const std::uint32_t> order) {
    resize(order.size());
    common::gather(number, from.number, order);
    common::gather(origin, from.origin, order);
    common::gather(direction, from.direction, order);
    common::gather(flux, from.flux, order);
}

}  // namespace common
