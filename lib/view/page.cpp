// Puts the data into the bundled page.
#include "view/page.h"

#include <fmt/format.h>

#include "io/text.h"
#include "view/page_parts.h"
#include "view/page_template.h"

namespace obby::view {

bool pageAvailable() { return !pageTemplate().empty(); }

Error pageMissing() {
  return makeError("this obby-view was built without the viewer page",
                   "install npm and build again from a fresh cmake run; or use --format text");
}

std::string pageData(const Report& report, const PageOptions& options) {
  const Budget budget = options.full ? Budget{} : budgetFor(report, kPageTarget);
  JsonText json;
  json.open('{').field("format", 2).field("generator", options.generator);
  json.field("title", report.title());
  json.key("notes").open('[');
  for (const std::string& note : report.notes) json.value(note);
  for (const std::string& note : budget.notes) json.value(note);
  json.close().key("levels").open('[');
  for (size_t i = 0; i < report.levels.size(); ++i) {
    writeLevel(json, report.levels[i], ticksShown(report, int(i)), budget.trackStride);
  }
  json.close().key("queries").open('[');
  for (const QueryEntry& query : report.queries) writeQuery(json, query, budget);
  json.close().close();
  return json.text();
}

Result<std::string> htmlPage(const Report& report, const PageOptions& options) {
  if (!pageAvailable()) return pageMissing();
  std::string page;
  for (const std::string_view piece : pageTemplate()) page += piece;
  const std::string data = pageData(report, options);
  if (data.size() > kPageLimit) {
    return makeError(
        fmt::format("the page would hold {} MB, which no browser opens", data.size() >> 20),
        "leave out --full, or choose queries with --query");
  }
  // The data last: its text must not be searched for markers.
  const size_t title = page.find(kTitleMarker);
  page.replace(title, kTitleMarker.size(), io::escapeMarkup(report.title()));
  const size_t at = page.rfind(kDataMarker);
  page.replace(at, kDataMarker.size(), data);
  return page;
}

}  // namespace obby::view
