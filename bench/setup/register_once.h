// Registries that are filled before main begins.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <utility>

namespace bench {

/// Adds an entry. Aborts the program if the key is taken, as happens with a copied file: otherwise one of the
/// two would be missing, and the link order would decide which.
template <class Map, class Entry>
void register_once(Map& registry, const typename Map::key_type& key, Entry&& entry) {
    if (registry.emplace(key, std::forward<Entry>(entry)).second) return;
    std::fputs("shlmbench: two entries of a registry have the same place or name\n", stderr);
    std::abort();
}

}  // namespace bench
