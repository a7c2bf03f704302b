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
    without_light  ///< not sent: its light is dark where it would have started
};

struct TracedBlock {
    HitBatch hits;  ///< by event number; within an event in the order in which they were traced
    std::vector<PhotonFate> fate;  ///< one per photon

    /// Leaves out what comes before photon `first` and from photon `end` on, counted from the block's first.
    void keep_photons(std::uint64_t first, std::uint64_t end);

    /// The number of the photon after the one that, from photon `first` on, makes it `hits` hits;
    /// photons_per_block where none does.
    [[nodiscard]] std::uint64_t photons_with(std::uint64_t hits, std::uint64_t first) const;
};

/// Traces whole blocks of one run. For one thread: keeps the arrays that it works in.
class BlockTracer {
  public:
    /// Both must outlive the tracer.
    BlockTracer(const RayScene& rays, const PhotonSource& source, std::uint64_t seed);

    /// Block b has the run's photons b * photons_per_block and on. What happens to a photon does not depend
    /// on the others.
    void trace(std::uint64_t block, TracedBlock& traced);

  private:
    void drop_dark(TracedBlock& traced);
    void drop_covered(std::uint64_t first_photon);
    void drop_escaped(std::uint32_t event, TracedBlock& traced);
    void find_arrivals();
    void look_up_textures();
    void look_up_vertex_colors();
    void record_hits(HitBatch& hits);
    void reflect_diffuse(std::uint64_t first_photon, std::uint32_t event);
    void scatter_others(std::uint64_t first_photon, std::uint32_t event);

    const RayScene* rays_;
    const PhotonSource* source_;
    std::uint64_t seed_;

    PhotonOrder order_;
    PhotonBatch photons_;                  ///< under way to their next surface
    NearestSurfaces met_;                  ///< which surface that is
    Vec3Array position_;                   ///< where they meet it
    Vec3Array normal_;                     ///< of the side that they meet, unit
    Vec3Array base_color_;                 ///< of what they meet
    std::vector<std::uint32_t> stores_;    ///< whether it stores hits, 0 or 1
    std::vector<std::uint32_t> textured_;  ///< those that meet a texture
    std::vector<std::uint32_t> colored_;   ///< those that meet vertex colours
    std::vector<std::uint32_t> others_;    ///< those that meet a mirror, glass, or what has holes
    PhotonBatch reflected_;                ///< as they leave it again
    std::vector<std::uint32_t> survived_;  ///< whether they do, 0 or 1
};

}  // namespace common
