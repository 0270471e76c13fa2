// The option table of obby-solve.
#include "options.h"

#include <fmt/format.h>

#include "baselines/methods.h"
#include "cli/rows.h"
#include "level/tricks.h"
#include "solve/improve/preference.h"

namespace obby::tools {

namespace {

using cli::between;
using cli::detailed;
using cli::flagRow;
using cli::lettered;
using cli::OptionRow;
using cli::rare;
using cli::renewed;
using cli::repeatable;
using cli::row;
using cli::ValueType;

constexpr const char* kQueryGroup = "Ask a query on the command line";
constexpr const char* kSearchGroup = "Search";
constexpr const char* kOutputGroup = "What to add to the answers";
constexpr const char* kAnsweredGroup = "Check or filter existing answers (no search)";

OptionRow methodRow() {
  OptionRow r = row("method", ValueType::choice, "", "auto", "search method", kSearchGroup);
  for (const solve::Method* m : baselines::allMethods()) {
    if (!r.choices.empty()) r.details += '\n';
    r.choices.push_back(m->name);
    r.details += std::string(m->name) + ": " + m->description;
  }
  return rare(r);
}

OptionRow forbidRow() {
  OptionRow r = row("forbid", ValueType::choice, "", "", "never be in this state", kQueryGroup);
  r.choices = {"jumping", "climbing", "seated", "fallingDown"};
  return r;
}

OptionRow arriveRow() {
  OptionRow r = row("arrive", ValueType::choice, "", "stand", "when a solid part counts as reached",
                    kQueryGroup);
  r.choices = {"stand", "touch"};
  r.details =
      "stand: the player stands or sits on the part, or holds on to it\n"
      "touch: the body is next to the part; grazing its side while falling past counts";
  return rare(r);
}

OptionRow tricksRow() {
  OptionRow r =
      row("tricks", ValueType::choice, "", "none",
          "tricks that the player may use: moves that designers do not plan with", kQueryGroup);
  r.choices = level::trickOptions();
  r.details =
      "none: normal play\n"
      "held-jump: a jump made while turning rises up to 9.7 studs\n"
      "hanging-landing: a jump right after a landing starts up to 1.1 studs higher\n"
      "wall-hop: the player turns instantly in the air, to step on seams and corners of walls\n"
      "ladder-flick: the player grips a truss again while rising from a jump off it\n"
      "leg-throw: a floor that comes under the legs suddenly throws the player up\n"
      "all: all of these";
  return repeatable(rare(r));
}

OptionRow directionsRow() {
  OptionRow r = row("directions", ValueType::choice, "", "any",
                    "directions in which the player can walk", kQueryGroup);
  r.choices = {"any", "keyboard"};
  r.details =
      "any: every direction, as with a thumbstick or a camera that turns\n"
      "keyboard: eight directions, as with a keyboard and a camera that stays behind the player's "
      "facing at the start";
  return rare(r);
}

OptionRow timeLimitRow() {
  OptionRow r = cli::withDefault(cli::commonRow(cli::Common::timeLimit), "20");
  r.help = "wall-clock limit for each query";
  r.group = kSearchGroup;
  return r;
}

OptionRow backendRow() {
  OptionRow r = cli::commonRow(cli::Common::backend);
  r.help = "device that simulates rollouts; the answers do not depend on it";
  r.details = "auto uses the CPU, because the rounds of a search are too small for a GPU.";
  return rare(r);
}

OptionRow preferRow() {
  OptionRow r = row("prefer", ValueType::choice, "", "natural", "kind of solution", kSearchGroup);
  for (const solve::Preference& p : solve::preferences()) {
    r.choices.push_back(p.name);
    r.details += fmt::format("{}: {}\n", p.name, p.description);
  }
  r.choices.push_back("first");
  r.details += "first: the solution found first, not improved";
  return r;
}

OptionRow improveRow() {
  return detailed(
      rare(between(row("improve", ValueType::number, "SECONDS", "0.2",
                       "improve the solutions of a query for about this long", kSearchGroup),
                   0, 100000)),
      "The time is counted in simulated ticks, so that the answer is the same on "
      "every machine.");
}

OptionRow bodyRow() {
  return detailed(
      repeatable(row("body", ValueType::text, "BODY", "",
                     "body: r6, r15, place (as the place sets) or each (all that the place allows) "
                     "[default: place]",
                     kSearchGroup)),
      "To give several bodies, separate them with commas or repeat the option. A query with "
      "several bodies or frame rates is solved if it is solved for all of them, and unreachable if "
      "it is unreachable for at least one. Its result lists the answer for each.");
}

OptionRow frameRateRow() {
  return detailed(rare(repeatable(row("frame-rate", ValueType::text, "N", "",
                                      "frames a second of the player's game: 30, 60, 120, 144, 240 "
                                      "or each (all of these) [default: the level's]",
                                      kSearchGroup))),
                  "The game reads the player's inputs once a frame. A physics step is 1/240 s, or "
                  "1/288 s at 144 frames a second.");
}

OptionRow sameKeysRow() {
  return rare(flagRow("same-keys",
                      "with several bodies or frame rates: find one sequence of timed inputs that "
                      "works for all of them",
                      kSearchGroup));
}

std::vector<OptionRow> searchRows() {
  return {
      repeatable(row("query", ValueType::text, "ID", "", "answer, check or filter only this query",
                     kSearchGroup)),
      bodyRow(),
      frameRateRow(),
      sameKeysRow(),
      timeLimitRow(),
      detailed(between(row("max-steps", ValueType::integer, "N", "",
                           "stop a query after about N steps (simulated ticks)", kSearchGroup),
                       1, 9e15),
               "Unlike --time-limit, it stops at the same point on every machine."),
      between(
          row("solutions", ValueType::integer, "K", "1", "find K distinct solutions", kSearchGroup),
          1, 1000),
      detailed(
          flagRow("diverse", "with --solutions: one solution per distinct route", kSearchGroup),
          "A route is the sequence of parts that the player stands on. The result says how many "
          "solutions were found on each route."),
      preferRow(),
      improveRow(),
      methodRow(),
      rare(row("policy", ValueType::file, "FILE", "",
               "policy from obby-train for the methods auto, ge-ps and rl [default: the one that "
               "comes with the program]",
               kSearchGroup)),
      rare(renewed(row("warm", ValueType::file, "FILE", "",
                       "earlier answers to these queries; the search tries their trajectories "
                       "first and continues from them",
                       kSearchGroup))),
      detailed(flagRow("watch", "answer again whenever an input file changes", kSearchGroup),
               "The search starts from the last answers. With -o, each run replaces FILE; without "
               "-o, each run writes another stream to standard output."),
  };
}

std::vector<OptionRow> outputRows() {
  return {
      flagRow("difficulty", "rate the difficulty of each solution, step by step", kOutputGroup),
      rare(between(row("trials", ValueType::integer, "N", "1000",
                       "with --difficulty: simulated attempts at each step by an imprecise player",
                       kOutputGroup),
                   1, 1000000)),
      flagRow("explain", "find one change that would make a query solvable", kOutputGroup),
      rare(between(row("attempts", ValueType::integer, "N", "24",
                       "failed attempts to show for each query", kOutputGroup),
                   0, 1000)),
      rare(flagRow("final-only", "leave out progress records", kOutputGroup)),
      rare(flagRow(
          "paths",
          "add the player's positions to each trajectory, for readers that cannot replay it",
          kOutputGroup)),
      rare(flagRow("heat-map",
                   "add to each result a heat map of the places that the search visited",
                   kOutputGroup)),
      lettered(
          flagRow("exit-status",
                  "exit with 1 if any query is unreachable, else with 3 if any verdict is unknown",
                  kOutputGroup),
          'e'),
  };
}

std::vector<OptionRow> answeredRows() {
  return {
      flagRow("verify", "check trajectories by replaying them", kAnsweredGroup),
      repeatable(row("pass", ValueType::text, "PLACE", "",
                     "keep trajectories that pass all of these places", kAnsweredGroup)),
      repeatable(row("not-pass", ValueType::text, "PLACE", "",
                     "keep trajectories that pass none of these places", kAnsweredGroup)),
  };
}

std::vector<OptionRow> runRows() {
  OptionRow seed = cli::commonRow(cli::Common::seed);
  seed.help = "random seed; the same seed gives the same answer";
  return {seed, cli::commonRow(cli::Common::threads), backendRow()};
}

std::vector<cli::Example> examples() {
  return {
      {"Answer all queries of a level", "obby-solve wedge-climb.jsonl -o answers.jsonl"},
      {"Solve a place file and write a page",
       "obby-import first-steps.rbxlx | obby-solve | obby-view -o report.html"},
      {"Ask a query on the command line",
       "obby-solve several-routes.jsonl --goal Goal --max-jumps 9 --max-time 30"},
      {"Find three different routes",
       "obby-solve several-routes.jsonl --goal Goal --solutions 3 --diverse"},
      {"Show the hardest moment of a solution",
       "obby-solve timed-jumps.jsonl --query posts --difficulty | obby-view"},
      {"Add limits to the queries in the input",
       "obby-solve --each --forbid climbing --max-jumps 9 several-routes.jsonl"},
      {"Keep the solutions that cross the beam and avoid the ramp",
       "obby-solve --query no-jumps --solutions 20 --diverse --max-steps 200000 "
       "several-routes.jsonl | obby-solve --pass touch:Beam --not-pass 'touch:Ramp up'"},
      {"Check answers by replaying them", "obby-solve wedge-climb.jsonl | obby-solve --verify"},
  };
}

}  // namespace

std::vector<OptionRow> queryRows() {
  return {
      row("start", ValueType::text, "PLACE", "", "start here [default: the level's first spawn]",
          kQueryGroup),
      repeatable(
          row("goal", ValueType::text, "PLACE", "",
              "reach this part or box; if repeated, any one of them [default: the goal part, "
              "else the last checkpoint]",
              kQueryGroup)),
      repeatable(row("waypoint", ValueType::text, "PLACE", "",
                     "pass here on the way; if repeated, in this order", kQueryGroup)),
      repeatable(row("visit", ValueType::text, "PLACE", "",
                     "pass here on the way; if repeated, in any order", kQueryGroup)),
      repeatable(
          row("avoid", ValueType::text, "PLACE", "", "never enter this part or box", kQueryGroup)),
      between(row("max-jumps", ValueType::integer, "N", "", "jump at most N times", kQueryGroup), 0,
              65535),
      rare(between(
          row("min-jumps", ValueType::integer, "N", "", "jump at least N times", kQueryGroup), 0,
          65535)),
      between(row("max-time", ValueType::number, "SECONDS", "", "arrive within this game time",
                  kQueryGroup),
              0.02, 100000),
      rare(between(row("max-damage", ValueType::number, "HEALTH", "",
                       "lose at most this much health, of 100", kQueryGroup),
                   0, 1e6)),
      repeatable(forbidRow()),
      arriveRow(),
      tricksRow(),
      directionsRow(),
      detailed(flagRow("each", "apply these options to each query in the input", kQueryGroup),
               "A limit given here replaces the query's own."),
  };
}

cli::ToolSpec solveSpec() {
  cli::ToolSpec spec;
  spec.name = "obby-solve";
  spec.summary = "find trajectories that answer the queries in the input";
  spec.inputHelp = "streams with levels and queries";
  spec.tableAtTerminal = true;
  spec.examples = examples();
  spec.options = cli::joined(
      {{cli::commonRow(cli::Common::output), rare(cli::commonRow(cli::Common::format)),
        cli::commonRow(cli::Common::progress), rare(cli::commonRow(cli::Common::onError))},
       queryRows(),
       searchRows(),
       outputRows(),
       answeredRows(),
       runRows()});
  spec.notes =
      "PLACE: a part, given by name, path, end of its path, GUID, #TAG or part:INDEX (its index in "
      "the level's list of parts), or a box x,y,z,sx,sy,sz (centre and size in studs). touch:PART "
      "means touching the part itself, not just its box. If several parts share a #TAG, --goal "
      "accepts any of them, and --start and --waypoint reject the tag; other options apply to all "
      "of them.\n\n"
      "A query on the command line is answered alone; queries in the input are passed on "
      "unanswered, except with --each. Without -o, a terminal shows a short table.";
  spec.details =
      "For a level without a query, obby-solve searches for a trajectory from its spawn to its "
      "goal or last checkpoint.\n\n"
      "The answer to a query depends only on the stream, --seed, --max-steps, --solutions, "
      "--attempts, --diverse, --trials, --method, --body, --frame-rate, --same-keys and the files "
      "of --policy and --warm. It does not depend on --threads, --backend or the machine. Progress "
      "records and result.timing do depend on them, and so does the point where --time-limit stops "
      "a search that finds nothing.";
  spec.exitCodes = {
      {"1", "With --exit-status: a query is unreachable."},
      {"3", "With --exit-status: no query is unreachable, but a verdict is unknown."}};
  return spec;
}

}  // namespace obby::tools
