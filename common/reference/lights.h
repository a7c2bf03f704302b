// All lights of a scene that can be sampled, and which of them to sample for a receiver.
#pragma once

#include <span>
#include <vector>

#include "common/reference/direction_choice.h"
#include "common/reference/light.h"
#include "common/reference/receiver.h"

namespace common::reference {

/// All lights that can be sampled. The sky is not among them: rays that leave the scene find it.
class Lights {
  public:
    explicit Lights(const Scene& scene);

    [[nodiscard]] std::span<const Light> light() const { return light_; }

    /// Returns the index of the light that this triangle is, or -1.
    [[nodiscard]] std::int32_t of_triangle(std::uint32_t triangle) const { return of_triangle_[triangle]; }

    /// Bounds of the mirrors and glass through which light can arrive.
    [[nodiscard]] std::span<const SpecularBounds> specular() const { return specular_; }

    /// Returns whether surfaces between a light and a point may transmit some of its light.
    [[nodiscard]] bool see_through() const { return see_through_; }

    /// Cumulative power up to and including each light, W.
    [[nodiscard]] std::span<const double> cumulative_power() const { return cumulative_power_; }

  private:
    std::vector<Light> light_;
    std::vector<std::int32_t> of_triangle_;
    std::vector<double> cumulative_power_;
    std::vector<SpecularBounds> specular_;
    bool see_through_;
};

/// If there are more lights than this, they are chosen by their power alone.
inline constexpr std::size_t most_weighed_lights = 64;

/// Chooses a light for one receiver; `lights` must outlive it. Few lights are chosen in proportion to the
/// irradiance expected of each, many in proportion to their power.
class LightChoice {
  public:
    LightChoice(const Lights& lights, const Receiver& receiver);

    /// Returns a light for a uniform number in (0, 1); -1 if none reaches the receiver.
    [[nodiscard]] std::int32_t choose(double uniform) const;

    [[nodiscard]] double probability(std::int32_t light) const;

  private:
    [[nodiscard]] std::span<const double> cumulative() const {
        return by_power_.empty() ? std::span<const double>(weighed_).first(count_) : by_power_;
    }

    std::size_t count_;
    std::span<const double> by_power_;
    std::array<double, most_weighed_lights> weighed_;
};

}  // namespace common::reference
