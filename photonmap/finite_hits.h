// Stores the hits of a wave in consecutive rows, with all threads.
#pragma once

#include <oneapi/tbb/parallel_for.h>

#include <vector>

#include "common/tracer/hit_batch.h"

namespace photonmap {

/// Calls `make_room(count)` with the number of finite hits in the wave, then `store(row, batch, i)` for each
/// of them, on any thread. Rows 0, 1, ... are in the order of the hits, whatever the threads. Returns that
/// number.
template <class MakeRoom, class Store>
std::size_t store_finite_hits(std::span<const common::HitBatch> wave, MakeRoom make_room, Store store) {
    std::vector<std::size_t> begin(wave.size() + 1, 0);
    tbb::parallel_for(std::size_t{0}, wave.size(), [&](std::size_t b) {
        for (std::size_t i = 0; i < wave[b].size(); ++i) begin[b + 1] += common::is_finite(wave[b], i);
    });
    for (std::size_t b = 0; b < wave.size(); ++b) begin[b + 1] += begin[b];

    make_room(begin.back());
    tbb::parallel_for(std::size_t{0}, wave.size(), [&](std::size_t b) {
        std::size_t row = begin[b];
        for (std::size_t i = 0; i < wave[b].size(); ++i)
            if (common::is_finite(wave[b], i)) store(row++, wave[b], i);
    });
    return begin.back();
}

}  // namespace photonmap
