// The k nearest of the points offered to it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

namespace common {

struct Neighbour {
    float distance_sq;
    std::uint32_t index;

    /// Nearer first; of equally near points the one with the lower index, so that every exact search finds
    /// the same set.
    friend auto operator<=>(const Neighbour&, const Neighbour&) = default;
};

/// Keeps the `storage.size()` nearest points strictly inside a radius. A max-heap in the caller's storage.
class NearestSet {
  public:
    NearestSet(std::span<Neighbour> storage, float radius_sq) : storage_(storage), radius_sq_(radius_sq) {}

    void offer(float distance_sq, std::uint32_t index) {
        const Neighbour candidate{distance_sq, index};
        if (!full()) {
            if (distance_sq >= radius_sq_) return;
            storage_[count_++] = candidate;
            if (full()) std::make_heap(storage_.begin(), storage_.end());
        } else if (candidate < storage_.front()) {
            replace_farthest(candidate);
        }
    }

    [[nodiscard]] bool full() const { return count_ == storage_.size(); }

    /// No point farther than this can enter; one at exactly this distance can, if its index is lower.
    [[nodiscard]] float reach_sq() const { return full() ? storage_.front().distance_sq : radius_sq_; }

    /// What has been found, in no particular order; where full, the farthest comes first.
    [[nodiscard]] std::span<const Neighbour> found() const { return storage_.first(count_); }

  private:
    /// One walk from the root down, where pop and push would be two.
    void replace_farthest(const Neighbour& candidate) {
        std::size_t hole = 0;
        for (std::size_t child; (child = 2 * hole + 1) < count_; hole = child) {
            if (child + 1 < count_ && storage_[child] < storage_[child + 1]) ++child;
            if (!(candidate < storage_[child])) break;
            storage_[hole] = storage_[child];
        }
        storage_[hole] = candidate;
    }

    std::span<Neighbour> storage_;
    float radius_sq_;
    std::size_t count_ = 0;
};

/// Squared distance as every index computes it, so that equal distances are equal to the last bit.
template <class A, class B>
float distance_sq(const A& a, const B& b) {
    const float x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return x * x + y * y + z * z;
}

}  // namespace common
