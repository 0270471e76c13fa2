#include "cli/variables.h"

#include <algorithm>
#include <iterator>
#include <string_view>

#include "base/spelling.h"
#include "cli/parse.h"

namespace obby::cli {
namespace {

constexpr std::string_view kPrefix = "OBBY_";

// Every option of every tool, in order. tests/cli/obby-echo/option-names checks the list.
constexpr std::string_view kAllOptions[] = {
    "arrive",      "ascii",        "attempts",
    "avoid",       "backend",      "body",
    "check",       "check-steps",  "checkpoint",
    "completion",  "config",       "count",
    "course",      "cpu-time",     "decisions",
    "difficulty",  "directions",   "discount",
    "diverse",     "each",         "entropy",
    "epochs",      "eval",         "eval-levels",
    "eval-tries",  "exit-status",  "explain",
    "final-only",  "first",        "fit",
    "forbid",      "format",       "frame-rate",
    "from",        "full",         "generate",
    "generations", "goal",         "grace",
    "heat-map",    "held-out",     "help",
    "help-all",    "idle",         "improve",
    "jobs",        "json-errors",  "learning-rate",
    "list",        "live",         "live-exit",
    "log-every",   "max-body",     "max-damage",
    "max-jumps",   "max-steps",    "max-time",
    "memory",      "method",       "min-jumps",
    "minibatch",   "name",         "no-color",
    "no-map",      "no-queries",   "no-scripts",
    "no-token",    "noise",        "not-pass",
    "on-error",    "output",       "pair",
    "pass",        "paths",        "ping",
    "play",        "policy",       "port",
    "prefer",      "print-config", "progress",
    "query",       "quiet",        "recipe",
    "rehearse",    "report",       "request-timeout",
    "restarts",    "resume",       "same-keys",
    "save-every",  "schema",       "seed",
    "set",         "silence",      "size",
    "solutions",   "solve",        "start",
    "start-from",  "state-dir",    "stdio",
    "style",       "tensorboard",  "threads",
    "time-limit",  "tolerance",    "trials",
    "tricks",      "twins",        "unsolvable",
    "verbose",     "verify",       "version",
    "visit",       "warm",         "watch",
    "waypoint",    "width",        "worlds",
};

// Former names of options that the tools still accept.
constexpr std::string_view kFormerOptions[] = {"part", "passes", "rate"};

// Returns "time-limit" for "OBBY_TIME_LIMIT".
std::string optionNameOf(std::string_view variable) {
  std::string out = lower(variable.substr(kPrefix.size()));
  std::replace(out.begin(), out.end(), '_', '-');
  return out;
}

bool isOption(const std::string& name) {
  return std::binary_search(std::begin(kAllOptions), std::end(kAllOptions), name) ||
         std::find(std::begin(kFormerOptions), std::end(kFormerOptions), name) !=
             std::end(kFormerOptions);
}

}  // namespace

std::vector<MisspeltVariable> misspeltVariables(const std::vector<OptionRow>& rows,
                                                const char* const* environment) {
  std::vector<std::string> names, former;
  for (const OptionRow& row : rows) {
    if (onlyTyped(row)) continue;
    names.push_back(row.name);
    former.push_back(row.formerly);
  }
  std::vector<MisspeltVariable> out;
  for (; *environment; environment++) {
    const std::string_view entry = *environment;
    const size_t equals = entry.find('=');
    if (!entry.starts_with(kPrefix) || equals == std::string_view::npos) continue;
    if (equals + 1 == entry.size()) continue;  // an empty variable sets nothing, whatever its name
    const std::string_view variable = entry.substr(0, equals);
    const std::string name = optionNameOf(variable);
    if (isOption(name) || std::find(names.begin(), names.end(), name) != names.end()) continue;
    if (std::find(former.begin(), former.end(), name) != former.end()) continue;
    const std::string near = nearestName(name, names);
    if (!near.empty()) out.push_back({std::string(variable), environmentName(near)});
  }
  return out;
}

}  // namespace obby::cli
