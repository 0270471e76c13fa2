#include "engine/probe_choice.h"

#include <algorithm>
#include <map>

namespace obby::engine {
namespace {

// Max probes of parts with the same listeners, if there are too many parts to probe all. More of
// them rarely show anything new.
constexpr uint32_t kMaxSameListeners = 100;

std::vector<bool> takenOf(const std::vector<Probe>& wanted, size_t max) {
  std::map<uint64_t, uint32_t> seen;
  std::vector<std::pair<uint32_t, size_t>> ranks;  // earlier parts with the same listeners
  for (size_t i = 0; i < wanted.size(); ++i) ranks.emplace_back(seen[wanted[i].listenerHash]++, i);
  std::sort(ranks.begin(), ranks.end());
  std::vector<bool> taken(wanted.size());
  for (size_t i = 0; i < max; ++i) {
    const auto& [rank, index] = ranks[i];
    taken[index] = rank < kMaxSameListeners || wanted[index].listenerHash == 0;
  }
  return taken;
}

}  // namespace

Choice choose(std::vector<Probe> wanted, size_t max) {
  Choice choice;
  if (wanted.size() <= max) {
    choice.probes = std::move(wanted);
    return choice;
  }
  const std::vector<bool> taken = takenOf(wanted, max);
  std::map<uint64_t, uint32_t> first;  // probe by listenerHash
  for (size_t i = 0; i < wanted.size(); ++i) {
    if (!taken[i]) continue;
    if (wanted[i].listenerHash != 0)
      first.emplace(wanted[i].listenerHash, uint32_t(choice.probes.size()));
    choice.probes.push_back(wanted[i]);
  }
  for (size_t i = 0; i < wanted.size(); ++i) {
    if (taken[i]) continue;
    const auto found = first.find(wanted[i].listenerHash);
    if (found != first.end())
      choice.same.push_back({wanted[i].target, found->second});
    else
      choice.isAll = false;
  }
  return choice;
}

}  // namespace obby::engine
