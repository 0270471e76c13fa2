#include "import/roles/script_hints.h"

#include <algorithm>
#include <set>
#include <string_view>

namespace obby::importer {
namespace {

// Code that reduces health.
constexpr std::string_view kHarmWords[] = {"Health = 0", "Health=0", "TakeDamage", "BreakJoints"};

bool isRunnable(const Instance& instance) {
  return instance.className == "Script" || instance.className == "LocalScript";
}

// Returns the first harmful line of a text that also listens to touches, or 0 if there is none.
int harmLine(const std::string& source) {
  if (source.find("ouched") == std::string::npos) return 0;
  size_t first = std::string::npos;
  for (const std::string_view word : kHarmWords) first = std::min(first, source.find(word));
  if (first == std::string::npos) return 0;
  return 1 + int(std::count(source.begin(), source.begin() + std::ptrdiff_t(first), '\n'));
}

// If a script harms on touch, guesses that it refers to the part that contains it.
void hint(RoleContext& context, InstanceId script) {
  const Instance& instance = context.tree.at(script);
  PartDraft* const part = context.part(instance.parent);
  const auto* const source = property<std::string>(instance, "Source");
  const int line = part && source ? harmLine(*source) : 0;
  if (line == 0 || part->kill || part->goal || part->checkpoint || hasEvidence(*part, kHarmless))
    return;
  part->kill = Kill{};
  part->evidence.push_back({"kill", lineReason(context.tree, {script, line}), true});
}

}  // namespace

void hintsFromScripts(RoleContext& context, const ObservedPlace& place) {
  std::set<InstanceId> failed;
  for (const engine::Problem& problem : place.report.undisturbed.problems)
    if (problem.failure == engine::Failure::limited) failed.insert(problem.script);
  for (InstanceId id = 0; id < context.tree.size(); ++id) {
    const Instance& instance = context.tree.at(id);
    if (!isRunnable(instance) || (place.ran && !failed.contains(id))) continue;
    hint(context, id);
    if (!place.ran)
      context.level.noteUnmodelled("script that did not run", context.tree, id,
                                   "the level lacks its effects");
  }
}

}  // namespace obby::importer
