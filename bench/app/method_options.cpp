#include "bench/app/method_options.h"

namespace bench {

void MethodOptions::add_to(CLI::App& command) {
    command.add_option("--texels", texels, "SHLM: texels in all")->capture_default_str();
    command
        .add_option("--sh-weight", sh_weight, "SHLM: flux as the paper has it, or radiance, which is right")
        ->check(CLI::IsMember({"flux", "radiance"}))
        ->capture_default_str();
    command.add_option("--gather-texels", gather_texels, "SHLM: nearest texels per gather")
        ->capture_default_str();
    command.add_option("--k", k, "Photon map: nearest photons per gather")->capture_default_str();
    command
        .add_option("--max-radius", max_radius,
                    "Photon map: largest gather radius; 0: 1/20 of the scene's diagonal")
        ->capture_default_str();
    command.add_option("--cone", cone, "Photon map: slope of the cone filter, at least 1; 0: no filter")
        ->capture_default_str();
}

MethodSettings MethodOptions::settings() const {
    constexpr std::size_t most_neighbours = 100'000;
    if (k < 2 || k > most_neighbours)
        throw common::InputError("--k: from 2 to 100000; one photon has no density");
    if (gather_texels < 1 || gather_texels > most_neighbours)
        throw common::InputError("--gather-texels: from 1 to 100000");
    if (!(max_radius >= 0 && max_radius <= 1e9)) throw common::InputError("--max-radius: from 0 to 1e9");
    if (!(cone == 0 || (cone >= 1 && cone <= 1e9)))
        throw common::InputError("--cone: 0, or a slope from 1 to 1e9");
    MethodSettings settings;
    settings.photonmap = {k, static_cast<float>(max_radius), static_cast<float>(cone)};
    settings.shlm = {parse_count("--texels", texels),
                     sh_weight == "flux" ? shlm::ShWeight::flux : shlm::ShWeight::radiance, gather_texels};
    return settings;
}

}  // namespace bench
