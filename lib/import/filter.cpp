// Sniffs an input and turns place files into records in memory.
#include "import/filter.h"

#include <algorithm>

#include "import/read_document.h"
#include "io/read_file.h"

namespace obby::importer {
namespace {

std::string nameInErrors(const std::string& path) { return path == "-" ? "stdin" : path; }

Result<std::string> recordBytes(Import& import) {
  std::string bytes;
  auto writer = io::StreamWriter::toBytes(io::Format::capnp, &bytes);
  OBBY_RETURN_IF_ERROR(writer.write(import.level.reader()));
  for (auto& query : import.queries) OBBY_RETURN_IF_ERROR(writer.write(query.reader()));
  OBBY_RETURN_IF_ERROR(writer.close());
  return bytes;
}

}  // namespace

InputOpener::InputOpener(ImportOptions options, std::function<void(const std::string&)> say,
                         std::function<void(const std::string&)> explain,
                         const std::atomic<bool>* stop)
    : options_(std::move(options)),
      say_(std::move(say)),
      explain_(std::move(explain)),
      stop_(stop) {}

std::string InputOpener::freeName(const std::string& wanted) {
  std::string name = wanted;
  for (int n = 2; std::find(names_.begin(), names_.end(), name) != names_.end(); ++n)
    name = wanted + "-" + std::to_string(n);
  names_.push_back(name);
  return name;
}

Result<io::StreamReader> InputOpener::open(const std::string& path) {
  OBBY_ASSIGN(std::string bytes, io::readFile(path, stop_));
  const std::string name = nameInErrors(path);
  if (!looksLikeRoblox(bytes)) {
    if (options_.explain) explain_(name + ": a stream of records, no place: nothing to explain\n");
    return io::StreamReader::overBytes(std::move(bytes), name);
  }
  ImportOptions options = options_;
  options.name = freeName(options.name.empty() ? levelName(name) : options.name);
  OBBY_ASSIGN(Import import, importPlace(bytes, name, options));
  for (const auto& warning : import.warnings) say_(warning);
  if (options.explain) explain_(import.explanation);
  OBBY_ASSIGN(std::string records, recordBytes(import));
  return io::StreamReader::overBytes(std::move(records), name);
}

}  // namespace obby::importer
