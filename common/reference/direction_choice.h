// Sampling of directions at a diffuse surface.
#pragma once

#include <array>
#include <span>

#include "common/reference/receiver.h"

namespace common::reference {

/// A bounding sphere of an object that mirrors or refracts.
struct SpecularBounds {
    Imath::V3d center;
    double radius;  ///< world units
};

/// Returns one sphere around each mesh instance of mirrors or glass.
[[nodiscard]] std::vector<SpecularBounds> specular_bounds(const Scene& scene);

/// Samples cosine-weighted directions, but aims half of them at the specular objects of a scene that has any.
/// Only through these can a path hit a small light by chance, and such paths carry most of the noise.
class DirectionChoice {
  public:
    /// `bounds` must outlive the choice. Objects whose sphere contains the receiver are not aimed at.
    DirectionChoice(std::span<const SpecularBounds> bounds, const Receiver& receiver)
        : bounds_(bounds), receiver_(receiver) {}

    /// Returns a unit direction for uniform numbers in (0, 1).
    [[nodiscard]] Vec3 choose(const std::array<double, 2>& square) const;

    /// Returns the density of choosing the unit direction `towards`, per solid angle.
    [[nodiscard]] double density(const Vec3& towards) const;

  private:
    std::span<const SpecularBounds> bounds_;
    Receiver receiver_;
};

}  // namespace common::reference
