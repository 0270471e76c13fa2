// The importer: a place or model file in, one level record and its stage queries out. The
// scripts in it run in a cage (engine/report.h). docs/import.md says what is recognised and in
// which order evidence counts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "engine/document.h"
#include "io/record.h"

namespace obby::importer {

struct ImportOptions {
  std::string name;        // of the level; empty: the file's name without folder and ending
  bool queries = true;     // a query for each stage
  bool explain = false;    // fill Import::explanation
  bool runScripts = true;  // else what they do is missing, but for guesses from their texts
};

struct Import {
  io::RecordBuilder level;
  std::vector<io::RecordBuilder> queries;
  std::vector<std::string> warnings;  // one line each, for people
  std::string explanation;            // a table of at most 100 columns
};

// Errors name the file and the byte or element.
Result<Import> importPlace(std::string_view bytes, const std::string& file,
                           const ImportOptions& options);

// The level's name for a file: without folder and ending.
std::string levelName(const std::string& file);

Import importDocument(const Document& document, const ImportOptions& options);

}  // namespace obby::importer
