#include "live.h"

#include "output.h"
#include "reading.h"
#include "view/live.h"

namespace obby {
namespace {

// All records, in the reading thread. Errors are said at once; the page goes on with what there is.
class Reader {
 public:
  Reader(cli::Context& context, view::GrowingReport& report, Reading& reading)
      : context_(context), report_(report), reading_(reading) {}

  void run() {
    while (const auto record = reading_.next()) {
      const Status added = report_.add(*record);
      if (!added) return finish(view::StreamState::broken, added);
    }
    finish(reading_.broken() ? view::StreamState::broken : view::StreamState::ended, {});
  }

 private:
  void finish(view::StreamState state, const Status& why) {
    std::vector<std::string> notes = reading_.notes();
    if (!why) notes.push_back("The input cannot be shown: " + why.error().text());
    say(why);
    say(report_.end(state, notes));
    const bool writes = context_.arguments().has("output");
    const bool empty = context_.errors() > 0 && nothing();
    if (!writes || empty) return;
    say(report_.use([&](const view::Report& report) { return writeReport(report, context_); }));
  }

  // It has been said why.
  bool nothing() {
    bool nothing = false;
    (void)report_.use([&](const view::Report& report) -> Status {
      nothing = report.levels.empty() && report.queries.empty();
      return {};
    });
    return nothing;
  }

  void say(const Status& status) {
    if (!status) context_.error(status.error());
  }

  cli::Context& context_;
  view::GrowingReport& report_;
  Reading& reading_;
};

}  // namespace

Result<cli::ExitCode> runLive(cli::Context& context) {
  const cli::Arguments& arguments = context.arguments();
  const io::StreamIdentity self = context.identity();
  std::unique_ptr<Reading> reading;
  view::GrowingReport report(
      view::Collector([&](const io::Record& record,
                          Error error) { return reading->forgive(record, std::move(error)); },
                      arguments.list("query")));
  view::LiveOptions options;
  options.port = uint16_t(arguments.integer("port"));
  options.endWithPages = arguments.flag("live-exit");
  options.page = {arguments.flag("full"), self.tool + " " + self.version};
  const auto read = [&](const std::atomic<bool>& halt) {
    reading = std::make_unique<Reading>(context, halt);
    Reader(context, report, *reading).run();
  };
  const view::LiveReports reports = {[&](const std::string& text) { context.say(text); },
                                     [&](const std::string& text) { context.note(text); }};
  OBBY_RETURN_IF_ERROR(view::serveLive(report, read, options, context.stop(), reports));
  return cli::ExitCode::ok;
}

}  // namespace obby
