#include "quality/best_known.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace obby::bench {

namespace {

constexpr const char* kHeader = "query\tticks\tjumps\tturnsBack\tchanges\tlength";

}  // namespace

Result<BestKnown> BestKnown::read(const std::string& path) {
  BestKnown known;
  std::ifstream file(path);
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    if (number == 1 && line == kHeader) continue;
    std::istringstream fields(line);
    std::string query;
    Quality q;
    if (!(fields >> query >> q.ticks >> q.jumps >> q.turnsBack >> q.changes >> q.length))
      return makeError(fmt::format("{}:{}: expected {} columns", path, number, 6));
    known.best_[query] = q;
  }
  return known;
}

Status BestKnown::write(const std::string& path) const {
  std::ofstream file(path);
  file << kHeader << '\n';
  for (const auto& [query, q] : best_) {
    file << fmt::format("{}\t{}\t{}\t{}\t{}\t{:.2f}\n", query, q.ticks, q.jumps, q.turnsBack,
                        q.changes, q.length);
  }
  file.close();
  if (!file) return makeError(path + ": cannot be written");
  return {};
}

void BestKnown::note(const std::string& query, const Quality& quality) {
  const auto [at, isNew] = best_.try_emplace(query, quality);
  if (isNew) return;
  for (double Quality::*field :
       {&Quality::ticks, &Quality::jumps, &Quality::turnsBack, &Quality::changes, &Quality::length})
    at->second.*field = std::min(at->second.*field, quality.*field);
}

}  // namespace obby::bench
