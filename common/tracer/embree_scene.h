// Triangles in a scene of Embree's.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "common/scene/scene.h"

struct RTCDeviceTy;
struct RTCSceneTy;
struct RTCFilterFunctionNArguments;

namespace common {

struct ReleaseEmbree {
    void operator()(RTCDeviceTy* device) const;
    void operator()(RTCSceneTy* scene) const;
};
using EmbreeDevice = std::unique_ptr<RTCDeviceTy, ReleaseEmbree>;
using EmbreeScene = std::unique_ptr<RTCSceneTy, ReleaseEmbree>;

/// Is shown what rays meet, and may refuse it.
using EmbreeFilter = void (*)(const RTCFilterFunctionNArguments* arguments);

/// Throws std::runtime_error where Embree does not start.
[[nodiscard]] EmbreeDevice start_embree();

/// The widest vectors that Embree uses on this machine: AVX-512, AVX2, AVX, SSE4.2 or NEON; its hits differ
/// between them in the last bits. Elsewhere the rays of its widest packets, such as "packets of 4 rays".
[[nodiscard]] std::string instruction_set(RTCDeviceTy* device);

/// Builds Embree's acceleration structure; triangle i is its primitive i. Rays do not slip through shared
/// edges. Throws std::runtime_error where Embree fails.
[[nodiscard]] EmbreeScene make_embree_scene(RTCDeviceTy* device, std::span<const Vec3> position,
                                            std::span<const TriangleVertices> triangle,
                                            EmbreeFilter filter = nullptr);

}  // namespace common
