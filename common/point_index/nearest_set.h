// Collectors of the points that a search finds: the k nearest, or all within a radius.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <span>

namespace common {

struct Neighbour {
    float distance_sq;
    std::uint32_t index;

    /// Orders by distance, then by index, so that every exact search finds the same set.
    friend auto operator<=>(const Neighbour&, const Neighbour&) = default;
};

/// Keeps the `storage.size()` nearest points strictly inside a radius, in a max-heap in the caller's storage.
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

    /// Returns the points found so far, in no particular order; if full, the farthest comes first.
    [[nodiscard]] std::span<const Neighbour> found() const { return storage_.first(count_); }

  private:
    /// Walks down from the root once, where pop and push would walk twice.
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

/// Calls `use(distance_sq, index)` for every point strictly inside a radius, in the order of the search.
template <class Use>
class AllWithin {
  public:
    AllWithin(float radius_sq, Use use) : radius_sq_(radius_sq), use_(use) {}

    void offer(float distance_sq, std::uint32_t index) {
        if (distance_sq < radius_sq_) use_(distance_sq, index);
    }

    [[nodiscard]] bool full() const { return true; }
    [[nodiscard]] float reach_sq() const { return radius_sq_; }

  private:
    float radius_sq_;
    Use use_;
};

/// The receiver of a search's points. The search skips points beyond the reach, which may shrink meanwhile.
template <class C>
concept PointCollector = requires(C& collector, float distance_sq, std::uint32_t index) {
    collector.offer(distance_sq, index);
    { collector.full() } -> std::same_as<bool>;
    { collector.reach_sq() } -> std::same_as<float>;
};

static_assert(PointCollector<NearestSet>);

/// Returns the squared distance as every index computes it, so that equal distances are equal to the last
/// bit.
template <class A, class B>
float distance_sq(const A& a, const B& b) {
    const float x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return x * x + y * y + z * z;
}

}  // namespace common
