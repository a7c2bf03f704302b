#include "common/reference/bright_places.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "common/reference/light.h"
#include "common/scene/coverage.h"

namespace common::reference {
namespace {

/// The part, among those with these cumulative sums, that a number in [0, 1] falls into, and the position
/// within it.
struct Part {
    std::size_t number;
    double within;
};

Part part_at(std::span<const double> sums, double uniform) {
    const double target = uniform * sums.back();
    const auto found = std::upper_bound(sums.begin(), sums.end(), target);
    auto number = std::min(static_cast<std::size_t>(found - sums.begin()), sums.size() - 1);
    const auto before = [&](std::size_t i) { return i == 0 ? 0.0 : sums[i - 1]; };
    while (number > 0 && sums[number] == before(number)) --number;  // never choose a part of weight 0
    return {number, std::clamp((target - before(number)) / (sums[number] - before(number)), 0.0, 1.0)};
}

}  // namespace

BrightPlaces::BrightPlaces(int across, std::vector<double> cell) : across_(across), in_row_(std::move(cell)) {
    const auto width = static_cast<std::size_t>(across);
    double sum = 0;
    for (std::size_t row = 0; row < width; ++row) {
        const std::span<double> cells = std::span(in_row_).subspan(row * width, width);
        std::partial_sum(cells.begin(), cells.end(), cells.begin());
        of_rows_.push_back(sum += cells.back());
    }
}

std::array<double, 2> BrightPlaces::place(const std::array<double, 2>& uniform) const {
    const auto width = static_cast<std::size_t>(across_);
    const Part row = part_at(of_rows_, uniform[1]);
    const Part column = part_at(std::span(in_row_).subspan(row.number * width, width), uniform[0]);
    return {(static_cast<double>(column.number) + column.within) / across_,
            (static_cast<double>(row.number) + row.within) / across_};
}

double BrightPlaces::density(const std::array<double, 2>& place) const {
    const auto number = [&](double along) {
        return std::clamp(static_cast<int>(along * across_), 0, across_ - 1);
    };
    const int column = number(place[0]);
    const auto cell = static_cast<std::size_t>(number(place[1]) * across_ + column);
    const double emits = in_row_[cell] - (column == 0 ? 0.0 : in_row_[cell - 1]);
    return emits / of_rows_.back() * across_ * across_;
}

int cells_across(const Scene& scene, std::uint32_t triangle, int most) {
    const TextureUse& use = scene.material_of(triangle).emissive_texture;
    const Texture& texture = scene.texture[use.texture];
    const Vec2 corner = texcoord_at(scene, {triangle, 0, 0}, use);
    float texels = 1;
    for (const Vec2& edge : {texcoord_at(scene, {triangle, 1, 0}, use) - corner,
                             texcoord_at(scene, {triangle, 0, 1}, use) - corner})
        texels = std::max({texels, std::abs(edge.x) * static_cast<float>(texture.width()),
                           std::abs(edge.y) * static_cast<float>(texture.height())});
    return texels < static_cast<float>(most) ? static_cast<int>(std::ceil(texels)) : most;
}

std::vector<double> emission_grid(const Scene& scene, std::uint32_t triangle, int across) {
    constexpr int looks_across = 4;  // samples per cell
    std::vector<double> cell;
    for (int row = 0; row < across; ++row)
        for (int column = 0; column < across; ++column) {
            double sum = 0;
            for (int i = 0; i < looks_across * looks_across; ++i) {
                const std::array<double, 2> square = {
                    (column + (i % looks_across + 0.5) / looks_across) / across,
                    (row + (i / looks_across + 0.5) / looks_across) / across};
                const SurfaceId place = place_on(triangle, square);
                sum += mean_channel(emitted_radiance_at(scene, place)) *
                       static_cast<double>(coverage_at(scene, place));
            }
            cell.push_back(sum / (looks_across * looks_across));
        }
    return cell;
}

}  // namespace common::reference
