// A finished map, whatever it is.
#pragma once

#include <memory>
#include <span>

#include "common/estimator/irradiance_estimator.h"

namespace bench {

/// Immutable. May be asked by any number of threads.
class Answers {
  public:
    virtual ~Answers() = default;

    /// Irradiance for the points' shading normals, W/m^2; `answers` has a place for each point.
    virtual void irradiance(std::span<const common::SurfacePoint> points,
                            std::span<common::Rgb> answers) const = 0;

    /// Of the map with its index.
    [[nodiscard]] virtual std::size_t bytes() const = 0;
};

/// One call for many points costs nothing that can be measured beside asking the map itself.
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

/// All points, on the threads of the calling arena.
[[nodiscard]] std::vector<common::Rgb> ask(const Answers& map, std::span<const common::SurfacePoint> points);

}  // namespace bench
