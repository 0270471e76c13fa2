// obby-view: streams in, a page or a text out.
#include "formats.h"
#include "options.h"
#include "view/page.h"

namespace obby {
namespace {

// Reads the inputs to their end. A broken input is reported, and what came before it is shown.
Result<view::Report> readReport(cli::Context& context) {
  io::RecordSource source(context.sourceOptions());
  const std::vector<std::string>& inputs = context.inputs();
  view::Collector collector([&](const io::Record& record, Error error) {
    // The source knows which input it reads, but not where a record of before came from.
    if (inputs.size() == 1) error.input = inputs[0] == "-" ? "stdin" : inputs[0];
    return source.forgive(record, std::move(error));
  });
  std::vector<std::string> notes;
  for (;;) {
    auto next = source.next();
    if (!next) {
      context.error(next.error());
      notes.push_back("The input broke off: " + next.error().text());
      break;
    }
    if (!*next) break;
    OBBY_RETURN_IF_ERROR(collector.add(**next));
  }
  OBBY_ASSIGN(view::Report report, collector.finish(context.arguments().list("query")));
  if (source.status() == schema::EndStatus::INTERRUPTED) {
    notes.push_back("The work was interrupted before every query had its answer.");
  } else if (source.status() == schema::EndStatus::BUDGET) {
    notes.push_back("A budget was spent before every query had its answer.");
  }
  report.notes.insert(report.notes.end(), notes.begin(), notes.end());
  return report;
}

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
