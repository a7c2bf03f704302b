// Stores the sums of one model, and makes the entries of bases: for the bases' files.
#pragma once

#include <tuple>
#include <type_traits>

#include "bench/contenders/light_map.h"
#include "shlm/file/checkpoint.h"
#include "shlm/map/sink.h"

namespace bench {

template <class Model>
class SumsStore final : public LightMapStore {
  public:
    SumsStore(const shlm::PreparedTexels& texels, const shlm::Quantum& quantum)
        : sink_(texels, shlm::OwnTexel{}, quantum) {}

    void consume(std::span<const common::HitBatch> wave) override { sink_.consume(wave); }
    void add(const common::HitBatch& hits) override { sink_.add(hits); }

    StoreFacts facts() const override {
        return {sink_.bytes(), sink_.rejected(), sink_.accumulator().clamped().discarded_share()};
    }

    shlm::MapRun read(const std::filesystem::path& file, const shlm::MapIdentity& expected,
                      const shlm::TexelAtlas& atlas) override {
        return shlm::read_checkpoint(file, expected, atlas, sink_.accumulator());
    }
    void write(const std::filesystem::path& file, const shlm::MapRun& run,
               const shlm::TexelAtlas& atlas) const override {
        shlm::write_checkpoint(file, run, atlas, sink_.accumulator());
    }

    std::uint64_t hits(std::size_t texel) const override { return sink_.accumulator().sums().hits(texel); }

    [[nodiscard]] const shlm::Sink<Model>& sink() const { return sink_; }

  private:
    shlm::Sink<Model> sink_;
};

/// Calls `work` with an object of the model that has this weight, which must be one of `Weights`.
template <int Order, shlm::ShWeight... Weights, class Work>
auto with_model(shlm::ShWeight weight, const Work& work) {
    using First = shlm::TexelModel<Order, std::get<0>(std::tuple{Weights...})>;
    std::invoke_result_t<Work, First> result{};
    (void)((weight == Weights && (result = work(shlm::TexelModel<Order, Weights>{}), true)) || ...);
    return result;
}

template <shlm::Basis Kept, class Model>
[[nodiscard]] StoredTexels stored_texels(const shlm::Sink<Model>& sink, float watts_per_flux,
                                         std::uint64_t least_hits) {
    const auto map = sink.template finish<Kept, shlm::half>(watts_per_flux, shlm::OwnTexel{}, least_hits);
    StoredTexels stored{shlm::number_count<Kept>, Kept::light_numbers, map.unit(), {}, {}, {}, {}};
    for (std::size_t i = 0; i < map.texels().size(); ++i) {
        const auto& texel = map.texels()[i];
        const shlm::TexelFace face = texel.face.unpacked();
        stored.number.insert(stored.number.end(), texel.stored.begin(), texel.stored.end());
        stored.face.push_back(face);
        stored.own.push_back(texel.irradiance(face.normal) * map.unit());
        stored.hits.push_back(sink.accumulator().sums().hits(i));
    }
    return stored;
}

/// Makes the entry of a basis with these weights; the first is the default.
template <shlm::Basis Kept, shlm::ShWeight... Weights>
[[nodiscard]] LightBasis light_basis(const std::string& name, const std::string& purpose,
                                     const ChartStyle& style) {
    using shlm::ShWeight;
    LightBasis basis{};
    basis.name = name;
    basis.purpose = purpose;
    basis.style = style;
    basis.order = Kept::order;
    basis.weights = {Weights...};
    basis.number_name = &Kept::number_name;
    basis.formula = Kept::formula;
    basis.texel_bytes = sizeof(shlm::Texel<shlm::Harmonics<Kept::order>>);
    basis.make_store = [](ShWeight weight, const shlm::PreparedTexels& texels, const shlm::Quantum& quantum) {
        return with_model<Kept::order, Weights...>(weight, [&](auto model) -> std::unique_ptr<LightMapStore> {
            return std::make_unique<SumsStore<decltype(model)>>(texels, quantum);
        });
    };
    basis.numbers = [](ShWeight weight) {
        return with_model<Kept::order, Weights...>(
            weight, [](auto model) -> std::size_t { return decltype(model)::summed; });
    };
    basis.sum_bytes = [](ShWeight weight) {
        return with_model<Kept::order, Weights...>(
            weight, [](auto model) { return shlm::TexelSums<decltype(model)>::bytes_per_texel(); });
    };
    basis.finish = [](const LightMapStore& store, ShWeight weight, float scale, const MapForm& form) {
        return with_model<Kept::order, Weights...>(weight, [&](auto model) -> std::unique_ptr<const Answers> {
            const auto& sink = static_cast<const SumsStore<decltype(model)>&>(store).sink();
            if (form.in_halves)
                return answers_of(
                    sink.template finish<Kept, shlm::half>(scale, form.gather, form.least_hits));
            return answers_of(sink.template finish<Kept>(scale, form.gather, form.least_hits));
        });
    };
    basis.texels = [](const LightMapStore& store, ShWeight weight, float scale, std::uint64_t least_hits) {
        return with_model<Kept::order, Weights...>(weight, [&](auto model) {
            const auto& sink = static_cast<const SumsStore<decltype(model)>&>(store).sink();
            return stored_texels<Kept>(sink, scale, least_hits);
        });
    };
    return basis;
}

}  // namespace bench
