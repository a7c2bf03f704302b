// Registries that fill themselves before main begins.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <utility>

namespace bench {

/// Adds an entry. Ends the program where the key is taken, as a copied file's is: else one of the two would
/// be missing, which one being the linker's choice.
template <class Map, class Entry>
void register_once(Map& registry, const typename Map::key_type& key, Entry&& entry) {
    if (registry.emplace(key, std::forward<Entry>(entry)).second) return;
    std::fputs("shlmbench: two entries of a registry have the same place or name\n", stderr);
    std::abort();
}

}  // namespace bench
