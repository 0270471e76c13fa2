// What variables, and fields of tables, hold from one handler to the next. Which of them comes
// first nobody knows: each finds what the script has left there as it began, or either, where
// another one sets something else.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/luau/ast.h"
#include "import/luau/assignments.h"
#include "import/luau/datum.h"

namespace obby::importer::luau {

using namespace obby::luau;

// The names of a scope, or the fields of a table.
using Held = std::map<std::string, Datum>;

class Variables {
 public:
  using Place = std::pair<Held*, std::string>;
  using Found = std::vector<std::pair<Place, Datum>>;

  // Of a handler; `eachFrame`: it counts by what it finds of its own. `found`: what stands in
  // places by the time that another handler makes it.
  void beginHandler(const Function* body, bool eachFrame, const Found& found);
  // Of a thread: it finds what the script has left there, too.
  void beginThread(const Function* body);
  // What has been set since beginHandler is set back. A variable that held nothing keeps a thing
  // that it was given: what the handler connects finds it there. Does nothing outside of handlers.
  void endHandler();
  // Of a thread's loop; `endless`: what it sets to and fro may be either by the time of a handler.
  void beginLoop();
  void endLoop(bool endless);

  // Things, and with `numbers` these, too, that the handler has set so far; none where they are
  // very many. Flags may be others by the time that they are asked for.
  Found heldNow(bool numbers) const;

  // Of a branch that may not be taken: what it sets is one of two values behind it. `left`: what is
  // behind it comes only if it is not taken. `defaulted`: the name that the branch is a default of;
  // it counts where the text does not tell the value. Gives how many places the branch has set.
  void beginBranch() { branches_.emplace_back(); }
  size_t endBranch(bool left, const std::string& defaulted);

  // Of a scope or table that is new: what a branch makes itself is as the branch leaves it.
  void make(const Held& held) {
    if (!branches_.empty()) branches_.back().made.insert(&held);
  }

  // `own`: of what the handler that is followed has made itself: nobody finds it before.
  void set(Held& held, const std::string& name, Datum value, bool own);
  // Nil where there is none; unknown where another handler, or this one another time, may have set
  // it to another flag, number or text. What this one states itself is left to the flags: see
  // Assignments. A flag that all of them set but for a time, this one too, is as they leave it.
  // In a thread what is false or nil is unknown where a handler that came before it has set it.
  Datum get(Held& held, const std::string& name, bool own) const;

  // From here on the handler goes by what it finds there the first time.
  void settle(Held& held, const std::string& name);

  // From here on handlers are read once more: what any of them, this one too, sets to another flag,
  // number or text may be either, and so may what it sets in a branch that may not be taken.
  void readAgain() { again_ = true; }

  // Keeps in mind what a function sets that is called at a time of its own, and what the functions
  // do that it calls. Gives how many places and calls that are.
  size_t note(const Closure& closure);

 private:
  using Olds = std::map<Place, std::optional<Datum>>;  // nothing: there was no such field
  struct Given {
    const Function* by = nullptr;  // null: a loop, or too many to tell
    Datum value;                   // unknown: the text states none
    bool followed = false;         // it has been read; else the text has it
    bool passing = false;          // as of a Setting
  };
  struct Branch {
    Olds olds;                   // before it
    std::set<const Held*> made;  // in it
  };
  using Functions = std::set<const Function*>;
  size_t note(const Closure& closure, const Function* by, Functions& seen);
  void add(const Place& place, const Given& given);
  void doubt(const Place& place, const std::optional<Datum>& old, Datum& now, bool isDefault);

  const Function* body_ = nullptr;  // of the handler that is followed
  bool inHandler_ = false, eachFrame_ = false, inThread_ = false, inLoop_ = false, again_ = false;
  Olds before_;                   // the handler
  std::vector<Branch> branches_;  // those that are open
  std::map<Place, bool> looped_;  // set in the loop; true: to and fro
  std::map<Place, std::vector<Given>> given_;
  std::map<const Function*, Settings> settings_;
};

}  // namespace obby::importer::luau
