// What the runtime (api/*.luau) asks of C++: the functions of its table `host`. A Host belongs to
// one VM; all of its parts are here, and each host_*.cpp registers the functions of one concern.
// Private to lib/engine.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "engine/classes/class_table.h"
#include "engine/document.h"
#include "engine/recorder.h"
#include "engine/scenery.h"
#include "engine/settings.h"
#include "engine/values/random.h"
#include "engine/vm/vm.h"

namespace obby::engine {

class Host {
 public:
  Host(const Document& document, const Settings& settings);
  static Host& of(lua_State* L) { return *static_cast<Host*>(Vm::ownerOf(L)); }
  // The id in a chunk's name "=#12"; kNoInstance for the runtime's own chunks.
  static InstanceId scriptOf(const char* source);

  // Loads the runtime's file of that name and leaves its result on the stack; later calls find it.
  int use(lua_State* L, const std::string& name);
  // The innermost line of a script that is running.
  Line where(lua_State* L) const;
  // "#12:34: text" as "Script:34: text".
  std::string withNames(std::string text) const;

  const Document& document;
  const Settings settings;
  const ClassTable& classes;
  Vm vm;
  Scenery scenery;
  Recorder recorder;
  Random random;

  std::vector<InstanceId> owners;  // their scripts; owner 0 is nobody
  uint32_t running = 0;            // the owner whose code runs
  unsigned beat = 0;               // grows with each stretch
  InstanceId nextMade = kMade;
  size_t instancesMade = 0;
  double tinySteps = 0;
  InstanceId greedy = kNoInstance;  // the script that has used up the memory
  InstanceId slow = kNoInstance;    // the last that had used up its time
  std::set<InstanceId> limited;     // scripts that have used what the twin does not do
  std::string refused;              // the last error that the engine itself raises, by its rules
  // Takes note of an error by its text.
  void noteError(InstanceId script, std::string_view text);
};

// Each sets functions of the table at the top of the stack.
void registerClassFunctions(lua_State* L);
void registerSceneryFunctions(lua_State* L);
void registerRecordFunctions(lua_State* L);
void registerScriptFunctions(lua_State* L);
void registerValueFunctions(lua_State* L);
void registerByteFunctions(lua_State* L);

// A property's value, as scripts have it, on the stack; an enum's item as its number, a reference
// as nil.
void pushValue(lua_State* L, const Value& value);
// The value at a positive index, as far as it has a plain form.
Plain plainAt(lua_State* L, int index);

}  // namespace obby::engine
