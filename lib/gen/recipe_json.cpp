// Parses a recipe from JSON. Records ignore unknown keys for later versions, but an unknown key in
// a recipe is an error: it is probably a typo.
#include <fmt/format.h>

#include <charconv>
#include <functional>
#include <unordered_set>

#include "base/spelling.h"
#include "gen/recipe.h"
#include "gen/styles.h"
#include "io/json_tree.h"
#include "level/record_values.h"

namespace obby::gen {

namespace {

using io::JsonTree;
using level::pathError;
using Node = JsonTree::Node;
using Type = JsonTree::Type;

class Reader {
 public:
  explicit Reader(const JsonTree& tree) : tree_(tree) {}

  // Handles the value of a key; called with the value and its path.
  using Take = std::function<Status(const Node&, const std::string&)>;
  struct Key {
    const char* name;
    Take take;
  };

  Status object(const Node& node, const std::string& path, const std::vector<Key>& keys) const {
    return members(node, path, [&](const Node& member, const std::string& here) -> Status {
      std::vector<std::string> names;
      for (const Key& key : keys) {
        if (tree_.name(member) == key.name) return key.take(member, here);
        names.emplace_back(key.name);
      }
      const std::string near = nearestName(tree_.name(member), names);
      return pathError(here, "unknown key",
                       near.empty() ? fmt::format("expected one of {}", fmt::join(names, ", "))
                                    : "did you mean " + near + "?");
    });
  }

  Take number(float& out) const {
    return [this, &out](const Node& n, const std::string& path) -> Status {
      OBBY_ASSIGN(out, numberOf(n, path));
      return {};
    };
  }

  // Reads one number, or a minimum and a maximum.
  Take range(Range& out) const {
    return [this, &out](const Node& n, const std::string& path) {
      return pair(n, path, oneNumber(), out);
    };
  }

  // Like range(), but also accepts names of difficulties.
  Take difficulty(Range& out) const {
    return [this, &out](const Node& n, const std::string& path) {
      return pair(
          n, path, [this](const Node& one, const std::string& p) { return difficultyOf(one, p); },
          out);
    };
  }

  Take count(Count& out) const {
    return [this, &out](const Node& n, const std::string& path) -> Status {
      Range r{};
      OBBY_RETURN_IF_ERROR(pair(
          n, path, [this](const Node& one, const std::string& p) { return wholeOf(one, p); }, r));
      out = {uint32_t(r.lo), uint32_t(r.hi)};
      return {};
    };
  }

  // Reads an object that maps styles to objects of parameters. Each parameter has one number, or
  // two: at difficulty 0 and 1.
  Take settings(std::vector<Setting>& out) const {
    return [this, &out](const Node& n, const std::string& path) {
      out.clear();
      return members(n, path, [&](const Node& member, const std::string& here) -> Status {
        OBBY_ASSIGN(const Style* style, styleNamed(tree_.name(member), here));
        return settingsOf(*style, member, here, out);
      });
    };
  }

  // Reads an object of numbers with arbitrary names.
  Take numbers(std::vector<NamedNumber>& out) const {
    return [this, &out](const Node& n, const std::string& path) {
      out.clear();
      return members(n, path, [&](const Node& member, const std::string& here) -> Status {
        OBBY_ASSIGN(const float value, numberOf(member, here));
        out.push_back({std::string(tree_.name(member)), value});
        return {};
      });
    };
  }

 private:
  using One = std::function<Result<float>(const Node&, const std::string&)>;

  Status members(const Node& node, const std::string& path, const Take& take) const {
    if (node.type != Type::object) return expected("an object", node, path);
    std::unordered_set<std::string_view> seen;
    for (const Node& member : tree_.children(node)) {
      const std::string_view name = tree_.name(member);
      const std::string here = path.empty() ? std::string(name) : path + "." + std::string(name);
      if (!seen.insert(name).second)
        return pathError(here, "this key is given twice", "keep one of the two");
      OBBY_RETURN_IF_ERROR(take(member, here));
    }
    return {};
  }

