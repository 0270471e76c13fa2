#include "bridge/order.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "bridge/json.h"
#include "bridge/request.h"
#include "io/json_codec.h"

namespace obby::bridge {
namespace {

using io::JsonTree;
using Node = JsonTree::Node;
using Type = JsonTree::Type;

// The members of the budget, and the options of our programs that they set. Bounds are those of the
// option tables, except for the time, which a shared bridge must limit.
enum class Shape { number, whole, seed, truth, preference };
struct BudgetRow {
  const char* name;
  const char* option;
  Shape shape;
  double min = 0, max = 0;
  bool solves = true, calibrates = false;  // programs that have the option
};
constexpr std::string_view kPreferences[] = {"natural", "fast", "safe", "few-jumps", "first"};
constexpr BudgetRow kBudgetRows[] = {
    {"timeLimit", "--time-limit", Shape::number, 0.01, 600},
    {"maxSteps", "--max-steps", Shape::whole, 1, 9e15},
    {"solutions", "--solutions", Shape::whole, 1, 1000},
    {"diverse", "--diverse", Shape::truth},
    {"attempts", "--attempts", Shape::whole, 0, 1000},
    {"difficulty", "--difficulty", Shape::truth},
    {"trials", "--trials", Shape::whole, 1, 1000000},
    {"explain", "--explain", Shape::truth},
    {"improve", "--improve", Shape::number, 0, 600},
    {"prefer", "--prefer", Shape::preference},
    {"paths", "--paths", Shape::truth},
    {"heatMap", "--heat-map", Shape::truth},
    {"restarts", "--restarts", Shape::whole, 1, 1000, false, true},
    {"generations", "--generations", Shape::whole, 1, 100000, false, true},
    {"seed", "--seed", Shape::seed, 0, 0, true, true},
};

class OrderReader {
 public:
  OrderReader(const JsonTree& tree, const Limits& limits) : tree_(tree), limits_(limits) {}

  Result<Order> read() {
    OBBY_RETURN_IF_ERROR(
        forMembers(tree_, tree_.root(), "",
                   [&](std::string_view name, const Node& value) { return member(name, value); }));
    OBBY_RETURN_IF_ERROR(check());
    return std::move(order_);
  }

 private:
  Status member(std::string_view name, const Node& value) {
    if (name == "task") return task(value);
    if (name == "level") return text(value, "level", order_.level);
    if (name == "warm") return text(value, "warm", order_.warm);
    if (name == "queries") return records(value, "queries", "query", io::Kind::QUERY);
    if (name == "recordings") return records(value, "recordings", "recording", io::Kind::RECORDING);
    if (name == "ask") return ask(value);
    if (name == "physics") {
      OBBY_ASSIGN(order_.physics, lineOf(value, "physics", "params", io::Kind::PARAMS));
      return {};
    }
    if (name == "budget") {
      return forMembers(tree_, value, "budget", [&](std::string_view row, const Node& setting) {
        return budget(row, setting);
      });
    }
    return unknownMember(
        "", name, {"task", "level", "queries", "ask", "warm", "physics", "budget", "recordings"});
  }

  Status task(const Node& value) {
    std::string name;
    OBBY_RETURN_IF_ERROR(text(value, "task", name));
    if (name != "solve" && name != "calibrate") {
      return pathError("task", "expected solve or calibrate, found " + tree_.describe(value));
    }
    order_.task = name == "solve" ? Task::solve : Task::calibrate;
    return {};
  }

  Status text(const Node& value, const char* path, std::string& out) {
    OBBY_ASSIGN(out, jsonString(tree_, value, path));
    return {};
  }

  Status ask(const Node& value) {
    return forElements(tree_, value, "ask", [&](uint32_t i, const Node& id) -> Status {
      OBBY_RETURN_IF_ERROR(countOf(order_.ask.size() + 1, "ask"));
      OBBY_ASSIGN(std::string wanted, jsonString(tree_, id, fmt::format("ask[{}]", i)));
      order_.ask.push_back(std::move(wanted));
      return {};
    });
  }

  Status records(const Node& value, const char* name, const char* type, io::Kind kind) {
    if (recordsName_)
      return pathError(name, fmt::format("cannot be combined with '{}'", recordsName_));
    recordsName_ = name;
    return forElements(tree_, value, name, [&](uint32_t i, const Node& record) -> Status {
      OBBY_RETURN_IF_ERROR(countOf(order_.records.size() + 1, name));
      OBBY_ASSIGN(std::string line, lineOf(record, fmt::format("{}[{}]", name, i), type, kind));
      order_.records.push_back(std::move(line));
      return {};
    });
  }

  // Converts the record by lib/io and back, so that all of its fields are the schema's.
  Result<std::string> lineOf(const Node& value, const std::string& path, const char* type,
                             io::Kind kind) const {
    io::JsonWriter out;
    out.open('{').field("type", type);
    OBBY_RETURN_IF_ERROR(
        forMembers(tree_, value, path, [&](std::string_view name, const Node& field) -> Status {
          if (name != "type") {
            writeNode(out.key(name), tree_, field);
          } else if (field.type != Type::text || tree_.text(field) != type) {
            return pathError(path + ".type", fmt::format("expected \"{}\"", type));
          }
          return {};
        }));
    auto built = io::recordFromJson(out.finish());
    if (!built) return placed(built.error(), path);
    if (built->reader().which() != kind)
      return pathError(path, fmt::format("expected a {} record", type));
    auto line = io::recordToJson(built->reader());
    if (!line) return placed(line.error(), path);
    return *std::move(line);
  }

