#include "output.h"

#include "formats.h"
#include "view/page.h"

namespace obby {

Status writeReport(const view::Report& report, cli::Context& context) {
  const ViewFormat& format = wantedFormat(context.arguments());
  if (report.levels.empty() && report.queries.empty()) {
    return makeError("the input holds nothing to show", "give it levels, queries or results");
  }
  for (const view::QueryEntry& query : report.queries) {
    if (query.mismatch()) context.warn("query " + query.id + ": a solution does not replay");
  }
  OBBY_ASSIGN(const std::string text, format.render(report, context));
  if (format.page && text.size() > view::kPageWarning) {
    context.warn("the page is " + std::to_string(text.size() >> 20) + " MB; browsers may be slow");
  }
  OBBY_ASSIGN(io::Sink sink, context.openSink());
  if (format.binary && sink.terminal())
    return makeError("a picture is nothing for a terminal", "name a file: -o picture.png");
  OBBY_RETURN_IF_ERROR(sink.write(text));
  return sink.close();
}

}  // namespace obby
