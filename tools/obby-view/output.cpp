#include "output.h"

#include "formats.h"
#include "options.h"
#include "view/page.h"

namespace obby {

Result<Output> Output::open(const cli::Context& context) {
  OBBY_RETURN_IF_ERROR(pictureOptions(context.arguments()));
  OBBY_ASSIGN(io::Sink sink, context.openSink());
  if (wantedFormat(context.arguments()).binary && sink.terminal()) {
    return makeError("a picture cannot be shown on a terminal",
                     "name a file, as in -o picture.png");
  }
  return Output(std::move(sink));
}

Status Output::write(const view::Report& report, cli::Context& context) {
  const ViewFormat& format = wantedFormat(context.arguments());
  for (const view::QueryEntry& query : report.queries) {
    if (query.mismatch())
      context.warn("query " + query.id +
                   ": a recorded solution cannot be reproduced by replaying it");
  }
  OBBY_ASSIGN(const std::string text, format.render(report, context));
  if (format.page && text.size() > view::kPageWarning) {
    context.warn("the page is " + std::to_string(text.size() >> 20) +
                 " MB, so browsers may show it slowly");
  }
  OBBY_RETURN_IF_ERROR(sink_.write(text));
  return sink_.close();
}

}  // namespace obby
