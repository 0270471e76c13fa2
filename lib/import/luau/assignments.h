// What the text of a script assigns. A variable, a field of a table, a value object or an attribute
// that is set in play, and never set back, is a flag: what asks for it comes but once.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "engine/luau/ast.h"
#include "import/luau/datum.h"

namespace obby::importer::luau {

using namespace obby::luau;

// The value that an expression states: nil, true, false, a number, a text. Unknown: it is none.
Datum literalOf(const Expr& expr);

// The name under which what an expression asks for, or is set by, may be a flag, without regard to
// what has the field: "busy", ".busy" of `state.busy`, "=busy" of `script.Busy.Value`, "@Busy" of
// `part:GetAttribute("Busy")` and SetAttribute. Empty: it is none of these.
std::string flagName(const Expr& expr);

// One assignment.
struct Setting {
  const Expr* target = nullptr;       // a variable, or a field of one
  const std::string* name = nullptr;  // of the variable or field
  const Expr* value = nullptr;        // null: an operator gives it, or another value of a list
  // True, false or nil for a time: behind it, with no way out between them, stands the only other
  // setting of the same, to one of these.
  bool passing = false;
};

struct Settings {
  std::vector<Setting> all;
  std::set<std::string> calls;  // variables whose functions it calls, or gives to what it calls
};

// What a function assigns to variables that are not its own, and the threads that it begins do;
// what the handlers do that it connects is left out, but for those of the ends of tweens. The
// function must outlive the settings.
Settings settingsOf(const Function& function);

class Assignments {
 public:
  Assignments() = default;
  explicit Assignments(const Block& chunk) { walk(chunk, true); }

  // Whether all that is assigned under a flagName is one of true, false and nil. Neither
  // declarations count nor the outermost lines: they say where it begins, and come but once.
  bool isFlag(const std::string& name) const;
  // Whether `value` is what is assigned to the flag.
  bool isSet(const std::string& name, const Datum& value) const;

 private:
  void walk(const Block& block, bool outermost);
  void walk(const Expr& expr);
  void take(const Stat& stat);
  void takeCall(const Expr& call);
  void takeFields(const Expr& table);

  std::map<std::string, unsigned> given_;  // by name, a bit for each kind of value
};

}  // namespace obby::importer::luau
