// What was seen and is not in the level, and scripts that did not run to the end.
#include "import/observed/roles.h"

namespace obby::importer {

void noteObservedLosses(RoleContext& context, const ObservedPlace& place) {
  const Tree& tree = context.tree;
  const engine::Report& report = place.report;
  if (!report.failure.empty())
    context.level.noteUnmodelled("scripts that did not finish",
                                 report.culprit < tree.size() ? tree.path(report.culprit) : "",
                                 report.failure);
  for (const engine::Problem& problem : report.undisturbed.problems) {
    if (problem.script >= tree.size()) continue;
    context.level.noteUnmodelled("script that fails", tree.path(problem.script), problem.text);
  }
  for (const auto& [what, count] : report.undisturbed.counts) {
    (void)count;
    context.level.noteIgnored("not in the twin of the engine", what, "does nothing");
  }
}

}  // namespace obby::importer
