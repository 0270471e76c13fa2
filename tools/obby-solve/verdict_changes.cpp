#include "verdict_changes.h"

#include <fmt/format.h>

#include <set>
#include <vector>

namespace obby::tools {

namespace {

constexpr size_t kShown = 5;

const char* wordFor(schema::Verdict verdict) {
  switch (verdict) {
    case schema::Verdict::SOLVED: return "solved";
    case schema::Verdict::UNREACHABLE: return "unreachable";
    case schema::Verdict::UNKNOWN: break;
  }
  return "unknown";
}

std::string listed(const std::vector<std::string>& changes) {
  std::string text;
  for (size_t i = 0; i < changes.size() && i < kShown; ++i) {
    text += (i > 0 ? ", " : "") + changes[i];
  }
  const size_t more = changes.size() > kShown ? changes.size() - kShown : 0;
  return more > 0 ? fmt::format("{}, and {} more", text, more) : text;
}

}  // namespace

void VerdictChanges::note(const std::string& level, const std::string& query,
                          schema::Verdict verdict) {
  now_[{level, query}] = verdict;
}

std::string VerdictChanges::finish() {
  std::set<std::string> levels;
  for (const Verdicts* run : {&before_, &now_}) {
    for (const auto& [key, verdict] : *run) levels.insert(key.first);
  }
  const auto nameOf = [&](const std::pair<std::string, std::string>& key) {
    const std::string name = levels.size() > 1 ? key.first + "/" + key.second : key.second;
    return "query '" + name + "'";
  };
  std::vector<std::string> changes;
  for (const auto& [key, verdict] : now_) {
    const auto old = before_.find(key);
    if (old != before_.end() && old->second == verdict) continue;
    changes.push_back(fmt::format("{} is {} {}", nameOf(key), old == before_.end() ? "new:" : "now",
                                  wordFor(verdict)));
  }
  for (const auto& [key, verdict] : before_) {
    if (!now_.contains(key)) changes.push_back(nameOf(key) + " was removed");
  }
  before_ = std::move(now_);
  now_.clear();
  return changes.empty() ? "no verdict changed" : listed(changes);
}

}  // namespace obby::tools
