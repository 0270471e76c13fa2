// One job of a client, from its order to its end, and its messages to the client.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "bridge/client.h"
#include "bridge/limits.h"
#include "bridge/run.h"
#include "io/sink.h"

namespace obby::bridge {

enum class JobState { waiting, running, done, cancelled, failed };
const char* nameOf(JobState state);

// The program and input of a job, decided before it waits for its turn.
struct JobPlan {
  Command command;
  std::string input;
  std::string answerPath;  // path at which the answer is kept for a warm start, or empty
  uint64_t warm = 0;       // number of the job whose answer is the warm start; 0 for none
};

class Job {
 public:
  Job(uint64_t number, std::shared_ptr<Client> client, JobPlan plan, const Limits& limits);

  std::string id() const;
  uint64_t number() const { return number_; }
  JobState state() const { return state_; }
  bool ended() const { return state_ > JobState::running; }
  bool answerKept() const { return kept_; }
  const std::string& answerPath() const { return plan_.answerPath; }
  uint64_t warm() const { return plan_.warm; }
  Client& client() { return *client_; }
  uint64_t firstCursor() const { return firstCursor_; }  // messages of this job have higher numbers
  uint64_t lastCursor() const { return lastCursor_; }    // its last message; 0 if it has not ended

  // Number of long polls so far. An older one ends when a newer one comes.
  uint64_t polls = 0;

  // Starts the program. The promise is fulfilled when the job has ended, with any result.
  kj::Promise<void> start(Loop& loop);
  // Sends SIGINT, so that finished results still come, and SIGKILL if it does not end in time.
  void cancel(const char* why);
  // Cancels the job if it has used up its processor time. Must be called every second.
  void boundTime();

 private:
  void enter(JobState state, const std::string& why);
  void fail(const Error& error);
  void onRecord(std::string_view line);
  void onReport(std::string_view line);
  void keep(std::string_view line);
  void keepNothing();
  void closeAnswer();
  void ending(const Exit& how);
  void tell(const char* type, const char* member, std::string_view json);

  uint64_t number_;
  std::shared_ptr<Client> client_;
  JobPlan plan_;
  const Limits& limits_;
  JobState state_ = JobState::waiting;
  uint64_t firstCursor_, lastCursor_ = 0;
  std::string cancelled_;   // the reason; empty if it was not cancelled
  std::string firstError_;  // first error of the program; later errors may be its consequences
  std::string lastReport_;  // last message of the program on stderr
  bool complete_ = false;   // the program's end record has arrived
  bool kept_ = false;
  uint64_t answerBytes_ = 0;
  std::optional<io::Sink> answer_;
  Loop* loop_ = nullptr;
  std::unique_ptr<Run> run_;
  kj::Promise<void> kill_ = nullptr;
};

}  // namespace obby::bridge
