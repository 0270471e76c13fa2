// Sniffs an input and turns place files into records in memory.
#include "import/filter.h"

#include <optional>
#include <utility>

#include "import/format/read_document.h"
#include "import/rojo/project_reader.h"
#include "io/byte_source.h"
#include "io/read_file.h"

namespace obby::importer {
namespace {

// Waits for enough input to decide whether it may be a place. Also returns false once the source is
// stopped.
Result<bool> mayBePlace(io::ByteSource& source) {
  for (;;) {
    const std::optional<bool> known = mayBeRoblox(source.buffered());
    if (known) return *known;
    OBBY_ASSIGN(const size_t came, source.fill());
    if (came == 0) return false;
  }
}

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
  int& last = lastNumbers_.try_emplace(wanted, 1).first->second;
  while (!names_.insert(name).second) name = wanted + "-" + std::to_string(++last);
  return name;
}

io::StreamReader InputOpener::stream(io::ByteSource source) {
  if (options_.explain) {
    explain_(source.name() + ": nothing to explain: this is a stream of records, not a place\n");
  }
  return io::StreamReader::over(std::move(source));
}

Result<io::StreamReader> InputOpener::records(Import import, const std::string& name) {
  for (const auto& warning : import.warnings) say_(warning);
  if (options_.explain) explain_(import.explanation);
  OBBY_ASSIGN(std::string bytes, recordBytes(import));
  return io::StreamReader::overBytes(std::move(bytes), name);
}

Result<io::StreamReader> InputOpener::openProject(const std::string& path) {
  OBBY_ASSIGN(const rojo::Project project, rojo::readProject(path, stop_));
  ImportOptions options = options_;
  options.name = freeName(options.name.empty() ? project.name : options.name);
  return records(importDocument(project.document, options), path);
}

Result<io::StreamReader> InputOpener::open(const std::string& path) {
  if (rojo::isProject(path)) return openProject(path);
  OBBY_ASSIGN(io::ByteSource source, io::ByteSource::open(path, stop_));
  const std::string name = source.name();
  OBBY_ASSIGN(const bool maybe, mayBePlace(source));
  // Records are read as they arrive: a stream may exceed the memory.
  if (!maybe && !source.stopped()) return stream(std::move(source));
  OBBY_ASSIGN(std::string bytes, io::readRest(source));
  if (!looksLikeRoblox(bytes)) return stream(io::ByteSource::overBytes(std::move(bytes), name));
  ImportOptions options = options_;
  options.name = freeName(options.name.empty() ? levelName(name) : options.name);
  OBBY_ASSIGN(Import import, importPlace(bytes, name, options));
  return records(std::move(import), name);
}

}  // namespace obby::importer
