#include "bridge/job.h"

#include <fmt/format.h>
#include <signal.h>

#include <cstring>

#include "bridge/messages.h"
#include "bridge/store.h"
#include "io/json_tree.h"
#include "io/json_writer.h"
#include "io/utf8.h"

namespace obby::bridge {
namespace {

constexpr size_t kMaxReport = 64 << 10;  // max bytes of a line of stderr that are passed on
constexpr int kInterrupted = 130;        // exit code of our tools after SIGINT
constexpr const char* kTimeIsUp =
    "the program exceeded its CPU time limit; start obby-bridge with a larger --cpu-time";

// Returns false for records that the client itself sent, or that only frame the stream.
bool worthTelling(std::string_view type) {
  return type != "header" && type != "level" && type != "query";
}

std::string endingOf(const Exit& how) {
  if (how.signal == 0) return fmt::format("the program ended with exit code {}", how.code);
  if (how.signal == SIGXCPU) return kTimeIsUp;
  return fmt::format("the program was killed by signal {} ({})", how.signal, strsignal(how.signal));
}

}  // namespace

const char* nameOf(JobState state) {
  switch (state) {
    case JobState::waiting: return "waiting";
    case JobState::running: return "running";
    case JobState::done: return "done";
    case JobState::cancelled: return "cancelled";
    case JobState::failed: break;
  }
  return "failed";
}

Job::Job(uint64_t number, std::shared_ptr<Client> client, JobPlan plan, const Limits& limits)
    : number_(number),
      client_(std::move(client)),
      plan_(std::move(plan)),
      limits_(limits),
      firstCursor_(client_->ring().last()) {
  enter(JobState::waiting, {});
}

std::string Job::id() const { return fmt::format("j{}", number_); }

void Job::enter(JobState state, const std::string& why) {
  state_ = state;
  io::JsonWriter out;
  out.open('{').field("job", id()).field("type", "state").field("state", nameOf(state));
  if (!why.empty()) out.field("reason", why);
  client_->tell(number_, out.finish());
  if (ended()) lastCursor_ = client_->ring().last();
}

void Job::tell(const char* type, const char* member, std::string_view json) {
  io::JsonWriter out;
  out.open('{').field("job", id()).field("type", type).key(member).raw(json);
  client_->tell(number_, out.finish());
}

void Job::fail(const Error& error) { enter(JobState::failed, error.text()); }

kj::Promise<void> Job::start(Loop& loop) {
  loop_ = &loop;
  auto process = Process::start(plan_.command);
  if (!process) {
    fail(process.error());
    return kj::READY_NOW;
  }
  if (!plan_.answerPath.empty()) {
    if (auto sink = io::Sink::open(plan_.answerPath)) answer_ = *std::move(sink);
  }
  enter(JobState::running, {});
  run_ = std::make_unique<Run>(
      loop, *std::move(process), std::move(plan_.input),
      [this](std::string_view line) { onRecord(line); },
      [this](std::string_view line) { onReport(line); });
  return run_->done().then([this](Exit how) { ending(how); },
                           [this](kj::Exception&& e) {
                             answer_.reset();  // an incomplete answer is useless
                             fail(makeError(io::validUtf8(e.getDescription().cStr())));
                             run_ = nullptr;
                           });
}

void Job::onRecord(std::string_view line) {
  const std::string_view type = typeOfLine(line);
  if (type.empty()) return;  // our programs write only records; other output is not passed on
  keep(line);
  if (type == "end") complete_ = true;
  if (!worthTelling(type)) return;
  for (const std::string& message : recordMessages(id(), line, limits_.messageBytes)) {
    client_->tell(number_, message);
  }
}

// Handles a line of stderr. Progress and errors are objects (--progress=json, --json-errors).
void Job::onReport(std::string_view line) {
  if (line.size() > kMaxReport) line = line.substr(0, kMaxReport);
  const auto tree = io::JsonTree::parse(line);
  if (!tree || tree->root().type != io::JsonTree::Type::object) {
    lastReport_ = io::validUtf8(line);
    return tell("report", "text", io::JsonWriter().value(line).finish());
  }
  if (typeOfLine(line) == "progress") return tell("progress", "progress", line);
  if (const auto* message = tree->find(tree->root(), "message")) {
    lastReport_ = tree->text(*message);
  }
  if (typeOfLine(line) == "error" && firstError_.empty()) firstError_ = lastReport_;
  tell("report", "report", line);
}

void Job::keep(std::string_view line) {
  if (!answer_) return;
  answerBytes_ += line.size() + 1;
  const bool written =
      answerBytes_ <= limits_.answerBytes && answer_->write(line) && answer_->write("\n");
  if (!written) keepNothing();
}

void Job::keepNothing() {
  answer_.reset();  // removes the file: an incomplete answer is useless
  tell("report", "report",
       R"({"message":"this answer is not kept for a warm start: )"
       R"(it is too large, or the disk is full"})");
}

void Job::closeAnswer() {
  if (!answer_) return;
  kept_ = complete_ && answer_->close();
  if (complete_ && !kept_) keepNothing();  // a full disk may show only now
  answer_.reset();
}

void Job::ending(const Exit& how) {
  closeAnswer();
  run_ = nullptr;
  kill_ = nullptr;
  if (!cancelled_.empty()) return enter(JobState::cancelled, cancelled_);
  const bool interrupted = how.signal == 0 && how.code == kInterrupted;
  if (how.signal == 0 && how.code == 0) return enter(JobState::done, {});
  if (interrupted) return enter(JobState::cancelled, "the program was interrupted");
  const std::string& why = firstError_.empty() ? lastReport_ : firstError_;
  enter(JobState::failed, why.empty() ? endingOf(how) : why);
}

void Job::cancel(const char* why) {
  if (ended() || !cancelled_.empty()) return;
  cancelled_ = why;
  if (!run_) return enter(JobState::cancelled, why);
  run_->signal(SIGINT);
  const uint64_t milliseconds = uint64_t(limits_.stopSeconds * 1000);
  kill_ = loop_->timer.afterDelay(milliseconds * kj::MILLISECONDS)
              .then([this] {
                if (run_) run_->signal(SIGKILL);
              })
              .eagerlyEvaluate(nullptr);
}

// The system's own limit would end the program at once, and lose up to an hour of work.
void Job::boundTime() {
  if (run_ && run_->cpuSeconds() > double(limits_.cpuSeconds)) cancel(kTimeIsUp);
}

}  // namespace obby::bridge