  Status settingsOf(const Style& style, const Node& node, const std::string& path,
                    std::vector<Setting>& out) const {
    return members(node, path, [&](const Node& member, const std::string& here) -> Status {
      OBBY_ASSIGN(const Parameter* parameter, parameterNamed(style, tree_.name(member), here));
      Range ends{};
      OBBY_RETURN_IF_ERROR(pair(member, here, oneNumber(), ends, "[trivial, limit]"));
      out.push_back({parameter, ends.lo, ends.hi});
      return {};
    });
  }

  One oneNumber() const {
    return [this](const Node& n, const std::string& path) { return numberOf(n, path); };
  }

  // `both`: how errors write the form with two values.
  Status pair(const Node& node, const std::string& path, const One& one, Range& out,
              const std::string& both = "[min, max]") const {
    if (node.type != Type::array) {
      OBBY_ASSIGN(out.lo, one(node, path));
      out.hi = out.lo;
      return {};
    }
    if (node.length != 2) return expected("one value or " + both, node, path);
    const Node& first = tree_.node(node.child);
    OBBY_ASSIGN(out.lo, one(first, path + "[0]"));
    OBBY_ASSIGN(out.hi, one(tree_.node(first.next), path + "[1]"));
    return {};
  }

  Result<float> numberOf(const Node& n, const std::string& path) const {
    float value = 0;
    if (n.type == Type::whole) return float(n.value);
    if (n.type == Type::negative) return float(int64_t(n.value));
    if (n.type != Type::real) return expected("a number", n, path);
    const std::string_view text = tree_.text(n);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) {
      return expected("a number within the range of floats", n, path);
    }
    return value;
  }

  Result<float> wholeOf(const Node& n, const std::string& path) const {
    if (n.type != Type::whole || n.value > 1000000) {
      return expected("a whole number up to 1000000", n, path);
    }
    return float(n.value);
  }

  Result<float> difficultyOf(const Node& n, const std::string& path) const {
    if (n.type != Type::text) return numberOf(n, path);
    auto value = parseDifficulty(tree_.text(n));
    if (!value) value.error().path = path;
    return value;
  }

  Error expected(std::string_view what, const Node& n, const std::string& path) const {
    return pathError(path, fmt::format("expected {}, found {}", what, tree_.describe(n)));
  }

  const JsonTree& tree_;
};

}  // namespace

Result<Recipe> Recipe::fromJson(std::string_view text) {
  OBBY_ASSIGN(const JsonTree tree, JsonTree::parse(text));
  const Reader r(tree);
  Recipe out;
  const auto course = [&](const Node& n, const std::string& path) {
    return r.object(n, path,
                    {{"obstacles", r.count(out.courseObstacles)},
                     {"first", r.number(out.courseFirst)},
                     {"styles", r.numbers(out.courseStyles)}});
  };
  const auto limits = [&](const Node& n, const std::string& path) {
    return r.object(n, path,
                    {{"waypoints", r.number(out.waypoints)},
                     {"jumps", r.number(out.jumpLimits)},
                     {"time", r.number(out.timeLimits)}});
  };
  OBBY_RETURN_IF_ERROR(r.object(tree.root(), "",
                                {{"styles", r.numbers(out.styles)},
                                 {"difficulty", r.difficulty(out.difficulty)},
                                 {"obstacles", r.count(out.obstacles)},
                                 {"course", course},
                                 {"turns", r.number(out.turns)},
                                 {"limits", limits},
                                 {"excess", r.range(out.excess)},
                                 {"parameters", r.settings(out.parameters)},
                                 {"physics", r.numbers(out.physics)}}));
  OBBY_RETURN_IF_ERROR(checkRecipe(out));
  return out;
}

}  // namespace obby::gen
