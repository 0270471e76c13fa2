#include "solve/players/player_result.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "solve/players/player_text.h"

namespace obby::solve {

namespace {

// Returns the first case whose verdict is the combined verdict.
const PlayerCase& decisive(const std::vector<PlayerCase>& cases) {
  const schema::Verdict verdict = verdictOf(cases);
  return *std::ranges::find_if(
      cases, [&](const PlayerCase& c) { return c.answer().getVerdict() == verdict; });
}

PlayerVerdict verdictOf(const PlayerCase& c) {
  return {c.player.body, c.rate, c.answer().getVerdict()};
}

std::string firstSentence(const std::string& text) {
  const size_t end = text.find(". ");
  return end == std::string::npos ? text : text.substr(0, end + 1);
}

void fillPlayers(schema::Result::Builder result, const std::vector<PlayerCase>& cases) {
  auto list = result.initPlayers(uint32_t(cases.size()));
  for (uint32_t i = 0; i < list.size(); ++i) {
    const auto answer = cases[i].answer();
    list[i].setBody(cases[i].player.body);
    list[i].setFrameRate(uint16_t(cases[i].rate));
    list[i].setVerdict(answer.getVerdict());
    list[i].setTicks(answer.getTicks());
    list[i].setJumps(answer.getJumps());
    list[i].setReason(firstSentence(answer.getReason().cStr()));
  }
}

std::string reasonOf(const std::vector<PlayerCase>& cases, const PlayersAsked& asked) {
  std::vector<PlayerVerdict> verdicts;
  for (const PlayerCase& c : cases) verdicts.push_back(verdictOf(c));
  const PlayerCase& base = decisive(cases);
  const std::string summary = asked.keys == PlayersKeys::own
                                  ? playersText(verdicts, asked.namesBodies)
                                  : sameKeysText(verdicts, asked.namesBodies);
  const std::string own = base.answer().getReason().cStr();
  if (cases.size() == 1) return summary + " " + own;
  std::string who = playerText(verdictOf(base), asked.namesBodies);
  who.front() = char(std::toupper(who.front()));
  return fmt::format("{} {}: {}", summary, who, own);
}

// Adds up the work and the solutions of all players.
void addUp(schema::Result::Builder result, const std::vector<PlayerCase>& cases) {
  uint64_t steps = 0, rounds = 0, cells = 0;
  uint32_t solutions = 0;
  float seconds = 0, compile = 0;
  for (const PlayerCase& c : cases) {
    const auto answer = c.answer();
    steps += answer.getSteps();
    rounds += answer.getRounds();
    cells += answer.getCells();
    solutions += uint32_t(c.solutions.size());
    seconds += answer.getTiming().getSeconds();
    compile += answer.getTiming().getCompile();
  }
  result.setSteps(steps);
  result.setRounds(rounds);
  result.setCells(cells);
  result.setSolutions(solutions);
  auto timing = result.getTiming();
  timing.setSeconds(seconds);
  timing.setCompile(compile);
  timing.setStepsPerSecond(double(steps) / std::max(double(seconds), 1e-9));
}

// A solution for all players holds only if each player's solution holds.
void fillDoubts(schema::Result::Builder result, const std::vector<PlayerCase>& cases) {
  const auto doubtful =
      std::ranges::find_if(cases, [](const PlayerCase& c) { return !c.answer().getHolds(); });
  if (result.getVerdict() != schema::Verdict::SOLVED || doubtful == cases.end()) return;
  result.setHolds(false);
  result.setDoubts(doubtful->answer().getDoubts());
}

}  // namespace

schema::Verdict verdictOf(const std::vector<PlayerCase>& cases) {
  const auto is = [](schema::Verdict verdict) {
    return [verdict](const PlayerCase& c) { return c.answer().getVerdict() == verdict; };
  };
  if (std::ranges::any_of(cases, is(schema::Verdict::UNREACHABLE))) {
    return schema::Verdict::UNREACHABLE;
  }
  const bool solved = std::ranges::all_of(cases, is(schema::Verdict::SOLVED));
  return solved ? schema::Verdict::SOLVED : schema::Verdict::UNKNOWN;
}

io::Record resultOf(const std::vector<PlayerCase>& cases, const PlayersAsked& asked) {
  const PlayerCase& base = decisive(cases);
  io::RecordBuilder record(base.result->reader());
  auto result = record.root().getResult();
  fillPlayers(result, cases);
  result.setReason(reasonOf(cases, asked));
  addUp(result, cases);
  fillDoubts(result, cases);
  result.setTicks(level::nextTickAtRate(result.getTicks(), base.rate, asked.levelRate));
  for (auto route : result.getRoutes()) {
    route.setTicks(level::nextTickAtRate(route.getTicks(), base.rate, asked.levelRate));
  }
  return io::Record(std::move(record));
}

}  // namespace obby::solve
