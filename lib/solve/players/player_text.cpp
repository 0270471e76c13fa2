#include "solve/players/player_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "base/listed.h"
#include "level/bodies.h"

namespace obby::solve {

namespace {

struct BodyRates {
  std::string body;
  std::vector<uint32_t> rates;
};

std::string titleOf(const std::string& name) {
  const level::Body* const body = level::findBody(name);
  return body != nullptr ? body->title : "the place's body";
}

std::string ratesText(const std::vector<uint32_t>& rates) {
  std::vector<std::string> words;
  for (const uint32_t rate : rates) words.push_back(fmt::format("{}", rate));
  return fmt::format("at {} frames a second", listed(words, "and"));
}

std::vector<BodyRates> byBody(const std::vector<PlayerVerdict>& players) {
  std::vector<BodyRates> groups;
  for (const PlayerVerdict& p : players) {
    auto group = std::ranges::find(groups, p.body, &BodyRates::body);
    if (group == groups.end()) group = groups.insert(group, {p.body, {}});
    group->rates.push_back(p.rate);
  }
  return groups;
}

// Returns text like " for R6 and R15 at 60 frames a second", with `preposition` in place of "for".
std::string groupText(const std::vector<PlayerVerdict>& players, bool namesBodies,
                      const char* preposition) {
  const std::vector<BodyRates> groups = byBody(players);
  const bool alike =
      std::ranges::all_of(groups, [&](const BodyRates& g) { return g.rates == groups[0].rates; });
  if (!namesBodies) return " " + ratesText(groups[0].rates);
  std::vector<std::string> words;
  for (const BodyRates& g : groups) {
    words.push_back(titleOf(g.body) + (alike ? std::string() : " " + ratesText(g.rates)));
  }
  std::string text = fmt::format(" {} {}", preposition, listed(words, "and"));
  if (alike) text += " " + ratesText(groups[0].rates);
  return text;
}

std::vector<PlayerVerdict> with(schema::Verdict verdict,
                                const std::vector<PlayerVerdict>& players) {
  std::vector<PlayerVerdict> result;
  std::ranges::copy_if(players, std::back_inserter(result),
                       [&](const PlayerVerdict& p) { return p.verdict == verdict; });
  return result;
}

}  // namespace

std::string playerText(const PlayerVerdict& player, bool namesBodies) {
  const std::string rate = ratesText({player.rate});
  return namesBodies ? titleOf(player.body) + " " + rate : rate;
}

std::string playersText(const std::vector<PlayerVerdict>& players, bool namesBodies) {
  struct Clause {
    schema::Verdict verdict;
    const char *start, *preposition;
  };
  constexpr Clause kClauses[] = {{schema::Verdict::SOLVED, "solved", "for"},
                                 {schema::Verdict::UNREACHABLE, "unreachable", "for"},
                                 {schema::Verdict::UNKNOWN, "no solution found", "for"}};
  std::string text;
  for (const Clause& clause : kClauses) {
    const auto group = with(clause.verdict, players);
    if (group.empty()) continue;
    if (!text.empty()) text += "; ";
    text += clause.start + groupText(group, namesBodies, clause.preposition);
  }
  text.front() = char(std::toupper(text.front()));
  return text + ".";
}

std::string sameKeysText(const std::vector<PlayerVerdict>& players, bool namesBodies) {
  const auto barred = with(schema::Verdict::UNREACHABLE, players);
  if (!barred.empty()) return "Unreachable" + groupText(barred, namesBodies, "for") + ".";
  const bool solved = players.front().verdict == schema::Verdict::SOLVED;
  return (solved ? "The same key presses solve it" : "No solution found") +
         groupText(players, namesBodies, "for") + (solved ? "." : " with the same key presses.");
}

}  // namespace obby::solve
