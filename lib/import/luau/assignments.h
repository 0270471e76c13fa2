// What the text of a script assigns to its variables. One that is set in play, and never set back,
// is a flag: what asks for it comes but once.
#pragma once

#include <map>
#include <string>

#include "import/luau/ast.h"
#include "import/luau/datum.h"

namespace obby::importer::luau {

class Assignments {
 public:
  Assignments() = default;
  explicit Assignments(const Block& chunk) { walk(chunk, true); }

  // Whether all that is assigned to variables of that name is one of true, false and nil. Neither
  // declarations count nor the outermost lines: they say where it begins, and come but once.
  bool isFlag(const std::string& name) const;
  // Whether `value` is what is assigned to the flag.
  bool isSet(const std::string& name, const Datum& value) const;

 private:
  void walk(const Block& block, bool outermost);
  void walk(const Expr& expr);
  void take(const Stat& stat);

  std::map<std::string, unsigned> given_;  // by name, a bit for each kind of value
};

}  // namespace obby::importer::luau
