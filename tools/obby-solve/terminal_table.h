// At a terminal people read the answers: a table takes the place of the records.
#pragma once

#include <memory>
#include <optional>

#include "cli/context.h"
#include "table/gathering.h"

namespace obby::tools {

class TerminalTable {
 public:
  // Nothing: the records are to be written.
  static std::optional<TerminalTable> wanted(const cli::Context& context);

  // Gathers the answers from what is written to it.
  io::StreamWriter writer() const;
  // Writes the table to standard output; nothing where there are no answers.
  Status print(cli::Context& context) const;

 private:
  TerminalTable() = default;

  // Shared with the writer.
  std::shared_ptr<table::Gathering> gathering_ = std::make_shared<table::Gathering>();
};

}  // namespace obby::tools
