// Order of the pieces, and which maps are drawn.
#include "view/text_report.h"

#include <fmt/format.h>

#include "io/utf8.h"

namespace obby::view {
namespace {

constexpr size_t kMostMaps = 3;

std::string clean(const std::string& text, const TerminalTraits& terminal) {
  return io::tamed(text, !terminal.utf8);
}

}  // namespace

std::string textReport(const Report& report, const TextOptions& options) {
  std::string out;
  if (report.queries.empty()) {
    out += "No queries.\n";
    for (const LevelEntry& level : report.levels) {
      out += fmt::format("Level {}: {} parts\n", clean(level.level->name(), options.terminal),
                         level.level->partCount());
    }
  } else {
    out += queryTable(report, options.terminal);
  }
  for (const std::string& note : report.notes) out += clean(note, options.terminal) + "\n";
  if (!options.maps) return out;
  if (report.queries.size() > kMostMaps) {
    return out + fmt::format("\nMaps are drawn for up to {} queries: choose with --query ID.\n",
                             kMostMaps);
  }
  for (const QueryEntry& query : report.queries) {
    const std::string map = queryMap(report, query, options.terminal);
    if (!map.empty()) out += "\n" + map;
  }
  return out;
}

}  // namespace obby::view
