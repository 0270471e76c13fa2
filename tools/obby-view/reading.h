// The inputs of obby-view become a report.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/context.h"
#include "io/pipeline.h"
#include "view/report.h"

namespace obby {

class Reading {
 public:
  // `stop` ends the inputs early.
  Reading(cli::Context& context, const std::atomic<bool>& stop);

  // The next record; nothing at the end. An input that is broken is said to be, and is an end.
  std::optional<io::Record> next();
  // Whether that end was a broken input.
  bool broken() const { return broken_; }

  // Says why no more of the input can be shown.
  void cannotShow(const Error& error);
  // Reads on, up to the end or what cannot be read, and keeps nothing: who writes into a pipe of
  // which nobody reads the rest would wait as long as the page stays.
  void drain();

  // For view::Collector.
  Status forgive(const io::Record& record, Error error);

  // Behind the end. Reports that the input lacks something, unless an error explains why: one that
  // has been reported, or that stopped the program which wrote the input.
  void reportLack(const Error& lack);

  // Behind the end, for the reader of the report: what is missing and why.
  std::vector<std::string> notes(const view::Report& report) const;

 private:
  cli::Context& context_;
  io::RecordSource source_;
  std::vector<std::string> notes_;
  bool broken_ = false;
};

// The error of a report that is empty.
Error nothingToShow();

// Reads all of it. A broken input is reported, as is what cannot be shown; what came before it is
// shown. Nothing: there is nothing to show, or a query that was asked for did not come, which has
// been reported.
std::optional<view::Report> readReport(cli::Context& context);

}  // namespace obby
