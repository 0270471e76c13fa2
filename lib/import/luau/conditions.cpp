// Looks through the text of a condition; expressions are bounded in height.
#include "import/luau/conditions.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "import/luau/reader.h"

namespace obby::importer::luau {
namespace {

void collectPaths(const Expr& expr, std::set<std::string>& paths, size_t& looked) {
  ++looked;
  if (std::string path = pathOf(expr); !path.empty()) paths.insert(std::move(path));
  for (const ExprPtr& kid : expr.kids) collectPaths(*kid, paths, looked);
}

}  // namespace

std::string pathOf(const Expr& expr) {
  constexpr int kDeepest = 16;
  constexpr size_t kLongest = 100;  // of a name
  if (expr.height > kDeepest || expr.text.size() > kLongest) return {};
  if (expr.kind == ExprKind::name) return expr.text;
  if (expr.kind != ExprKind::field) return {};
  const std::string base = pathOf(*expr.kids[0]);
  return base.empty() ? base : base + "." + expr.text;
}

std::set<std::string> pathsIn(const Expr& condition, size_t& looked) {
  std::set<std::string> paths;
  collectPaths(condition, paths, looked);
  return paths;
}

std::set<std::string> posesAmong(const std::set<std::string>& paths) {
  static constexpr const char* kPoses[] = {"CFrame",   "cframe",      "Position",
                                           "position", "Orientation", "Rotation"};
  std::set<std::string> placed, poses;
  for (const std::string& path : paths) {
    const size_t end = path.rfind('.');
    if (end == std::string::npos || !isPoseProperty(path.substr(end + 1))) continue;
    placed.insert(path.substr(0, end));
  }
  for (const std::string& part : placed)
    for (const char* pose : kPoses) poses.insert(part + "." + pose);
  return poses;
}

std::string defaulted(const Expr& condition) {
  const bool denied = condition.kind == ExprKind::unary && condition.text == "not";
  const bool absent = condition.kind == ExprKind::binary && condition.text == "==" &&
                      condition.kids[1]->kind == ExprKind::nil;
  if (!denied && !absent) return {};
  const Expr& value = *condition.kids[0];
  const bool named = value.kind == ExprKind::name || value.kind == ExprKind::field;
  return named ? value.text : std::string();
}

bool isWait(const Expr& expr) {
  return expr.kind == ExprKind::call || expr.kind == ExprKind::method;
}

bool isFixed(const Expr& expr) {
  const auto& kids = expr.kids;
  switch (expr.kind) {
    case ExprKind::nil:
    case ExprKind::truth:
    case ExprKind::falsehood:
    case ExprKind::number:
    case ExprKind::string: return true;
    case ExprKind::unary:
    case ExprKind::binary:
      return std::all_of(kids.begin(), kids.end(),
                         [](const ExprPtr& kid) { return isFixed(*kid); });
    case ExprKind::call: return kids[0]->text == "wait";  // and task.wait
    case ExprKind::method: return expr.text == "Wait" || expr.text == "wait";
    default: return false;
  }
}

bool asksClock(const std::set<std::string>& paths) {
  static constexpr const char* kClocks[] = {"tick", "time", "elapsedTime", "os.clock", "os.time"};
  return std::any_of(std::begin(kClocks), std::end(kClocks),
                     [&](const char* clock) { return paths.count(clock) > 0; });
}

bool asksTween(const Expr& expr) {
  const bool state = expr.kind == ExprKind::field && expr.text == "PlaybackState";
  if (state && expr.kids[0]->text != "Enum") return true;
  return std::any_of(expr.kids.begin(), expr.kids.end(),
                     [](const ExprPtr& kid) { return asksTween(*kid); });
}

}  // namespace obby::importer::luau
