// obby-import as a filter: opens each input, of any kind, as a stream of records.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <unordered_map>
#include <unordered_set>

#include "base/result.h"
#include "import/importer.h"
#include "io/stream.h"

namespace obby::importer {

// Gives different names to the levels of several inputs, and reports warnings to the user.
class InputOpener {
 public:
  // `say` receives the warnings of an import. `explain` receives its table if options.explain is
  // set. `stop` is passed to io::readFile.
  InputOpener(ImportOptions options, std::function<void(const std::string&)> say,
              std::function<void(const std::string&)> explain,
              const std::atomic<bool>* stop = nullptr);

  // Opens one input. A place or model file, or a Rojo project, becomes its level and queries. Any
  // other input is read as a stream of records as they arrive. `path` "-" is standard input. Errors
  // name the input.
  Result<io::StreamReader> open(const std::string& path);

 private:
  std::string freeName(const std::string& wanted);
  io::StreamReader stream(io::ByteSource source);
  Result<io::StreamReader> records(Import import, const std::string& name);
  Result<io::StreamReader> openProject(const std::string& path);

  ImportOptions options_;
  std::function<void(const std::string&)> say_, explain_;
  const std::atomic<bool>* stop_;
  std::unordered_set<std::string> names_;
  // Last suffix by wanted name. The first level has no suffix.
  std::unordered_map<std::string, int> lastNumbers_;
};

}  // namespace obby::importer
