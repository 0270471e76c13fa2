#include "train/csv_log.h"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>

#include "io/read_file.h"
#include "io/sink.h"

namespace obby::train {

namespace {

std::string rowOf(const std::string& first, std::span<const Metric> metrics, bool names) {
  std::string row = first;
  for (const bool clock : {false, true}) {
    for (const Metric& m : metrics) {
      if (m.clock == clock) row += names ? fmt::format(",{}", m.name) : fmt::format(",{}", m.value);
    }
  }
  return row + "\n";
}

std::string header() { return rowOf("iteration", metricsOf({}, 0, 0), true); }

// Returns the header and whole rows of iterations up to `kept`; the header alone for an empty file.
Result<std::string> keptOf(const std::string& path, uint64_t kept) {
  OBBY_ASSIGN(const std::string text, io::readFile(path));
  const std::string head = header();
  if (!text.empty() && text.compare(0, head.size(), head) != 0) {
    return Error{
        path, "1", {}, "not a log of this version's metrics", "name another file with --log"};
  }
  std::string out = head;
  for (size_t at = head.size(); at < text.size();) {
    const size_t end = text.find('\n', at);
    uint64_t iteration = 0;
    const auto read = std::from_chars(text.data() + at, text.data() + text.size(), iteration);
    if (end == std::string::npos || read.ec != std::errc() || iteration > kept) break;
    out.append(text, at, end + 1 - at);
    at = end + 1;
  }
  return out;
}

}  // namespace

Result<CsvLog> CsvLog::open(const std::string& path, uint64_t kept, const std::atomic<bool>* stop) {
  std::error_code none;
  const auto kind = std::filesystem::status(path, none).type();
  const bool there = kind == std::filesystem::file_type::regular;
  std::string text = header();
  if (there && kept > 0) {
    OBBY_ASSIGN(text, keptOf(path, kept));
  }
  if (there || kind == std::filesystem::file_type::not_found) {
    OBBY_ASSIGN(io::Sink sink, io::Sink::open(path));
    OBBY_RETURN_IF_ERROR(sink.write(text));
    OBBY_RETURN_IF_ERROR(sink.close());
    text.clear();
  }
  OBBY_ASSIGN(io::Appender file, io::Appender::open(path, stop));
  OBBY_RETURN_IF_ERROR(file.append(text));  // a device or a pipe
  return CsvLog(PatientLog(std::move(file)));
}

Status CsvLog::add(uint64_t iteration, std::span<const Metric> metrics) {
  return file_.add(rowOf(fmt::format("{}", iteration), metrics, false));
}

}  // namespace obby::train
