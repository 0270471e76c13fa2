#include "solve/improve/preference.h"

#include <algorithm>

namespace obby::solve {

namespace {

constexpr Preference kPreferences[] = {
    {"natural",
     "as a player would go: quick, with few jumps, turns and key changes, and not along "
     "edges",
     {1, 0.3f, 0.15f, 0.04f, 1.5f, 1, 1, 0.4f}},
    {"fast", "the shortest time", {1, 0.01f, 0.002f, 0.001f, 0, 0, 0, 0}},
    {"safe", "far from parts that kill and from edges", {1, 0.6f, 0.1f, 0.04f, 6, 4, 4, 1.5f}},
    {"few-jumps",
     "as few jumps as possible, then as natural",
     {1, 8, 0.1f, 0.04f, 1.5f, 1, 1, 0.4f}},
};

}  // namespace

std::span<const Preference> preferences() { return kPreferences; }

const Preference* findPreference(std::string_view name) {
  const auto found = std::ranges::find(kPreferences, name, &Preference::name);
  return found == std::end(kPreferences) ? nullptr : found;
}

}  // namespace obby::solve
