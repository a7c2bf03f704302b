// Light maps: the sums per texel, what a finished texel keeps of them, and how texels are gathered.
#pragma once

#include <any>
#include <filesystem>
#include <map>

#include "bench/contenders/contender.h"
#include "shlm/file/map_run.h"
#include "shlm/file/texel_atlas.h"
#include "shlm/map/light_map.h"
#include "shlm/sums/quantum.h"

namespace bench {

/// The sums of all texels, for any model.
class LightMapStore : public Store {
  public:
    bool takes_any_order() const override { return true; }

    /// Reads the sums of a file. Throws InputError like shlm::read_checkpoint.
    virtual shlm::MapRun read(const std::filesystem::path& file, const shlm::MapIdentity& expected,
                              const shlm::TexelAtlas& atlas) = 0;
    virtual void write(const std::filesystem::path& file, const shlm::MapRun& run,
                       const shlm::TexelAtlas& atlas) const = 0;

    /// Returns the hits on one texel of the layout.
    [[nodiscard]] virtual std::uint64_t hits(std::size_t texel) const = 0;

    /// Data that several maps of one store share; the technique knows its type.
    [[nodiscard]] std::any& shared() { return shared_; }

  private:
    std::any shared_;
};

/// The form of a finished map.
struct MapForm {
    shlm::Gather gather;
    std::uint64_t least_hits;
    bool in_halves;
};

/// All texels of a finished map of halves, in the layout's order.
struct StoredTexels {
    std::size_t numbers = 0, light_numbers = 0;  ///< per texel; the first of them are light
    float unit = 1;                              ///< W/m^2, of the numbers of light
    std::vector<shlm::half> number;              ///< texel by texel
    std::vector<shlm::TexelFace> face;           ///< as the map uses them
    std::vector<common::Rgb> own;                ///< irradiance of each texel's own normal, W/m^2
    std::vector<std::uint64_t> hits;             ///< on each texel itself
};

/// What a finished texel keeps.
struct LightBasis {
    std::string name, purpose;
    ChartStyle style;
    int order;                            ///< order of the harmonics in which its hits are summed
    std::vector<shlm::ShWeight> weights;  ///< the weights it allows; the first is the default
    std::unique_ptr<LightMapStore> (*make_store)(shlm::ShWeight weight, const shlm::PreparedTexels& texels,
                                                 const shlm::Quantum& quantum);
    std::unique_ptr<const Answers> (*finish)(const LightMapStore& store, shlm::ShWeight weight,
                                             float watts_per_flux, const MapForm& form);
    StoredTexels (*texels)(const LightMapStore& store, shlm::ShWeight weight, float watts_per_flux,
                           std::uint64_t least_hits);
    std::string (*number_name)(std::size_t number);   ///< shlm::Basis::number_name
    std::string formula;                              ///< shlm::Basis::formula
    std::size_t (*numbers)(shlm::ShWeight weight);    ///< that are summed per texel and channel
    std::size_t (*sum_bytes)(shlm::ShWeight weight);  ///< per texel, while it is filled
    std::size_t texel_bytes;                          ///< upper bound for the finished map, with floats
};

/// Returns all bases by their place in lists; the first is the default.
[[nodiscard]] const std::map<int, LightBasis>& light_bases();

/// Registers a basis until the program ends. The file of each basis (bases/) has one of these.
class RegisteredBasis {
  public:
    RegisteredBasis(int place, const LightBasis& basis);
};

/// The texels' positions and sums, which all kinds of light maps have.
struct TexelSetting {
    const LightBasis* basis;  ///< whose sums are kept
    shlm::ShWeight weight;
    shlm::Gather gather;
    std::optional<shlm::TexelPlacement> placement;  ///< none: as given by --texels
    std::size_t texels = 0;                         ///< 0: as given by --texels
};

class LightMapTechnique : public Technique {
  public:
    explicit LightMapTechnique(const TexelSetting& setting) : setting_(setting) {}

    [[nodiscard]] const TexelSetting& setting() const { return setting_; }
    [[nodiscard]] TexelChoice texel_choice(const ContenderSettings& settings) const;
    [[nodiscard]] const shlm::PreparedTexels& texels_of(PreparedScene& scene) const {
        return scene.texels(texel_choice(scene.settings()));
    }

    /// Returns the identity by which files of sums of the same run are recognised.
    [[nodiscard]] shlm::MapIdentity identity(PreparedScene& scene, const common::PhotonSource& source,
                                             std::uint64_t seed) const;
    [[nodiscard]] std::unique_ptr<LightMapStore> make_sums(PreparedScene& scene,
                                                           const common::PhotonSource& source) const;

    std::string store_key() const override;
    Preparation prepare(PreparedScene& scene) const override {
        const TexelChoice choice = texel_choice(scene.settings());
        return std::holds_alternative<shlm::NearestTexels>(setting_.gather)
                   ? scene.preparation_of_texel_tree(choice)
                   : scene.preparation_of_texels(choice);
    }
    std::size_t texel_count(PreparedScene& scene) const override {
        return texels_of(scene).layout.texel_count();
    }
    std::unique_ptr<Store> make_store(PreparedScene& scene,
                                      const common::PhotonSource& source) const override {
        return make_sums(scene, source);
    }

  protected:
    /// Returns the part of the name that describes the texels: the gather and what follows.
    [[nodiscard]] std::string texel_name() const;
    [[nodiscard]] nlohmann::ordered_json texel_fields() const;

  private:
    TexelSetting setting_;
};

/// Named shlm / BASIS / radiance flux normalised / own bilinear surfaceK knnK [/ uv face] [/ tTEXELS] [/
/// hHITS] [/ half].
class UniformLightMap final : public LightMapTechnique {
  public:
    UniformLightMap(const TexelSetting& setting, std::uint64_t least_hits, bool in_halves)
        : LightMapTechnique(setting), least_hits_(least_hits), in_halves_(in_halves) {}

    /// The texels of a block with fewer hits than this all show the same light (shlm::TexelBlocks).
    [[nodiscard]] std::uint64_t least_hits() const { return least_hits_; }

    std::string name() const override;
    nlohmann::ordered_json fields() const override;
    ChartStyle style() const override { return setting().basis->style; }
    double needed_bytes(const ContenderSettings& settings, std::uint64_t hits) const override;
    FinishedMap finish(Store& store, const common::TraceReport& trace) const override;

    /// What the map of halves keeps in each texel, whatever the gather.
    [[nodiscard]] StoredTexels texels(const LightMapStore& store, const common::TraceReport& trace) const {
        return setting().basis->texels(store, setting().weight, trace.watts_per_flux(), least_hits_);
    }

  private:
    std::uint64_t least_hits_;
    bool in_halves_;
};

[[nodiscard]] const char* name_of(shlm::ShWeight weight);

}  // namespace bench
