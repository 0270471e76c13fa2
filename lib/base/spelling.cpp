#include "base/spelling.h"

#include <algorithm>
#include <numeric>

namespace obby {
namespace {

constexpr size_t kLongest = 100;  // bytes; who types more has not mistyped

size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), size_t(0));
  for (size_t i = 1; i <= a.size(); i++) {
    size_t diagonal = row[0];
    row[0] = i;
    for (size_t j = 1; j <= b.size(); j++) {
      const size_t change = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({change, row[j] + 1, row[j - 1] + 1});
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
  size_t least = std::max<size_t>(1, text.size() / 3) + 1;
  if (text.size() > kLongest) return best;
  for (const std::string& name : names) {
    if (name.size() >= text.size() + least) continue;  // however long it is
    const size_t distance = editDistance(text, name);
    if (distance < least) {
      least = distance;
      best = name;
    }
  }
  return best;
}

}  // namespace obby
