#include "gen/recipe.h"

#include <charconv>

#include "io/text.h"
#include "math/lanes.h"

namespace obby::gen {

const std::vector<NamedNumber>& namedDifficulties() {
  static const std::vector<NamedNumber> table = {
      {"trivial", 0}, {"easy", 0.25f}, {"medium", 0.5f}, {"hard", 0.75f}, {"limit", 1}};
  return table;
}

const std::string& nameOfDifficulty(float value) {
  const NamedNumber* best = &namedDifficulties().front();
  for (const NamedNumber& d : namedDifficulties()) {
    if (absf(d.value - value) < absf(best->value - value)) best = &d;
  }
  return best->name;
}

Result<float> parseDifficulty(std::string_view text) {
  for (const NamedNumber& d : namedDifficulties()) {
    if (d.name == text) return d.value;
  }
  float value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc() && end == text.data() + text.size() && value >= 0 && value <= 1) {
    return value;
  }
  return makeError("expected trivial, easy, medium, hard, limit or a number from 0 to 1, found " +
                   io::quoted(text));
}

}  // namespace obby::gen
