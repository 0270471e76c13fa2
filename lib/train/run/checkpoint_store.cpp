#include "train/run/checkpoint_store.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "io/read_file.h"
#include "io/sink.h"
#include "policy/policy_file.h"
#include "train/run/rank_options.h"

namespace obby::train {

namespace {

constexpr const char* kFresh = "absent";  // the name of a fresh network

// Returns true for a regular file, a missing one, and one whose kind is unknown.
bool isFile(const std::string& path) {
  std::error_code unseen;
  const auto kind = std::filesystem::status(path, unseen).type();
  return kind == std::filesystem::file_type::regular ||
         kind == std::filesystem::file_type::not_found || kind == std::filesystem::file_type::none;
}

bool exists(const std::string& path) {
  std::error_code unseen;
  return std::filesystem::is_regular_file(path, unseen);
}

// Finds errors that would otherwise show at the first save. Devices and pipes are not opened,
// because their readers would notice.
Status canBeWritten(const std::string& path) {
  std::error_code none;
  if (!isFile(path) && !std::filesystem::is_directory(path, none)) return {};
  OBBY_RETURN_IF_ERROR(io::Sink::open(path));  // a sink that is not closed leaves no file
  return {};
}

// A checkpoint grows with its worlds and may be larger than other input files.
uint64_t maxBytesOf(const std::string& path) {
  std::error_code unseen;
  const auto bytes = exists(path) ? std::filesystem::file_size(path, unseen) : uintmax_t(0);
  return unseen ? io::kMaxFileBytes : std::max<uint64_t>(bytes, io::kMaxFileBytes);
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

std::string defaultCheckpoint(const std::string& policy) {
  return isFile(policy) ? policy + ".checkpoint" : std::string();
}

CheckpointStore::CheckpointStore(RunFiles files, RunIdentity identity, Ranks& ranks,
                                 const std::atomic<bool>& stop, const std::atomic<bool>& late)
    : files_(std::move(files)),
      identity_(std::move(identity)),
      ranks_(ranks),
      stop_(stop),
      late_(late) {}

// Locks the files, because two runs would overwrite each other's files unnoticed. Then checks that
// they can be written.
Status CheckpointStore::lockAndCheckFiles() {
  const std::pair<const char*, const std::string&> written[] = {
      {"--output", files_.policy}, {"--checkpoint", files_.checkpoint}};
  for (const auto& [option, path] : written) {
    if (path.empty() || !isFile(path) || locks_.take(path)) continue;
    return Error{{},
                 {},
                 option,
                 fmt::format("another obby-train is writing '{}'", path),
                 "stop that run, or name another file"};
  }
  for (const auto& [option, path] : written) {
    if (!path.empty()) OBBY_RETURN_IF_ERROR(canBeWritten(path));
  }
  return {};
}

// Returns the bytes of the checkpoint to resume from, empty for a new run.
Result<std::string> CheckpointStore::checkpointBytes() const {
  const std::string& path = files_.checkpoint;
  if (files_.resume == Resume::no) return std::string();
  if (path.empty())
    return Error{{},
                 {},
                 "--resume",
                 fmt::format("'{}' is not a regular file, so no checkpoint is kept next to it",
                             files_.policy),
                 "give --checkpoint FILE, or the -o FILE of the earlier run"};
  // A file that cannot be examined may be a checkpoint, so it is an error and is not overwritten.
  std::error_code unread;
  const auto kind = std::filesystem::status(path, unread).type();
  const bool none = kind == std::filesystem::file_type::not_found;
  if (files_.resume == Resume::automatic && none) return std::string();
  auto bytes = io::readFile(path, &stop_, maxBytesOf(path));
  if (!bytes && none)
    bytes.error().hint = "use --resume=auto to start a new run if there is no checkpoint";
  if (bytes && bytes->empty()) return readCheckpoint(*bytes, path).error();
  return bytes;
}

Status CheckpointStore::open() {
  OBBY_RETURN_IF_ERROR(ranks_.agree(ranks_.first() ? lockAndCheckFiles() : Status()));
  OBBY_ASSIGN(start_, readStartPolicy(files_.startFrom, ranks_, stop_));
  OBBY_ASSIGN(std::string bytes, ranks_.agree(ranks_.first() ? checkpointBytes()
                                                             : Result<std::string>(std::string())));
  bytes = ranks_.share(std::move(bytes));
  if (bytes.empty()) return {};
  OBBY_ASSIGN(found_, ranks_.agree(readCheckpoint(bytes, files_.checkpoint)));
  secondsBefore_ = found_->seconds;
  return {};
}

// A checkpoint implies its starting policy, so the option need not be given again.
std::string CheckpointStore::startName() const {
  if (start_) return start_->name;
  if (!found_) return kFresh;
  const std::vector<Setting>& then = found_->settings;
  const auto start = std::find_if(then.begin(), then.end(),
                                  [](const Setting& s) { return s.name == "start-from"; });
  return start == then.end() ? kFresh : start->value;
}

Status CheckpointStore::setRun(const TrainerSettings& trainer, const std::vector<Setting>& levels,
                               bool onDevice) {
  settings_ = trainer;
  run_ = levels;
  run_.push_back({"backend", onDevice ? "cuda" : "cpu"});
  startName_ = startName();
  run_.push_back({"start-from", startName_});
  for (Setting& setting : settingsOf(trainer)) run_.push_back(std::move(setting));
  run_.push_back({"ranks", fmt::format("{}", ranks_.count())});
  // Ranks with equal options may find different devices.
  std::vector<std::string> options;
  for (const Setting& s : run_) options.push_back(fmt::format("with {} {}", s.name, s.value));
  return sameOnAllRanks(options, ranks_);
}

Result<std::unique_ptr<Trainer>> CheckpointStore::trainer(std::unique_ptr<Engine> engine) {
  const Start* const start = start_ ? &start_->start : nullptr;
  if (!found_) return Trainer::make(settings_, std::move(engine), ranks_, start);
  if (Status same = sameSettings(found_->settings, run_); !same)
    return inFile(same.error(), files_.checkpoint);
  auto trainer = Trainer::resume(settings_, std::move(engine), ranks_, std::move(found_->state));
  found_.reset();
  if (!trainer) return inFile(trainer.error(), files_.checkpoint);
  return trainer;
}

Status CheckpointStore::save(const Trainer& trainer, double seconds) const {
  OBBY_ASSIGN(const TrainerState state, trainer.state());
  if (!ranks_.first()) return {};
  if (state.decisions == 0 && (exists(files_.policy) || exists(files_.checkpoint))) return {};
  Status kept;
  if (!files_.checkpoint.empty()) {
    const std::string bytes = writeCheckpoint({identity_.stream.version, run_, seconds, state});
    kept = writeFile(files_.checkpoint, bytes, late_);
  }
  Status saved = savePolicy(trainer, state, seconds);
  return kept ? saved : kept;
}

Status CheckpointStore::savePolicy(const Trainer& trainer, const TrainerState& state,
                                   double seconds) const {
  const ValueScale& values = state.learner.values;
  const policy::PolicyFile file{
      trainer.network(),
      {identity_.command, identity_.stream.version, identity_.stream.seed, allDecisions(state),
       seconds, state.hardest, float(state.solved), startName_ == kFresh ? "" : startName_},
      {values.mean, values.deviation}};
  return writeFile(files_.policy, policy::writePolicy(file), late_);
}

}  // namespace obby::train
