// The contents of a Record. Private to lib/io.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/format.h"
#include "io/record.h"

namespace obby::io {

struct Record::Storage {
  std::optional<RecordBuilder> decoded;  // nothing for an unknown kind or an unreadable record
  // The record could not be read, and its error has been reported.
  bool unreadable = false;
  Format format = Format::jsonl;
  std::string raw;  // the line without its newline, or the message; empty if made here
  std::string input, place;
  std::vector<Error> misspelt;  // as from recordFromJsonIfKnown()
};

}  // namespace obby::io
