// The importer turns a place or model file into one level record and its stage queries. The scripts
// of the file run in a cage (engine/report.h). docs/import.md says what is recognised and in which
// order evidence counts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "engine/document.h"
#include "io/record.h"

namespace obby::importer {

struct ImportOptions {
  std::string name;        // level name; empty: the file's name without extension
  bool queries = true;     // emit a query for each stage
  bool explain = false;    // fill Import::explanation
  bool runScripts = true;  // if false, script effects are only guessed from the scripts' texts
};

struct Import {
  io::RecordBuilder level;
  std::vector<io::RecordBuilder> queries;
  std::vector<std::string> warnings;  // one line each
  std::string explanation;            // a table of at most 100 columns
};

// Imports one file. Errors name the file and the byte or element.
Result<Import> importPlace(std::string_view bytes, const std::string& file,
                           const ImportOptions& options);

// Returns the level's name for a file: without folder and extension.
std::string levelName(const std::string& file);

Import importDocument(const Document& document, const ImportOptions& options);

}  // namespace obby::importer
