// obby-view: streams in, a page or a text out.
#include "formats.h"
#include "options.h"
#include "reading.h"
#include "view/page.h"

namespace obby {
namespace {

Result<cli::ExitCode> run(cli::Context& context) {
  const ViewFormat& format = wantedFormat(context.arguments());
  const bool page = format.name == std::string("html");
  if (page && !view::pageAvailable()) return view::pageMissing();
  OBBY_ASSIGN(const view::Report report, readReport(context));
  if (report.levels.empty() && report.queries.empty()) {
    if (context.errors() > 0) return cli::ExitCode::failed;
    return makeError("the input holds nothing to show", "give it levels, queries or results");
  }
  for (const view::QueryEntry& query : report.queries) {
    if (query.mismatch()) context.warn("query " + query.id + ": a solution does not replay");
  }
  OBBY_ASSIGN(const std::string text, format.render(report, context));
  if (page && text.size() > view::kPageWarning) {
    context.warn("the page is " + std::to_string(text.size() >> 20) + " MB; browsers may be slow");
  }
  OBBY_ASSIGN(io::Sink sink, context.openSink());
  if (format.binary && sink.terminal())
    return makeError("a picture is nothing for a terminal", "name a file: -o picture.png");
  OBBY_RETURN_IF_ERROR(sink.write(text));
  OBBY_RETURN_IF_ERROR(sink.close());
  return cli::ExitCode::ok;
}

}  // namespace
}  // namespace obby

int main(int argc, char** argv) {
  return obby::cli::runTool(obby::viewSpec(), argc, argv, obby::run);
}
