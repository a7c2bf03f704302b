// The stores that one trace fills, each under its own clock.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "bench/app/methods.h"
#include "common/core/stopwatch.h"
#include "common/tracer/trace_photons.h"

namespace bench {

/// A finished map of any kind, as a study asks it.
struct StudyMap {
    Method method;
    std::function<common::Rgb(const common::SurfacePoint&)> irradiance;
    double build_seconds = 0;
    std::size_t bytes = 0;         ///< finished, with its index
    std::size_t insert_bytes = 0;  ///< the store while it took hits
    std::uint64_t hits_rejected = 0;
    double clamped_share = 0;  ///< of the stored flux, what the cosine's clamp took away; light maps only
};

/// What the map answers at each point, W/m^2. Uses all threads.
[[nodiscard]] std::vector<common::Rgb> ask(const StudyMap& map, std::span<const common::SurfacePoint> points);

/// Methods that one store serves.
using MethodGroup = std::vector<Method>;

/// Those that stand together and fill alike.
[[nodiscard]] std::vector<MethodGroup> groups_of(const std::vector<Method>& methods);

/// A store that may serve several methods.
class StudyStore {
  public:
    StudyStore() = default;

    /// `methods` fill alike; `prepared` must outlive the store and its maps.
    StudyStore(std::vector<Method> methods, PreparedMethods& prepared, const common::PhotonSource& source);

    void consume(std::span<const common::HitBatch> wave) {
        const common::Stopwatch watch;
        consume_(wave);
        insert_seconds_ += watch.seconds();
    }

    /// Seconds spent on making room and on taking hits.
    [[nodiscard]] double insert_seconds() const { return insert_seconds_; }

    /// Calls `use` with the map of each method, one after the other. The store is used up.
    void finish(const common::TraceReport& trace, const std::function<void(const StudyMap&)>& use) {
        finish_(trace, use);
    }

  private:
    std::function<void(std::span<const common::HitBatch>)> consume_;
    std::function<void(const common::TraceReport&, const std::function<void(const StudyMap&)>&)> finish_;
    double insert_seconds_ = 0;
};

/// Gives every wave to all stores.
class StudySink {
  public:
    explicit StudySink(std::vector<StudyStore>& stores) : stores_(&stores) {}
    void consume(std::span<const common::HitBatch> wave) {
        for (StudyStore& store : *stores_) store.consume(wave);
    }

  private:
    std::vector<StudyStore>* stores_;
};

static_assert(common::PhotonSink<StudySink>);

}  // namespace bench
