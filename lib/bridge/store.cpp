#include "bridge/store.h"

#include <errno.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <filesystem>

#include "base/hash.h"
#include "io/json_tree.h"
#include "io/read_file.h"
#include "io/version.h"

namespace obby::bridge {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::hours kAnswerAge{24};         // max age of answers that a crash left behind
constexpr uint64_t kOtherHalf = 0x6f62627931323821;  // seeds the other 64 bits of an id

Error folderError(const std::string& path, const std::string& what) {
  return Error{path, {}, {}, what, "name another folder with --state-dir"};
}

Status makePrivate(const std::string& path) {
  std::error_code error;
  const fs::path parent = fs::path(path).parent_path();
  if (!parent.empty()) fs::create_directories(parent, error);
  if (!error && mkdir(path.c_str(), 0700) != 0 && errno != EEXIST) {
    error = std::error_code(errno, std::generic_category());
  }
  if (error) return folderError(path, "cannot create the folder: " + error.message());
  struct stat about {};
  if (stat(path.c_str(), &about) != 0 || !S_ISDIR(about.st_mode)) {
    return folderError(path, "this is not a folder");
  }
  if (about.st_uid != geteuid()) return folderError(path, "the folder belongs to another user");
  if ((about.st_mode & 077) != 0 && chmod(path.c_str(), 0700) != 0) {
    return folderError(path, std::string("cannot make the folder private: ") + strerror(errno));
  }
  return {};
}

void removeOldAnswers(const std::string& folder) {
  std::error_code ignored;
  const auto now = fs::file_time_type::clock::now();
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const auto changed = entry.last_write_time(ignored);
    if (!ignored && now - changed > kAnswerAge) fs::remove(entry.path(), ignored);
  }
}

}  // namespace

Result<Store> Store::open(const std::string& folder, const Limits& limits) {
  Store out;
  out.folder_ = folder;
  out.maxBytes_ = limits.storeBytes;
  for (const char* part : {"", "/levels", "/answers"}) {
    OBBY_RETURN_IF_ERROR(makePrivate(folder + part));
  }
  removeOldAnswers(folder + "/answers");
  return out;
}

std::string Store::idOf(std::string_view bytes) {
  // Another version of our tools may read the same bytes differently.
  const std::string_view version = io::toolVersion();
  const auto half = [&](uint64_t seed) {
    return hashBytes(bytes.data(), bytes.size(), hashBytes(version.data(), version.size(), seed));
  };
  return fmt::format("{:016x}{:016x}", half(0), half(kOtherHalf));
}

std::string Store::levelPath(const std::string& id) const {
  return folder_ + "/levels/" + id + ".jsonl";
}

bool Store::has(const std::string& id) const { return access(levelPath(id).c_str(), R_OK) == 0; }

void Store::evictFor(uint64_t bytes) const {
  struct Entry {
    fs::path path;
    uint64_t size;
    fs::file_time_type used;
  };
  std::vector<Entry> entries;
  std::error_code error;
  uint64_t total = bytes;
  for (const auto& file : fs::directory_iterator(folder_ + "/levels", error)) {
    const uint64_t size = file.file_size(error);
    if (error) continue;
    entries.push_back({file.path(), size, file.last_write_time(error)});
    total += size;
  }
  std::sort(entries.begin(), entries.end(),
            [](const Entry& a, const Entry& b) { return a.used < b.used; });
  for (const Entry& entry : entries) {
    if (total <= maxBytes_) return;
    if (fs::remove(entry.path, error)) total -= entry.size;
  }
}

Status Store::put(const std::string& id, std::string_view lines,
                  const std::vector<std::string>& reports) const {
  uint64_t bytes = lines.size();
  for (const std::string& report : reports) bytes += report.size() + 1;
  evictFor(bytes);
  OBBY_ASSIGN(io::Sink sink, io::Sink::open(levelPath(id)));
  OBBY_RETURN_IF_ERROR(sink.write(lines));
  for (const std::string& report : reports) OBBY_RETURN_IF_ERROR(sink.write(report + "\n"));
  return sink.close();
}

Result<std::optional<StoredLevel>> Store::get(const std::string& id) const {
  const std::string path = levelPath(id);
  if (!has(id)) return std::optional<StoredLevel>();
  OBBY_ASSIGN(const std::string text, io::readFile(path));
  std::error_code ignored;
  fs::last_write_time(path, fs::file_time_type::clock::now(),
                      ignored);  // evictFor() reads this time
  StoredLevel out;
  for (size_t at = 0; at < text.size();) {
    const size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
    const std::string_view line = std::string_view(text).substr(at, end - at);
    const std::string_view type = typeOfLine(line);
    if (type == "level") {
      out.levels += line;
    } else {
      (type == "query" ? out.queries : out.reports).emplace_back(line.substr(0, line.find('\n')));
    }
    at = end;
  }
  return std::optional(std::move(out));
}

std::string Store::answerPath(const std::string& session, const std::string& job) const {
  return fmt::format("{}/answers/{}-{}.jsonl", folder_, session, job);
}

void Store::removeAnswer(const std::string& path) const {
  std::error_code ignored;
  fs::remove(path, ignored);
}

std::string_view typeOfLine(std::string_view line) {
  constexpr std::string_view kBegin = "{\"type\":\"";  // lib/io writes the type first
  if (line.substr(0, kBegin.size()) != kBegin) return {};
  const std::string_view rest = line.substr(kBegin.size());
  const size_t end = rest.find('"');
  return end == std::string_view::npos ? std::string_view() : rest.substr(0, end);
}

std::string queryIdOfLine(std::string_view line) {
  const auto tree = io::JsonTree::parse(line);
  const io::JsonTree::Node* id = tree ? tree->find(tree->root(), "id") : nullptr;
  return id && id->type == io::JsonTree::Type::text ? std::string(tree->text(*id)) : std::string();
}

}  // namespace obby::bridge
