// Sniffs an input and turns place files into records in memory.
#include "import/filter.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "import/read_document.h"

namespace obby::importer {
namespace {

std::string nameInErrors(const std::string& path) { return path == "-" ? "stdin" : path; }

Error inputError(const std::string& path, const std::string& message) {
  Error error = makeError(message);
  error.input = nameInErrors(path);
  return error;
}

struct Close {
  void operator()(std::FILE* file) const {
    if (file != stdin) std::fclose(file);
  }
};

Result<std::string> recordBytes(Import& import) {
  std::string bytes;
  auto writer = io::StreamWriter::toBytes(io::Format::capnp, &bytes);
  OBBY_RETURN_IF_ERROR(writer.write(import.level.reader()));
  for (auto& query : import.queries) OBBY_RETURN_IF_ERROR(writer.write(query.reader()));
  OBBY_RETURN_IF_ERROR(writer.close());
  return bytes;
}

}  // namespace

Result<std::string> readAll(const std::string& path) {
  const std::unique_ptr<std::FILE, Close> file(path == "-" ? stdin
                                                           : std::fopen(path.c_str(), "rb"));
  if (!file) return inputError(path, std::string("cannot open: ") + std::strerror(errno));
  std::string bytes;
  char buffer[1 << 16];
  while (const size_t got = std::fread(buffer, 1, sizeof buffer, file.get()))
    bytes.append(buffer, got);
  if (std::ferror(file.get()))
    return inputError(path, std::string("cannot read: ") + std::strerror(errno));
  return bytes;
}

InputOpener::InputOpener(ImportOptions options, std::function<void(const std::string&)> say,
                         std::function<void(const std::string&)> explain)
    : options_(std::move(options)), say_(std::move(say)), explain_(std::move(explain)) {}

std::string InputOpener::freeName(const std::string& wanted) {
  std::string name = wanted;
  for (int n = 2; std::find(names_.begin(), names_.end(), name) != names_.end(); ++n)
    name = wanted + "-" + std::to_string(n);
  names_.push_back(name);
  return name;
}

Result<io::StreamReader> InputOpener::open(const std::string& path) {
  OBBY_ASSIGN(std::string bytes, readAll(path));
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
