// Inserts the data into the bundled page.
#include "view/page.h"

#include <fmt/format.h>

#include <cstdint>

#include "io/text.h"
#include "view/page_parts.h"
#include "view/page_template.h"

namespace obby::view {

bool pageAvailable() { return !pageTemplate().empty(); }

Error pageMissing() {
  return makeError("this obby-view was built without the viewer page",
                   "install npm, then configure and build again; or use --format text");
}

namespace {

// `connects`: the page may connect to its own server, and to no other.
std::string filled(std::string_view title, std::string_view data, bool connects) {
  std::string page;
  for (const std::string_view piece : pageTemplate()) page += piece;
  if (connects) {
    page.insert(page.find(kPolicyStart) + kPolicyStart.size(), "; connect-src 'self'");
  }
  // The data comes last, because its text must not be searched for markers.
  page.replace(page.find(kTitleMarker), kTitleMarker.size(), io::escapeMarkup(std::string(title)));
  page.replace(page.rfind(kDataMarker), kDataMarker.size(), data);
  return page;
}

// Writes `<` as \u003c, so that no text can end the script element. In JSON, `<` occurs only in
// strings.
std::string inScript(std::string_view json) {
  std::string out;
  for (size_t end; (end = json.find('<')) != json.npos; json.remove_prefix(end + 1)) {
    out.append(json.substr(0, end)).append("\\u003c");
  }
  return out.append(json);
}

}  // namespace

Error pageTooLarge(size_t bytes, bool full) {
  return makeError(
      fmt::format("the page would be {} MB, too large for a browser", bytes >> 20),
      full ? "leave out --full, or choose queries with --query" : "choose queries with --query");
}

void writeNotes(io::JsonWriter& json, const Report& report, const Budget& budget) {
  json.open('[');
  for (const std::string& note : report.notes) json.value(note);
  for (const std::string& note : budget.notes) json.value(note);
  json.close();
}

std::string pageData(const Report& report, const PageOptions& options) {
  const Budget budget = budgetFor(report, options.full ? SIZE_MAX : kPageTarget);
  io::JsonWriter json;
  json.open('{').field("format", kPageFormat).field("generator", options.generator);
  json.field("title", report.title());
  json.key("notes");
  writeNotes(json, report, budget);
  json.key("levels").open('[');
  const std::vector<uint32_t> ticks = ticksShown(report);
  for (size_t i = 0; i < report.levels.size(); ++i) {
    writeLevel(json, report.levels[i], ticks[i], budget.trackStride);
  }
  json.close().key("queries").open('[');
  for (const QueryEntry& query : report.queries) writeQuery(json, query, budget);
  return inScript(json.finish());
}

Result<std::string> htmlPage(const Report& report, const PageOptions& options) {
  if (!pageAvailable()) return pageMissing();
  const std::string data = pageData(report, options);
  if (data.size() > kPageLimit) return pageTooLarge(data.size(), options.full);
  return filled(report.title(), data, false);
}

Result<std::string> livePage() {
  if (!pageAvailable()) return pageMissing();
  io::JsonWriter json;
  json.open('{').field("format", kPageFormat).field("live", true);
  return filled("obby-view", json.finish(), true);
}

}  // namespace obby::view
