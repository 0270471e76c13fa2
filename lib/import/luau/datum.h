// A value as far as a script's text tells it. What depends on the running game is unknown; what
// comes from the character that touches or joins is a stranger, so that what happens to it still
// shows.
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "engine/luau/ast.h"
#include "import/script_reading.h"

namespace obby::importer::luau {

using namespace obby::luau;

struct Datum;
struct Scope;

struct Unknown {};
struct Nil {};
// Something of a character, a player or an instance that the script made; `name` is the property or
// child through which it was reached ("Humanoid", "Health").
struct Stranger {
  std::string name;
};
// `Health - 30` of a stranger, or another sum that names only what is added.
struct Change {
  std::string name;
  double by = 0;  // NaN: not known
};
struct Closure {
  const Function* function = nullptr;
  Scope* scope = nullptr;
};
struct Table {
  std::vector<Datum> items;
  std::map<std::string, Datum> fields;
  size_t born = 0;  // in the timeline of this number: 0 the script's own
};
// An instance that the script creates or clones.
struct Made {
  std::string className;
  std::map<std::string, Datum> properties;
};
struct Tween {
  InstanceId target = kNoInstance;
  TweenTiming timing;
  std::map<std::string, Datum> goals;
  std::vector<Closure> completed;
  int line = 0, number = 0;
  // What its target was when it was last played from the start.
  Pose from;
  std::map<std::string, Datum> began;
};
// A pose and the instance whose pose it is, if it is one unchanged; and the instance that it turns
// on the spot, or not at all, while the statement runs that has read where that is.
struct Frame {
  Pose pose;
  InstanceId from = kNoInstance;
  InstanceId at = kNoInstance;
  size_t statement = 0;  // with `at`
};
struct Vector {
  Vec3 value;  // NaN: not known
  InstanceId from = kNoInstance;
};
// A thing of the library named by its path: "Enum.EasingStyle.Sine", "TweenService", "math.sin".
struct Library {
  std::string name;
};

// What Connect gives back: `number` tells the connections of a script apart.
struct Connection {
  int number = 0;
};

// A signal of an instance or of a tween, as a variable holds it: `local touched = part.Touched`.
struct Signal {
  InstanceId instance = kNoInstance;
  Tween* tween = nullptr;
  std::string name;
};

struct Datum {
  std::variant<Unknown, Nil, bool, double, std::string, Vector, Frame, Ref, Stranger, Change,
               Closure, Library, TweenTiming, Table*, Made*, Tween*, Connection, Signal>
      value = Unknown{};

  template <class T>
  const T* as() const {
    return std::get_if<T>(&value);
  }
};

// The i-th argument of a call; unknown where there is none.
const Datum& argument(const std::vector<Datum>& arguments, size_t i);

struct Scope {
  Scope* parent = nullptr;
  std::map<std::string, Datum> names;
  size_t born = 0;  // as of a table

  // The nearest scope that has the name; null if none has.
  Scope* holder(const std::string& name);
};

// Owns everything that values point to, until a reading is over: scripts build cycles at will.
class Arena {
 public:
  template <class T>
  T* make() {
    return &std::get<std::deque<T>>(things_).emplace_back();
  }

 private:
  std::tuple<std::deque<Scope>, std::deque<Table>, std::deque<Made>, std::deque<Tween>> things_;
};

enum class Truth { no, yes, unknown };
Truth truthOf(const Datum& datum);
Truth negated(Truth truth);
Datum datumOf(Truth truth);

// A part's property or a value object's Value as the file has it.
Datum datumFrom(const obby::Value& value, InstanceId owner);

// The health that a character has, or can have: who loses that dies.
bool isAllHealth(const Datum& datum);

// One of two values; which of them is not known.
Datum oneOf(const Datum& a, const Datum& b);

Datum arithmetic(const std::string& op, const Datum& a, const Datum& b);
Datum compared(const std::string& op, const Datum& a, const Datum& b);

}  // namespace obby::importer::luau
