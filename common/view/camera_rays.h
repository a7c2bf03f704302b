// Rays of a camera through its pixels.
#pragma once

#include "common/scene/scene.h"

namespace common {

/// Pinhole rays through pixel centres. Pixel (0, 0) is the top left one.
class CameraRays {
  public:
    CameraRays(const Camera& camera, int width, int height);

    /// Returns the unit direction from the eye through the centre of pixel (x, y).
    [[nodiscard]] Vec3 direction(int x, int y) const;

  private:
    Vec3 forward_, right_, up_;  ///< right and up span half the image plane at distance 1
    int width_, height_;
};

}  // namespace common
