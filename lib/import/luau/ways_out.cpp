// How a loop ends by what stands in it: what its rounds set, and its ways out.
#include <algorithm>
#include <set>
#include <string>

#include "import/luau/conditions.h"
#include "import/luau/reader.h"

namespace obby::importer::luau {
namespace {

constexpr size_t kConditionsPerStep = 2;  // expressions of a condition

bool isWayOut(const Block& branch) {
  if (branch.empty()) return false;
  const Stat& last = *branch.back();
  return last.kind == StatKind::returns || (last.kind == StatKind::leaves && last.text == "break");
}

}  // namespace

std::set<std::string> Reader::pathsOf(const Expr& condition) {
  size_t looked = 0;
  std::set<std::string> paths = pathsIn(condition, looked);
  spend(looked / kConditionsPerStep);
  return paths;
}

// Whether each round sets one of these; with `maybe` whether any may, as what a branch sets.
bool Reader::assigns(const Block& body, const std::set<std::string>& paths, bool maybe) {
  if (paths.empty()) return false;
  return std::any_of(body.begin(), body.end(), [&](const StatPtr& stat) {
    if (!spend()) return false;
    const bool sets = std::any_of(stat->targets.begin(), stat->targets.end(), [&](const auto& to) {
      return stat->kind != StatKind::function && paths.count(pathOf(*to)) > 0;
    });
    if (sets || (!maybe && stat->kind == StatKind::branch)) return sets;
    return std::any_of(stat->blocks.begin(), stat->blocks.end(),
                       [&](const Block& block) { return assigns(block, paths, maybe); });
  });
}

// Whether a round of a loop can leave it, by a break of its own or by a return.
bool Reader::canLeave(const Block& body, bool inner) {
  return std::any_of(body.begin(), body.end(), [&](const StatPtr& stat) {
    if (!spend()) return false;
    if (stat->kind == StatKind::returns) return true;
    if (stat->kind == StatKind::leaves) return !inner && stat->text == "break";
    const bool loop = stat->kind == StatKind::whileLoop || stat->kind == StatKind::repeatLoop ||
                      stat->kind == StatKind::numericFor || stat->kind == StatKind::genericFor;
    return std::any_of(stat->blocks.begin(), stat->blocks.end(),
                       [&](const Block& block) { return canLeave(block, inner || loop); });
  });
}

// Whether the text tells if the condition holds as the loop begins; no time goes by.
bool Reader::isTold(const Expr& condition) {
  const double start = time_;
  const bool known = truthOf(evaluate(condition)) != Truth::unknown;
  time_ = start;
  return known;
}

// Whether a way out of a loop asks for what each round sets, as `n -= 1 if n == 0 then break end`.
bool Reader::countsToWayOut(const Block& body) {
  return std::any_of(body.begin(), body.end(), [&](const StatPtr& stat) {
    if (!spend() || stat->kind != StatKind::branch) return false;
    if (!isWayOut(stat->blocks[0])) return false;
    return assigns(body, pathsOf(*stat->values[0])) && isTold(*stat->values[0]);
  });
}

// The line of a way out, in whatever branch of a round, that asks for what some round may set; 0:
// there is none.
int Reader::lateWayOut(const Block& round, const Block& body) {
  for (const StatPtr& stat : round) {
    const bool branches = stat->kind == StatKind::branch;
    if (!spend() || (!branches && stat->kind != StatKind::block)) continue;
    for (size_t i = 0; i < stat->blocks.size(); ++i) {
      const bool asks = i < stat->values.size() && isWayOut(stat->blocks[i]);
      if (asks && assigns(body, pathsOf(*stat->values[i]), true)) return stat->line;
      if (const int line = lateWayOut(stat->blocks[i], body); line > 0) return line;
    }
  }
  return 0;
}

// A branch that may be taken leads out of the endless loop that is followed. The first one counts.
void Reader::noteWayOut(Flow flow, int line) {
  const bool breaks = flow == Flow::leaveLoop && loops_ == endless_.loops;
  const bool returns = flow == Flow::leaveFunction && active_.size() == endless_.calls;
  if (timeline_.forever && endless_.wayOut == 0 && (breaks || returns)) endless_.wayOut = line;
}

// Of a loop that is taken as endless.
void Reader::keepWayOut(const Block& body) {
  const int line = endless_.wayOut > 0 ? endless_.wayOut : lateWayOut(body, body);
  if (line > 0) reading_.waysOut.push_back(line);
}

}  // namespace obby::importer::luau
