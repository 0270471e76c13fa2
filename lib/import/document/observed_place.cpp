#include "import/document/observed_place.h"

#include "import/document/line_index.h"

namespace obby::importer {

std::string lineReason(const Tree& tree, engine::Line line) {
  if (line.script >= tree.size()) return "a script";
  const Instance& script = tree.at(line.script);
  std::string reason = "script " + script.name;
  if (line.line <= 0) return reason;
  reason += " line " + std::to_string(line.line);
  const auto* source = property<std::string>(script, "Source");
  const auto text = source ? LineIndex(*source).line(size_t(line.line)) : std::nullopt;
  if (!text) return reason;
  return reason + ": " + quoteOf(*text);
}

}  // namespace obby::importer
