#include "reading.h"

#include <fmt/format.h>

#include <exception>

namespace obby {
namespace {

io::SourceOptions optionsOf(cli::Context& context, const std::atomic<bool>& stop) {
  io::SourceOptions options = context.sourceOptions();
  options.stop = &stop;
  return options;
}

std::string budgetNote(const view::Report& report) {
  size_t answered = 0, unknown = 0;
  for (const view::QueryEntry& query : report.queries) {
    if (!query.result) continue;
    ++answered;
    if (query.answer().getVerdict() == schema::Verdict::UNKNOWN) ++unknown;
  }
  if (answered < 2 || unknown == 0) return "The search reached its time or step limit.";
  return fmt::format("The search reached its time or step limit for {} of {} queries.", unknown,
                     answered);
}

}  // namespace

Reading::Reading(cli::Context& context, const std::atomic<bool>& stop)
    : context_(context), source_(optionsOf(context, stop)) {}

std::optional<io::Record> Reading::next() {
  auto next = source_.next();
  if (next) return *std::move(next);
  context_.error(next.error());
  notes_.push_back("Reading stopped at an error: " + next.error().text());
  broken_ = true;
  return {};
}

void Reading::cannotShow(const Error& error) {
  context_.error(error);
  notes_.push_back("Some of the input cannot be shown: " + error.text());
}

void Reading::drain() {
  source_.ignoreErrors();
  try {
    for (;;) {
      const auto next = source_.next();
      if (!next || !*next) return;
    }
  } catch (const std::exception&) {  // probably out of memory; the records read so far are kept
  }
}

Status Reading::forgive(const io::Record& record, Error error) {
  // The source knows its current input, but not the input of earlier records.
  const std::vector<std::string>& inputs = context_.inputs();
  if (inputs.size() == 1) error.input = inputs[0] == "-" ? "stdin" : inputs[0];
  return source_.forgive(record, std::move(error));
}

void Reading::reportLack(const Error& lack) {
  if (context_.errors() == 0) context_.error(source_.lacking(lack));
}

std::vector<std::string> Reading::notes(const view::Report& report) const {
  std::vector<std::string> notes = notes_;
  switch (source_.status()) {
    case schema::EndStatus::FAILED:
      notes.push_back("The program that wrote the input ended with an error.");
      break;
    case schema::EndStatus::INTERRUPTED:
      notes.push_back("The run was interrupted before it had answered every query.");
      break;
    case schema::EndStatus::BUDGET: notes.push_back(budgetNote(report)); break;
    case schema::EndStatus::COMPLETE: break;
  }
  return notes;
}

Error nothingToShow() {
  return makeError("the input has nothing to show", "give levels, queries or results as input");
}

std::optional<view::Report> readReport(cli::Context& context) {
  Reading reading(context, context.stop());
  view::Collector collector([&](const io::Record& record,
                                Error error) { return reading.forgive(record, std::move(error)); },
                            context.arguments().list("query"));
  Status shown;
  while (shown) {
    const auto record = reading.next();
    if (!record) break;
    shown = collector.add(*record);
  }
  Status played = collector.update();
  if (shown) shown = std::move(played);
  if (!shown) reading.cannotShow(shown.error());
  if (const Status chosen = collector.checkChosen(); !chosen) {
    reading.reportLack(chosen.error());
    return {};
  }
  view::Report report = collector.take();
  if (report.empty()) {
    reading.reportLack(nothingToShow());
    return {};
  }
  const std::vector<std::string> notes = reading.notes(report);
  report.notes.insert(report.notes.end(), notes.begin(), notes.end());
  return report;
}

}  // namespace obby
