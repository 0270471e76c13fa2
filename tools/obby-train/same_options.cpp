#include "same_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include "command.h"
#include "io/version.h"

namespace obby::tools {

namespace {

// What each rank may be told for itself. All else must be alike, also what only the first rank
// heeds, as its files: what others are told of that would be passed over.
constexpr std::string_view kOwn[] = {
    "threads",   // machines have more or fewer cores, and it does not show in what is learned
    "config",    // what it says is compared, wherever it stands
    "progress",  // this and the rest: how to speak, not what to do
    "quiet",    "verbose", "no-color", "json-errors",
};

bool isOwn(const std::string& name) {
  return std::find(std::begin(kOwn), std::end(kOwn), name) != std::end(kOwn);
}

std::string saidOf(const std::string& name, const cli::Arguments::Value& value) {
  const std::string words = asTyped(name, value);
  return words.empty() ? "without --" + name : "with " + words;
}

// `firsts`: what was said to rank 0, with a 0 behind each.
Status sameAs(std::string_view firsts, const std::vector<std::string>& said) {
  for (const std::string& mine : said) {
    const std::string_view other = firsts.substr(0, firsts.find('\0'));
    if (mine != other)
      return makeError(fmt::format("started {}, but rank 0 {}", mine, other),
                       "give all ranks the same options and files");
    firsts.remove_prefix(std::min(other.size() + 1, firsts.size()));
  }
  return {};
}

}  // namespace

Status sameOnAll(const std::vector<std::string>& said, train::Ranks& ranks) {
  std::string mine;
  for (const std::string& one : said) mine.append(one).push_back('\0');
  const std::string firsts = ranks.share(mine);
  return ranks.agree(mine == firsts ? Status() : sameAs(firsts, said));
}

Status sameOptions(const cli::Arguments& a, train::Ranks& ranks) {
  std::vector<std::string> said = {"to train or evaluate",
                                   fmt::format("as version {}", io::toolVersion())};
  for (const auto& [name, value] : a.values)
    if (!isOwn(name)) said.push_back(saidOf(name, value));
  said.push_back(fmt::format("with {} input{}", a.inputs.size(), a.inputs.size() == 1 ? "" : "s"));
  for (const std::string& input : a.inputs) said.push_back("with the input " + wordOf(input));
  return sameOnAll(said, ranks);
}

Status noOptions(bool refused, train::Ranks& ranks) {
  return sameOnAll(
      {refused ? "with options that it refused" : "only to print help or other information"},
      ranks);
}

}  // namespace obby::tools
