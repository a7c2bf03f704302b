// Disjoint sets (union-find).
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace common {

/// Starts with each of the elements 0, 1, ... in a set of its own.
class JoinedSets {
  public:
    explicit JoinedSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

    void join(std::uint32_t a, std::uint32_t b) {
        a = lowest_with(a);
        b = lowest_with(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

    /// Returns the set of each element. Sets are numbered from 0 in the order of their lowest elements.
    [[nodiscard]] std::vector<std::uint32_t> numbers() {
        std::vector<std::uint32_t> number(parent_.size());
        std::uint32_t next = 0;
        for (std::uint32_t i = 0; i < parent_.size(); ++i) {
            const std::uint32_t lowest = lowest_with(i);
            number[i] = lowest == i ? next++ : number[lowest];
        }
        return number;
    }

  private:
    std::uint32_t lowest_with(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }

    std::vector<std::uint32_t> parent_;
};

}  // namespace common
