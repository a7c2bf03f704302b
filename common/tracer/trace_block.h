// The photons of one block, from emission to the end of their paths.
#pragma once

#include "common/tracer/hit_batch.h"
#include "common/tracer/photon_order.h"
#include "common/tracer/photon_source.h"
#include "common/tracer/ray_scene.h"

namespace common {

/// Photons traced together: enough for packets of rays that travel alike, few enough for their hits to stay
/// in a core's cache.
inline constexpr std::uint64_t photons_per_block = 4096;

enum class PhotonFate : std::uint8_t {
    missed,   ///< met no surface at all
    escaped,  ///< left the scene after meeting a surface
    absorbed,
    given_up,      ///< at PhotonSource::most_events
    without_light  ///< not sent: its light emits nothing where it would have started
};

/// Which arrivals are recorded. Direct ones are those of photons that come from their light straight, or
/// through holes and thin sheets; what mirrors and glass deflect is indirect.
enum class RecordedHits : std::uint8_t { all, indirect };

struct TracedBlock {
    HitBatch hits;  ///< sorted by event number; within an event in the order in which they were traced
    std::vector<PhotonFate> fate;  ///< one per photon

    /// Leaves out photons before `first` and from `end` on, counted from the block's first.
    void keep_photons(std::uint64_t first, std::uint64_t end);

    /// Returns the number of photons up to and including the one that, counted from photon `first` on,
    /// completes `hits` hits; photons_per_block if there are not so many.
    [[nodiscard]] std::uint64_t photons_with(std::uint64_t hits, std::uint64_t first) const;
};

/// Traces whole blocks of one run. Each thread needs its own, as it keeps its working arrays.
class BlockTracer {
  public:
    /// `rays` and `source` must outlive the tracer.
    BlockTracer(const RayScene& rays, const PhotonSource& source, std::uint64_t seed,
                RecordedHits recorded = RecordedHits::all);

    /// Traces block b: the run's photons from b * photons_per_block on. The path of a photon does not depend
    /// on the other photons.
    void trace(std::uint64_t block, TracedBlock& traced);

  private:
    void drop_dark(TracedBlock& traced);
    void drop_covered(std::uint64_t first_photon);
    void drop_escaped(std::uint32_t event, TracedBlock& traced);
    void find_arrivals();
    void look_up_textures();
    void look_up_vertex_colors();
    void leave_out_direct();
    void keep_direct();
    void record_hits(HitBatch& hits);
    void reflect_diffuse(std::uint64_t first_photon, std::uint32_t event);
    void scatter_others(std::uint64_t first_photon, std::uint32_t event);

    const RayScene* rays_;
    const PhotonSource* source_;
    std::uint64_t seed_;
    RecordedHits recorded_;

    PhotonOrder order_;
    PhotonBatch photons_;                       ///< on the way to their next surfaces
    NearestSurfaces met_;                       ///< these surfaces
    Vec3Array position_;                        ///< where the photons hit them
    Vec3Array normal_;                          ///< of the side that they hit, unit
    Vec3Array base_color_;                      ///< of the surfaces
    std::vector<std::uint32_t> stores_;         ///< whether the surface stores hits, 0 or 1
    std::vector<std::uint32_t> textured_;       ///< photons that hit a texture
    std::vector<std::uint32_t> colored_;        ///< photons that hit vertex colours
    std::vector<std::uint32_t> others_;         ///< photons that hit a mirror, glass, or a surface with holes
    PhotonBatch reflected_;                     ///< the photons after scattering
    std::vector<std::uint32_t> survived_;       ///< whether they survive, 0 or 1
    std::vector<std::uint32_t> went_straight_;  ///< numbers of photons that nothing deflected
    std::vector<bool> direct_;  ///< by number, whether nothing has deflected the photon yet; kept only for
                                ///< RecordedHits::indirect
};

}  // namespace common
