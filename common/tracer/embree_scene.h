// Triangles in an Embree scene.
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

/// Is called for what rays hit, and may reject it.
using EmbreeFilter = void (*)(const RTCFilterFunctionNArguments* arguments);

/// Throws std::runtime_error if Embree does not start.
[[nodiscard]] EmbreeDevice start_embree();

/// Returns the widest instruction set that Embree uses on this machine: AVX-512, AVX2, AVX, SSE4.2 or NEON.
/// Hits differ between them in the last bits. On other machines, returns the size of its widest packets, such
/// as "packets of 4 rays".
[[nodiscard]] std::string instruction_set(RTCDeviceTy* device);

/// Builds Embree's acceleration structure; triangle i is its primitive i. Rays do not slip through shared
/// edges. Throws std::runtime_error if Embree fails.
[[nodiscard]] EmbreeScene make_embree_scene(RTCDeviceTy* device, std::span<const Vec3> position,
                                            std::span<const TriangleVertices> triangle,
                                            EmbreeFilter filter = nullptr);

}  // namespace common
