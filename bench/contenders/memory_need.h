// Predicts the memory that a run will need.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "bench/contenders/contender.h"

namespace bench {

/// Returns an upper bound for the bytes that a contender holds at its peak, with the hits on their way to it
/// but without the scene.
[[nodiscard]] std::size_t needed_bytes(const Contender& contender, const ContenderSettings& settings,
                                       std::uint64_t hits);

/// Returns why a run of this size is impossible within `max_bytes`, as in "needs 67.1 GiB"; empty where it is
/// possible.
[[nodiscard]] std::string reason_to_skip(const Contender& contender, const ContenderSettings& settings,
                                         std::uint64_t hits, std::size_t max_bytes);

/// Throws InputError where a run of this size is impossible: "NAME: needs 67.1 GiB, 19.8 GiB are free for
/// it".
void require_memory(const Contender& contender, const ContenderSettings& settings, std::uint64_t hits,
                    std::size_t max_bytes);

/// Divides items, in their order, into batches that together need at most `max_bytes`. `needed` returns the
/// bytes that an item needs; one that needs more than all is a batch of its own.
template <class Item, class Needed>
[[nodiscard]] std::vector<std::vector<Item>> in_batches(std::vector<Item> items, std::size_t max_bytes,
                                                        Needed needed) {
    std::vector<std::vector<Item>> batches;
    std::size_t free = 0;
    for (Item& item : items) {
        const std::size_t bytes = needed(item);
        if (batches.empty() || bytes > free) {
            batches.emplace_back();
            free = max_bytes;
        }
        free -= std::min(bytes, free);
        batches.back().push_back(std::move(item));
    }
    return batches;
}

/// Returns nine tenths of the free memory of the machine.
[[nodiscard]] std::size_t default_max_bytes();

}  // namespace bench
