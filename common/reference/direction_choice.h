// Which way to look from a diffuse surface.
#pragma once

#include <array>
#include <span>

#include "common/reference/receiver.h"

namespace common::reference {

/// Around something that mirrors or refracts.
struct SpecularBounds {
    Imath::V3d center;
    double radius;  ///< world units
};

/// One sphere around each mesh instance of mirrors or glass.
[[nodiscard]] std::vector<SpecularBounds> specular_bounds(const Scene& scene);

/// Cosine-weighted directions, half of them aimed at the specular things of a scene where it has any: only
/// by way of these can a small lamp be met by chance, and those paths carry most of the noise.
class DirectionChoice {
  public:
    /// `bounds` must outlive the choice. Things around the receiver itself are not aimed at.
    DirectionChoice(std::span<const SpecularBounds> bounds, const Receiver& receiver)
        : bounds_(bounds), receiver_(receiver) {}

    /// Unit direction for uniform numbers in (0, 1).
    [[nodiscard]] Vec3 choose(const std::array<double, 2>& square) const;

    /// Of choosing the unit direction `towards`, per solid angle.
    [[nodiscard]] double density(const Vec3& towards) const;

  private:
    std::span<const SpecularBounds> bounds_;
    Receiver receiver_;
};

}  // namespace common::reference