  static Error placed(Error error, const std::string& path) {
    error.path = error.path.empty() ? path : path + "." + error.path;
    return error;
  }

  Status countOf(size_t count, const char* name) const {
    if (count <= limits_.queries) return {};
    return pathError(name, fmt::format("expected at most {} entries, found more", limits_.queries),
                     "split them into several jobs");
  }

  Status budget(std::string_view name, const Node& value) {
    std::vector<std::string> known;
    for (const BudgetRow& row : kBudgetRows) {
      if (name == row.name) return option(row, value);
      known.emplace_back(row.name);
    }
    return unknownMember("budget", name, known);
  }

  Status option(const BudgetRow& row, const Node& value) {
    const std::string path = std::string("budget.") + row.name;
    rows_.push_back(&row);
    if (row.shape == Shape::truth) {
      if (value.type == Type::yes) order_.arguments.emplace_back(row.option);
      if (value.type == Type::yes || value.type == Type::no) return {};
      return pathError(path, "expected true or false, found " + tree_.describe(value));
    }
    const std::string setting = settingOf(row, value);
    if (setting.empty()) {
      return pathError(path,
                       fmt::format("expected {}, found {}", expected(row), tree_.describe(value)));
    }
    order_.arguments.push_back(fmt::format("{}={}", row.option, setting));
    return {};
  }

  static std::string expected(const BudgetRow& row) {
    switch (row.shape) {
      case Shape::seed: return "a whole number or, beyond 2^53, its digits as a string";
      case Shape::preference: return fmt::format("one of {}", fmt::join(kPreferences, ", "));
      default:
        return fmt::format("a {}number from {} to {}", row.shape == Shape::whole ? "whole " : "",
                           row.min, row.max);
    }
  }

  // Returns the value as an argument, or "" if it is invalid.
  std::string settingOf(const BudgetRow& row, const Node& value) const {
    switch (row.shape) {
      case Shape::seed: return seed(value);
      case Shape::preference: return preference(value);
      default: return number(row, value);
    }
  }

  std::string preference(const Node& value) const {
    if (value.type != Type::text) return {};
    const std::string_view text = tree_.text(value);
    return std::string(std::ranges::find(kPreferences, text) == std::end(kPreferences) ? "" : text);
  }

  std::string number(const BudgetRow& row, const Node& value) const {
    double found = NAN;
    if (value.type == Type::whole) found = double(value.value);
    if (value.type == Type::real) {
      const std::string_view text = tree_.text(value);
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), found);
      if (error != std::errc() || end != text.data() + text.size()) return {};
    }
    if (!(found >= row.min && found <= row.max)) return {};
    if (row.shape == Shape::number) return fmt::format("{}", found);
    return std::floor(found) == found ? fmt::format("{:.0f}", found) : "";
  }

  std::string seed(const Node& value) const {
    if (value.type == Type::whole) return fmt::format("{}", value.value);
    if (value.type != Type::text) return {};
    const std::string_view text = tree_.text(value);
    uint64_t found = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), found);
    const bool right = !text.empty() && error == std::errc() && end == text.data() + text.size();
    return right ? fmt::format("{}", found) : "";
  }

  Status check() const {
    const bool solve = order_.task == Task::solve;
    if (recordsName_ && (std::string_view(recordsName_) == "queries") != solve) {
      return pathError(recordsName_, "this field is not allowed with this task");
    }
    for (const BudgetRow* row : rows_) {
      if (solve ? row->solves : row->calibrates) continue;
      return pathError(std::string("budget.") + row->name,
                       "this field is not allowed with this task");
    }
    if (isGiven("--trials=") && !isGiven("--difficulty"))
      return pathError("budget.trials", "this field has no effect without budget.difficulty",
                       "set budget.difficulty to true, or leave out budget.trials");
    if (!isLevelId(order_.level)) {
      return pathError("level", "expected the id of a level",
                       "send the level to POST /v1/levels to get one");
    }
    if (!order_.warm.empty() && (!solve || !isJobId(order_.warm))) {
      return pathError("warm", "expected the id of an earlier solve job");
    }
    if (!solve && order_.records.empty()) {
      return pathError("recordings", "calibration needs at least one recording");
    }
    if (!solve && !order_.ask.empty())
      return pathError("ask", "this field is not allowed with this task");
    if (!solve && !order_.physics.empty()) {
      return pathError("physics", "this field is not allowed with this task",
                       "leave out physics; calibration finds the parameters");
    }
    if (!order_.ask.empty() && !order_.records.empty()) {
      return pathError("ask", "cannot be combined with 'queries'");
    }
    return {};
  }

  bool isGiven(std::string_view argument) const {
    return std::any_of(order_.arguments.begin(), order_.arguments.end(),
                       [&](const std::string& a) { return a.starts_with(argument); });
  }

  const JsonTree& tree_;
  const Limits& limits_;
  Order order_;
  const char* recordsName_ = nullptr;
  std::vector<const BudgetRow*> rows_;  // the options given
};

}  // namespace

Result<Order> parseOrder(std::string_view json, const Limits& limits) {
  OBBY_ASSIGN(const JsonTree tree, JsonTree::parse(json));
  return OrderReader(tree, limits).read();
}

}  // namespace obby::bridge
