// The option table of obby-solve.
#include "options.h"

#include "cli/rows.h"

namespace obby::tools {

namespace {

using cli::between;
using cli::lettered;
using cli::OptionRow;
using cli::renewed;
using cli::repeatable;
using cli::row;
using cli::ValueType;

constexpr const char* kQueryGroup = "Asking on the command line";
constexpr const char* kSearchGroup = "Search";
constexpr const char* kAnsweredGroup = "Checking and choosing among answers (nothing is searched)";

OptionRow methodRow() {
  OptionRow r = row("method", ValueType::choice, "", "auto", "", kSearchGroup);
  r.help = "how to search:";
  for (const solve::Method& m : solve::methods()) {
    r.choices.push_back(m.name);
    r.help += std::string(r.choices.size() > 1 ? "; " : " ") + m.name + " = " + m.description;
  }
  return r;
}

OptionRow forbidRow() {
  OptionRow r = row("forbid", ValueType::choice, "", "", "never be in that state", kQueryGroup);
  r.choices = {"jumping", "climbing", "seated", "fallingDown"};
  return r;
}

OptionRow timeLimitRow() {
  OptionRow r = cli::withDefault(cli::commonRow(cli::Common::timeLimit), "20");
  r.help = "wall-clock time for each query, at most";
  r.group = kSearchGroup;
  return r;
}

OptionRow backendRow() {
  OptionRow r = cli::commonRow(cli::Common::backend);
  r.help =
      "where rollouts are simulated; the answers do not depend on it. auto is the CPU: the rounds "
      "of "
      "a search are small for a GPU";
  r.group = kSearchGroup;
  return r;
}

std::vector<OptionRow> searchRows() {
  return {
      timeLimitRow(),
      between(row("max-steps", ValueType::integer, "N", "",
                  "stop after about N simulated ticks a query: unlike --time-limit the same on "
                  "every machine",
                  kSearchGroup),
              1, 9e15),
      between(row("solutions", ValueType::integer, "K", "1", "look for K distinct solutions",
                  kSearchGroup),
              1, 1000),
      row("diverse", ValueType::flag, "", "",
          "of --solutions: differ in route, the parts stood on and in which order; one of each, "
          "with counts",
          kSearchGroup),
      between(row("attempts", ValueType::integer, "N", "24", "failed attempts to show a query",
                  kSearchGroup),
              0, 1000),
      row("difficulty", ValueType::flag, "", "",
          "say of each solution how hard it is to play, step by step", kSearchGroup),
      between(row("trials", ValueType::integer, "N", "1000",
                  "tries of each step by a player with noise, for --difficulty", kSearchGroup),
              1, 1000000),
      methodRow(),
      repeatable(row("query", ValueType::text, "ID", "", "answer, check or filter only this query",
                     kSearchGroup)),
      renewed(
          row("warm", ValueType::file, "FILE", "",
              "an earlier answer of these queries: its ways are tried first, and searched on from",
              kSearchGroup)),
      row("watch", ValueType::flag, "", "",
          "answer again whenever an input file changes, from where the last answer was; with -o "
          "the file is written anew, else streams follow one another",
          kSearchGroup),
      cli::commonRow(cli::Common::seed),
      cli::commonRow(cli::Common::threads),
      backendRow(),
      row("policy", ValueType::file, "FILE", "",
          "what auto, ge-ps and rl play by, from obby-train [default: the one that comes with the "
          "program]",
          kSearchGroup),
      row("final-only", ValueType::flag, "", "", "leave progress records out of the stream",
          kSearchGroup),
      row("paths", ValueType::flag, "", "",
          "write with each trajectory where the player is, for readers that cannot replay it",
          kSearchGroup),
      row("heat-map", ValueType::flag, "", "", "write with each result where the search has been",
          kSearchGroup),
      row("explain", ValueType::flag, "", "",
          "say of a query without a solution what single change makes it solvable; takes up to as "
          "long again",
          kSearchGroup),
      lettered(row("exit-status", ValueType::flag, "", "",
                   "exit with 1 if a query is unreachable, else with 3 if a verdict is unknown",
                   kSearchGroup),
               'e'),
  };
}

std::vector<OptionRow> answeredRows() {
  return {
      row("verify", ValueType::flag, "", "", "check the trajectories by replaying them",
          kAnsweredGroup),
      repeatable(row("pass", ValueType::text, "PLACE", "",
                     "keep only trajectories that pass here; of several places, all",
                     kAnsweredGroup)),
      repeatable(row("not-pass", ValueType::text, "PLACE", "",
                     "keep only trajectories that do not pass here", kAnsweredGroup)),
  };
}

}  // namespace

std::vector<OptionRow> queryRows() {
  return {
      row("start", ValueType::text, "PLACE", "",
          "start on this part or in this box [default: the level's first spawn]", kQueryGroup),
      repeatable(row("goal", ValueType::text, "PLACE", "",
                     "reach this part or box; of several, or of a #TAG's parts, any [default: the "
                     "level's goal part, else its last checkpoint]",
                     kQueryGroup)),
      repeatable(row("waypoint", ValueType::text, "PLACE", "",
                     "pass here first; several in their order", kQueryGroup)),
      repeatable(row("visit", ValueType::text, "PLACE", "",
                     "pass here first, several in any order; a #TAG means all its parts",
                     kQueryGroup)),
      repeatable(row("avoid", ValueType::text, "PLACE", "",
                     "never enter; a #TAG means all its parts", kQueryGroup)),
      between(row("max-jumps", ValueType::integer, "N", "", "jump at most N times", kQueryGroup), 0,
              65535),
      between(row("min-jumps", ValueType::integer, "N", "", "jump at least N times", kQueryGroup),
              0, 65535),
      between(row("max-time", ValueType::number, "SECONDS", "", "arrive within that game time",
                  kQueryGroup),
              0.02, 100000),
      between(row("max-damage", ValueType::number, "HEALTH", "",
                  "lose at most that much health, of 100", kQueryGroup),
              0, 1e6),
      repeatable(forbidRow()),
      row("each", ValueType::flag, "", "",
          "ask the stream's queries with these limits in place of their own, not a new query",
          kQueryGroup),
  };
}

cli::ToolSpec solveSpec() {
  cli::ToolSpec spec;
  spec.name = "obby-solve";
  spec.summary = "find playthroughs that answer the queries of a stream";
  spec.inputHelp = "streams with levels and queries";
  spec.tableAtTerminal = true;
  spec.examples = {
      {"answer all queries of a level", "obby-solve wedge-climb.jsonl -o wedge-climb.solved.jsonl"},
      {"from a place file to a page",
       "obby-import first-steps.rbxlx | obby-solve | obby-view -o report.html"},
      {"ask on the command line",
       "obby-solve several-routes.jsonl --goal Goal --max-jumps 9 --max-time 30"},
      {"all stages of a level, each without climbing and with at most nine jumps",
       "obby-solve --each --forbid climbing --max-jumps 9 several-routes.jsonl"},
      {"three different ways, for a script",
       "obby-solve -e --query any --solutions 3 several-routes.jsonl > ways.jsonl"},
      {"which moment of the way is the hardest?",
       "obby-solve --difficulty --query posts timed-jumps.jsonl | obby-view -o posts.html"},
      {"of many ways those over the beam, without the ramp",
       "obby-solve --query any --solutions 20 --diverse --max-steps 200000 several-routes.jsonl | "
       "obby-solve --pass touch:Beam --not-pass 'touch:Ramp up' > beam.jsonl"},
      {"check what somebody else found",
       "obby-solve wedge-climb.jsonl | obby-solve --verify > /dev/null"},
  };
  spec.options = {cli::commonRow(cli::Common::output), cli::commonRow(cli::Common::format),
                  cli::commonRow(cli::Common::progress), cli::commonRow(cli::Common::onError)};
  for (const auto& rows : {queryRows(), searchRows(), answeredRows()}) {
    spec.options.insert(spec.options.end(), rows.begin(), rows.end());
  }
  spec.notes =
      "A PLACE is a part's name, path or the end of its path, GUID, #TAG or part:INDEX, or a box "
      "x,y,z,sx,sy,sz (centre and size in studs); touch:PART means that the part itself is to be "
      "touched. A query asked on the command line is answered in place of those of the stream, "
      "which pass unanswered. A level without any query is asked for the way from its spawn to its "
      "goal or last checkpoint.\n\n"
      "The answer to a query depends on the stream, --seed, --max-steps, --solutions, --attempts, "
      "--diverse, --trials, --method and the files of --policy and --warm only, never on "
      "--threads, --backend or the machine; progress records and "
      "result.timing "
      "do, and so does where --time-limit cuts off a search that finds nothing.";
  return spec;
}

}  // namespace obby::tools
