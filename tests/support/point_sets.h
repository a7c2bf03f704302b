// Point sets that are hard for indices, and exact answers to compare with.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <string>
#include <vector>

#include "common/point_index/point_index.h"

namespace tests {

inline constexpr float no_limit = std::numeric_limits<float>::infinity();

/// Returns sets of about `count` points, named by what makes them hard.
inline std::map<std::string, std::vector<common::Vec3>> hard_point_sets(std::size_t count, unsigned seed) {
    using common::Vec3;
    std::mt19937 engine(seed);
    std::uniform_real_distribution<float> uniform(-1, 1);
    std::map<std::string, std::vector<Vec3>> sets;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 p(uniform(engine), uniform(engine), uniform(engine));
        Vec3 on_box = p;
        on_box[static_cast<int>(engine() % 3)] = engine() % 2 ? 1.0f : -1.0f;
        auto& box = sets["the faces of a box, a tenth of them twice"];
        box.push_back(engine() % 10 == 0 && !box.empty() ? box[engine() % box.size()] : on_box);
        sets["one place"].push_back({1, 2, 3});
        sets["one plane"].push_back({p.x, 0.5f, p.z});
        sets["one line"].push_back({0.25f, p.y, -3});
        sets["a lattice: all distances tie"].push_back({static_cast<float>(engine() % 8),
                                                        static_cast<float>(engine() % 8),
                                                        static_cast<float>(engine() % 8)});
        sets["far from the origin"].push_back(on_box + Vec3(1000, -2000, 500));
        sets["a cluster and one far away"].push_back(i == 0 ? Vec3(1e6f, 1e6f, 1e6f) : p);
        sets["ever closer to a corner"].push_back(p * std::exp2(-static_cast<float>(i % 100)));
    }
    return sets;
}

/// Returns the exact result by sorting all points.
template <class Accept>
std::vector<common::Neighbour> sorted_nearest(std::span<const common::Vec3> points, const common::Vec3& query,
                                              std::size_t k, float radius_sq, Accept accept) {
    std::vector<common::Neighbour> all;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        const common::Vec3 d = query - points[i];
        const float distance_sq = d.x * d.x + d.y * d.y + d.z * d.z;
        if (distance_sq < radius_sq && accept(i)) all.push_back({distance_sq, i});
    }
    std::sort(all.begin(), all.end());
    if (all.size() > k) all.resize(k);
    return all;
}

template <class Index, class Accept>
std::vector<common::Neighbour> found_nearest(const Index& index, const common::Vec3& query, std::size_t k,
                                             float radius_sq, Accept accept) {
    std::vector<common::Neighbour> storage(k);
    common::NearestSet set(storage, radius_sq);
    index.search(query, set, accept);
    std::vector<common::Neighbour> found(set.found().begin(), set.found().end());
    std::sort(found.begin(), found.end());
    return found;
}

template <class Index, class Accept>
std::vector<common::Neighbour> found_within(const Index& index, const common::Vec3& query, float radius_sq,
                                            Accept accept) {
    std::vector<common::Neighbour> found;
    common::AllWithin all(radius_sq, [&](float distance_sq, std::uint32_t i) {
        found.push_back({distance_sq, i});
    });
    index.search(query, all, accept);
    std::sort(found.begin(), found.end());
    return found;
}

/// Compares searches for the k nearest, and for all points within `radius` and other radii. Queries are on
/// the points, beside them and outside.
template <class Index>
void expect_exact_sets(const Index& index, std::span<const common::Vec3> points, float radius, unsigned seed,
                       int queries) {
    using common::Vec3;
    std::mt19937 engine(seed);
    std::uniform_real_distribution<float> uniform(-1, 1);
    for (int q = 0; q < queries; ++q) {
        Vec3 query(2 * uniform(engine), 2 * uniform(engine), 2 * uniform(engine));
        if (!points.empty() && q % 4 != 0) query = points[engine() % points.size()];
        if (q % 4 == 2) query += Vec3(uniform(engine), uniform(engine), uniform(engine)) * radius;
        const std::size_t k = std::array<std::size_t, 5>{1, 2, 7, 50, 200}[engine() % 5];
        const float reach = radius * std::array{1.0f, 1.0f, 0.3f, 2.5f, no_limit}[engine() % 5];
        const std::uint32_t left_out = engine() % 2 ? 3 : 1'000'000'000;  // every third, or only the first
        const auto accept = [&](std::uint32_t p) { return p % left_out != 0; };
        SCOPED_TRACE(testing::Message() << "query " << q << ", k " << k << ", reach " << reach);
        ASSERT_EQ(found_nearest(index, query, k, reach * reach, accept),
                  sorted_nearest(points, query, k, reach * reach, accept));
        ASSERT_EQ(found_within(index, query, reach * reach, accept),
                  sorted_nearest(points, query, points.size(), reach * reach, accept));
    }
}

}  // namespace tests
