#include "base/spelling.h"

#include <algorithm>
#include <numeric>

namespace obby {
namespace {

constexpr size_t kLongest = 100;  // bytes; longer text is not a mistyped name

// Returns the number of edits: bytes inserted, deleted or replaced, and neighbours swapped.
size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<size_t> before(b.size() + 1), above(b.size() + 1), row(b.size() + 1);
  std::iota(row.begin(), row.end(), size_t(0));
  for (size_t i = 1; i <= a.size(); i++) {
    before.swap(above);
    above.swap(row);
    row[0] = i;
    for (size_t j = 1; j <= b.size(); j++) {
      const size_t change = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({change, above[j] + 1, row[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row.back();
}

}  // namespace

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  return out;
}

std::string nearestName(std::string_view text, const std::vector<std::string>& names) {
  std::string best;
  size_t min = std::max<size_t>(1, text.size() / 3) + 1;
  if (text.size() > kLongest) return best;
  for (const std::string& name : names) {
    if (name.size() >= text.size() + min) continue;  // needs at least `min` insertions
    const size_t distance = editDistance(text, name);
    if (distance < min) {
      min = distance;
      best = name;
    }
  }
  return best;
}

}  // namespace obby
