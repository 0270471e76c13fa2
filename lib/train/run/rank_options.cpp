#include "train/run/rank_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "io/version.h"

namespace obby::train {

namespace {

// `expected`: the options of rank 0, each followed by a zero byte.
Status compareOptions(std::string_view expected, const std::vector<std::string>& options) {
  for (const std::string& mine : options) {
    const std::string_view other = expected.substr(0, expected.find('\0'));
    if (mine != other)
      return makeError(fmt::format("started {}, but rank 0 {}", mine, other),
                       "give all ranks the same options and files");
    expected.remove_prefix(std::min(other.size() + 1, expected.size()));
  }
  return {};
}

}  // namespace

Status sameOnAllRanks(const std::vector<std::string>& options, Ranks& ranks) {
  std::string mine;
  for (const std::string& option : options) mine.append(option).push_back('\0');
  const std::string expected = ranks.share(mine);
  return ranks.agree(mine == expected ? Status() : compareOptions(expected, options));
}

Status sameOptions(std::vector<std::string> options, Ranks& ranks) {
  options.insert(options.begin(),
                 {"to train or evaluate", fmt::format("as version {}", io::toolVersion())});
  return sameOnAllRanks(options, ranks);
}

Status notRunning(bool refused, Ranks& ranks) {
  return sameOnAllRanks(
      {refused ? "with options that it refused" : "only to print help or other information"},
      ranks);
}

}  // namespace obby::train
