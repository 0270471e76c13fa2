#include "import/script_side.h"

namespace obby::importer {

bool runsOnClient(const Instance& script) {
  const auto* context = property<EnumItem>(script, "RunContext");
  return script.className == "LocalScript" || (context && context->value == kRunClient);
}

}  // namespace obby::importer
