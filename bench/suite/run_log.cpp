#include "suite/run_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <utility>

#include "io/byte_source.h"
#include "io/json_tree.h"
#include "io/json_writer.h"

namespace obby::bench {
namespace {

// Reads the members of a flat object.
class Members {
 public:
  explicit Members(const io::JsonTree& tree) : tree_(tree) {}

  std::string text(std::string_view name) { return textOf(need(name)); }
  std::string textIfAny(std::string_view name) { return textOf(find(name)); }
  double number(std::string_view name) {
    const Found value = need(name);
    if (!value) return 0;
    using Type = io::JsonTree::Type;
    if (value->type == Type::whole) return double(value->value);
    if (value->type == Type::yes || value->type == Type::no) return value->type == Type::yes;
    if (value->type == Type::real)
      return std::strtod(std::string(tree_.text(*value)).c_str(), nullptr);
    complete_ = false;
    return 0;
  }
  // 64-bit values are written as text, as in the streams.
  uint64_t digest(std::string_view name) { return std::strtoull(text(name).c_str(), nullptr, 10); }
  bool complete() const { return complete_; }

 private:
  using Found = const io::JsonTree::Node*;

  std::string textOf(Found value) const { return value ? std::string(tree_.text(*value)) : ""; }
  Found need(std::string_view name) {
    const Found value = find(name);
    if (!value) complete_ = false;
    return value;
  }
  Found find(std::string_view name) const { return tree_.find(tree_.root(), name); }

  const io::JsonTree& tree_;
  bool complete_ = true;
};

bool counts(const Run& run, const Maker& maker) {
  return (maker.program == 0 || run.program == maker.program) &&
         (maker.threads == 0 || run.threads == maker.threads) &&
         (!maker.machine || run.machine == *maker.machine);
}

}  // namespace

std::string Run::key() const {
  return fmt::format("{} {:016x} {} {:g}", method, content, seed, cap);
}

std::string runLine(const Run& r) {
  io::JsonWriter json;
  json.open('{').field("method", r.method).field("file", r.file).field("query", r.query);
  json.field("seed", r.seed).field("verdict", r.verdict).field("expected", r.expected);
  json.key("seconds").raw(fmt::format("{:.4f}", r.timing.seconds));
  json.key("steps").raw(fmt::format("{:.0f}", r.timing.steps));
  json.key("rounds").raw(fmt::format("{:.0f}", r.timing.rounds));
  json.key("cap").raw(fmt::format("{:g}", r.cap)).field("threads", r.threads);
  json.field("machine", r.machine).field("content", std::to_string(r.content));
  return json.field("program", std::to_string(r.program)).finish() + "\n";
}

Result<Run> parseRun(const std::string& line) {
  OBBY_ASSIGN(const io::JsonTree tree, io::JsonTree::parse(line));
  Members m(tree);
  Run r;
  r.method = m.text("method");
  r.file = m.text("file");
  r.query = m.text("query");
  r.verdict = m.text("verdict");
  r.expected = m.text("expected");
  r.seed = uint64_t(m.number("seed"));
  r.cap = m.number("cap");
  r.threads = int(m.number("threads"));
  r.machine = m.textIfAny("machine");
  r.content = m.digest("content");
  r.program = m.digest("program");
  r.timing = {m.number("seconds"), r.verdict == "solved", m.number("steps"), m.number("rounds")};
  if (!m.complete()) return makeError("this line is not a run");
  return r;
}

Result<RunLog> RunLog::open(const std::string& path) {
  RunLog log;
  log.path_ = path;
  std::ifstream file(path, std::ios::binary);
  std::string line;
  while (std::getline(file, line)) {
    log.cutOff_ = file.eof();
    auto run = parseRun(line);
    if (run) {
      log.remember(*std::move(run));
    } else {
      ++log.unreadable_;
    }
  }
  if (file.bad()) return io::fileError(path, "cannot read");
  return log;
}

void RunLog::remember(Run run) {
  byKey_[run.key()].push_back(runs_.size());
  runs_.push_back(std::move(run));
}

const Run* RunLog::find(const std::string& key, const Maker& maker) const {
  const auto found = byKey_.find(key);
  if (found == byKey_.end()) return nullptr;
  for (size_t i = found->second.size(); i-- > 0;) {
    const Run& run = runs_[found->second[i]];
    if (counts(run, maker)) return &run;
  }
  return nullptr;
}

Made RunLog::mostlyBy(const std::vector<std::string>& keys, const Maker& maker) const {
  struct Share {
    std::set<std::string> keys;
    size_t last = 0;
  };
  std::map<std::string, Share> shares;
  for (const std::string& key : keys) {
    const auto found = byKey_.find(key);
    if (found == byKey_.end()) continue;
    for (const size_t i : found->second) {
      if (!counts(runs_[i], maker)) continue;
      Share& share = shares[runs_[i].machine];
      share.keys.insert(key);
      share.last = std::max(share.last, i);
    }
  }
  const auto most =
      std::max_element(shares.begin(), shares.end(), [](const auto& a, const auto& b) {
        return std::pair(a.second.keys.size(), a.second.last) <
               std::pair(b.second.keys.size(), b.second.last);
      });
  return most == shares.end() ? Made() : Made{most->first, most->second.keys.size()};
}

Status RunLog::append(const Run& run) {
  if (!file_) {
    const auto folder = std::filesystem::path(path_).parent_path();
    std::error_code ignored;  // opening the file reports the error
    if (!folder.empty()) std::filesystem::create_directories(folder, ignored);
    file_.reset(std::fopen(path_.c_str(), "ab"));
    if (!file_) return io::fileError(path_, "cannot open");
  }
  const std::string line = (cutOff_ ? "\n" : "") + runLine(run);
  cutOff_ = false;
  const bool written = std::fwrite(line.data(), 1, line.size(), file_.get()) == line.size();
  if (!written || std::fflush(file_.get()) != 0) return io::fileError(path_, "cannot write");
  remember(run);
  return {};
}

}  // namespace obby::bench
