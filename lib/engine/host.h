// Functions that C++ offers to the runtime (api/*.luau) in its table `host`. A Host belongs to one
// VM. Each host_*.cpp registers the functions of one concern. Private to lib/engine.
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
  // Returns the id in a chunk's name "=#12"; kNoInstance for the runtime's own chunks.
  static InstanceId scriptOf(const char* source);

  // Loads the runtime's file of that name once and pushes its result.
  int use(lua_State* L, const std::string& name);
  // Returns the innermost line of the running script.
  Line where(lua_State* L) const;
  // Returns "#12:34: text" as "Script:34: text".
  std::string withNames(std::string text) const;

  const Document& document;
  const Settings settings;
  const ClassTable& classes;
  Vm vm;
  Scenery scenery;
  Recorder recorder;
  Random random;

  std::vector<InstanceId> owners;  // script by owner; owner 0 is no script
  uint32_t running = 0;            // owner of the code that runs
  unsigned beat = 0;               // grows when a script begins or stops running
  InstanceId nextMade = kMade;
  size_t instancesMade = 0;
  double tinySteps = 0;
  InstanceId greedy = kNoInstance;  // script that has used up the memory
  InstanceId slow = kNoInstance;    // last script that has used up its time
  std::set<InstanceId> limited;     // scripts that ran out of time or used unsupported features
  std::string refused;              // last error that the real engine raises, too
  // Records from an error's text that a script ran out of time or memory.
  void noteError(InstanceId script, std::string_view text);
};

// Each function adds the host functions of one concern to the table at the top of the stack.
void registerClassFunctions(lua_State* L);
void registerSceneryFunctions(lua_State* L);
void registerRecordFunctions(lua_State* L);
void registerScriptFunctions(lua_State* L);
void registerValueFunctions(lua_State* L);
void registerByteFunctions(lua_State* L);

// Pushes a property's value as scripts see it. An enum item becomes its number, a reference nil.
void pushValue(lua_State* L, const Value& value);
// Returns the value at a positive index; a monostate if it has no plain form.
Plain plainAt(lua_State* L, int index);

}  // namespace obby::engine
