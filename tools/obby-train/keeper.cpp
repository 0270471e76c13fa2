#include "keeper.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "command.h"
#include "io/read_file.h"
#include "io/sink.h"
#include "policy/policy_file.h"
#include "same_options.h"

namespace obby::tools {

namespace {

constexpr const char* kFresh = "absent";  // the policy that learning begins with

// Metrics go to standard output, and would spoil a file there as it would spoil them.
Status filesHaveNames(const cli::Arguments& a) {
  if (a.text("output").empty())
    return Error{{}, {}, "--output", "the name is empty", "name a file"};
  for (const char* name : {"output", "checkpoint", "log", "curve"}) {
    if (a.text(name) == "-")
      return Error{{},
                   {},
                   std::string("--") + name,
                   "cannot be standard output, where the metrics records go",
                   "name a file"};
  }
  return {};
}

// Or becomes one when it is written, or cannot be looked at: no device, pipe or folder.
bool isFile(const std::string& path) {
  std::error_code unseen;
  const auto kind = std::filesystem::status(path, unseen).type();
  return kind == std::filesystem::file_type::regular ||
         kind == std::filesystem::file_type::not_found || kind == std::filesystem::file_type::none;
}

// Beside the policy; none where the policy goes to a device or a pipe.
std::string checkpointPathOf(const cli::Arguments& a) {
  if (a.has("checkpoint")) return a.text("checkpoint");
  const std::string& output = a.text("output");
  return isFile(output) ? output + ".checkpoint" : std::string();
}

// What would show when it is written for the first time only, after a minute or an hour. Devices
// and pipes are not tried: who is at their other end would notice.
Status canBeWritten(const std::string& path) {
  std::error_code none;
  if (!isFile(path) && !std::filesystem::is_directory(path, none)) return {};
  OBBY_RETURN_IF_ERROR(io::Sink::open(path));  // without close() it leaves nothing
  return {};
}

// A checkpoint grows with its worlds and their bodies, however large other files may be.
uint64_t mostBytesOf(const std::string& path) {
  std::error_code unseen;
  const auto bytes = std::filesystem::is_regular_file(path, unseen)
                         ? std::filesystem::file_size(path, unseen)
                         : uintmax_t(0);
  return unseen ? io::kMostFileBytes : std::max<uint64_t>(bytes, io::kMostFileBytes);
}

Error inFile(Error error, const std::string& path) {
  if (error.input.empty()) error.input = path;
  return error;
}

Status writeFile(const std::string& path, std::string_view bytes, const std::atomic<bool>& late) {
  OBBY_ASSIGN(io::Sink sink, io::Sink::open(path, io::Durable::yes, &late));
  OBBY_RETURN_IF_ERROR(sink.write(bytes));
  return sink.close();
}

}  // namespace

Keeper::Keeper(const cli::Context& context, train::Ranks& ranks, const std::atomic<bool>& late)
    : context_(context),
      ranks_(ranks),
      late_(late),
      checkpointPath_(checkpointPathOf(context.arguments())) {}

// Two runs would write over each other's files by turns, and neither would notice.
Status Keeper::lockFiles(std::span<const cli::WrittenFile> written) {
  for (const cli::WrittenFile& file : written) {
    if (file.path.empty() || !isFile(file.path) || locks_.take(file.path)) continue;
    return Error{{},
                 {},
                 "--" + file.option,
                 fmt::format("another obby-train is writing '{}'", file.path),
                 "stop it, or name another file"};
  }
  return {};
}

Status Keeper::checkFiles() {
  const cli::Arguments& a = context_.arguments();
  OBBY_RETURN_IF_ERROR(filesHaveNames(a));
  const cli::WrittenFile written[] = {{"", "-"},
                                      {"output", a.text("output")},
                                      {"checkpoint", checkpointPath_},
                                      {"log", a.text("log")},
                                      {"curve", a.text("curve")}};
  OBBY_RETURN_IF_ERROR(cli::refuseOverwriting(a, written));
  OBBY_RETURN_IF_ERROR(lockFiles(std::span(written).subspan(1)));  // all but standard output
  for (const std::string& path : {a.text("output"), checkpointPath_, a.text("curve")}) {
    if (!path.empty()) OBBY_RETURN_IF_ERROR(canBeWritten(path));
  }
  return {};
}

// Empty: learning begins anew.
Result<std::string> Keeper::findBytes() const {
  const std::string& resume = context_.arguments().text("resume");
  if (resume == "no") return std::string();
  if (checkpointPath_.empty())
    return Error{{},
                 {},
                 "--resume",
                 fmt::format("'{}' is not a regular file, so no checkpoint is kept next to it",
                             context_.arguments().text("output")),
                 "give --checkpoint FILE, or the -o FILE of the earlier run"};
  // One that cannot be looked at may be there: what is wrong is said, and it is not written over.
  std::error_code unread;
  const auto kind = std::filesystem::status(checkpointPath_, unread).type();
  const bool none = kind == std::filesystem::file_type::not_found;
  if (resume == "auto" && none) return std::string();
  auto bytes = io::readFile(checkpointPath_, &context_.stop(), mostBytesOf(checkpointPath_));
  if (!bytes && none)
    bytes.error().hint = "use --resume=auto to start fresh if there is no checkpoint";
  // A file that holds nothing is no beginning either.
  if (bytes && bytes->empty()) return train::readCheckpoint(*bytes, checkpointPath_).error();
  return bytes;
}

Status Keeper::find() {
  OBBY_RETURN_IF_ERROR(ranks_.agree(ranks_.first() ? checkFiles() : Status()));
  OBBY_ASSIGN(start_, startPolicyOf(context_, ranks_));
  OBBY_ASSIGN(std::string bytes,
              ranks_.agree(ranks_.first() ? findBytes() : Result<std::string>(std::string())));
  bytes = ranks_.share(std::move(bytes));
  if (bytes.empty()) return {};
  OBBY_ASSIGN(found_, ranks_.agree(train::readCheckpoint(bytes, checkpointPath_)));
  secondsBefore_ = found_->seconds;
  historyBefore_ = found_->history;
  return {};
}

// What learning goes on from has it all: its start need not be named again.
std::string Keeper::startName() const {
  if (start_) return start_->name;
  if (!found_) return kFresh;
  const std::vector<train::Setting>& then = found_->settings;
  const auto start = std::find_if(then.begin(), then.end(),
                                  [](const train::Setting& s) { return s.name == "start-from"; });
  return start == then.end() ? kFresh : start->value;
}

Status Keeper::setRun(const train::TrainerSettings& trainer,
                      const std::vector<train::Setting>& levels, bool onDevice) {
  settings_ = trainer;
  run_ = levels;
  run_.push_back({"backend", onDevice ? "cuda" : "cpu"});
  startName_ = startName();
  run_.push_back({"start-from", startName_});
  for (train::Setting& setting : train::settingsOf(trainer)) run_.push_back(std::move(setting));
  run_.push_back({"ranks", fmt::format("{}", ranks_.count())});
  // Their options are the same by now; what they have found, as a GPU, may not be.
  std::vector<std::string> said;
  for (const train::Setting& s : run_) said.push_back(fmt::format("with {} {}", s.name, s.value));
  return sameOnAll(said, ranks_);
}

Result<std::unique_ptr<train::Trainer>> Keeper::trainer(std::unique_ptr<train::Engine> engine) {
  const train::Start* const start = start_ ? &start_->start : nullptr;
  if (!found_) return train::Trainer::make(settings_, std::move(engine), ranks_, start);
  if (Status same = train::sameSettings(found_->settings, run_); !same)
    return inFile(same.error(), checkpointPath_);
  auto trainer =
      train::Trainer::resume(settings_, std::move(engine), ranks_, std::move(found_->state));
  found_.reset();
  if (!trainer) return inFile(trainer.error(), checkpointPath_);
  return trainer;
}

Status Keeper::save(const train::Trainer& trainer, const train::History& history,
                    double seconds) const {
  OBBY_ASSIGN(const train::TrainerState state, trainer.state());
  if (!ranks_.first()) return {};
  // Ended before anything was learned: what a run before has left is worth more.
  const auto isThere = [](const std::string& path) {
    std::error_code unseen;
    return std::filesystem::is_regular_file(path, unseen);
  };
  const std::string& output = context_.arguments().text("output");
  if (state.decisions == 0 && (isThere(output) || isThere(checkpointPath_))) return {};
  Status kept;
  if (!checkpointPath_.empty()) {
    const std::string bytes =
        train::writeCheckpoint({context_.identity().version, run_, seconds, state, history});
    kept = writeFile(checkpointPath_, bytes, late_);
  }
  Status saved = savePolicy(trainer, state, seconds);
  return kept ? saved : kept;
}

Status Keeper::savePolicy(const train::Trainer& trainer, const train::TrainerState& state,
                          double seconds) const {
  const io::StreamIdentity identity = context_.identity();
  const train::ValueScale& values = state.learner.values;
  const policy::PolicyFile file{
      trainer.network(),
      {commandOf(context_.arguments()), identity.version, identity.seed, train::allDecisions(state),
       seconds, state.hardest, float(state.solved), startName_ == kFresh ? "" : startName_},
      {values.mean, values.deviation}};
  return writeFile(context_.arguments().text("output"), policy::writePolicy(file), late_);
}

}  // namespace obby::tools
