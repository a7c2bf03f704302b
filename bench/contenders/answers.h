// The interface of a finished map of any kind.
#pragma once

#include <memory>
#include <span>

#include "common/estimator/irradiance_estimator.h"

namespace bench {

/// Immutable. Any number of threads may ask it at once.
class Answers {
  public:
    virtual ~Answers() = default;

    /// Estimates the irradiance for the points' shading normals, W/m^2; `answers` has one element per point.
    virtual void irradiance(std::span<const common::SurfacePoint> points,
                            std::span<common::Rgb> answers) const = 0;

    /// Returns the bytes of the map and its index.
    [[nodiscard]] virtual std::size_t bytes() const = 0;
};

/// Adapts a map. One virtual call for many points has no measurable cost beside the gathers.
template <common::IrradianceEstimator Map>
class MapAnswers final : public Answers {
  public:
    explicit MapAnswers(Map map) : map_(std::move(map)) {}

    void irradiance(std::span<const common::SurfacePoint> points,
                    std::span<common::Rgb> answers) const override {
        for (std::size_t i = 0; i < points.size(); ++i) answers[i] = map_.irradiance(points[i]);
    }
    [[nodiscard]] std::size_t bytes() const override { return map_.bytes(); }

  private:
    Map map_;
};

template <common::IrradianceEstimator Map>
[[nodiscard]] std::unique_ptr<const Answers> answers_of(Map map) {
    return std::make_unique<const MapAnswers<Map>>(std::move(map));
}

/// Evaluates all points, on the threads of the calling arena.
[[nodiscard]] std::vector<common::Rgb> ask(const Answers& map, std::span<const common::SurfacePoint> points);

}  // namespace bench
