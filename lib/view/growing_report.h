// A report that one thread fills from a stream while another one shows it.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "view/report.h"

namespace obby::view {

// What is kept of a stream that may never end: of ways some 350 MB in the tool, which holds them as
// played and as pages get them, and 200 MB in each browser; of levels, queries and answers 200 MB.
inline constexpr Room kLiveRoom = {10'000'000, 100, 2, size_t(200) << 20, true};

enum class StreamState { open, ended, broken };

// Its lock guards the collector; the reading thread changes the report, the showing one looks at
// it.
class GrowingReport {
 public:
  explicit GrowingReport(Collector collector) : collector_(std::move(collector)) {}

  // --- the reading thread

  // Folds a record in and replays what it brings. Waits while the other thread wants to look.
  Status add(const io::Record& record);
  // Nothing more comes. Error: a query that was asked for did not come; the state is broken then.
  Status end(StreamState state, const std::vector<std::string>& notes);
  // Runs `use` with the report, which stays as it is meanwhile.
  Status use(const std::function<Status(const Report&)>& use);

  // --- the showing thread

  // Runs `look` if anything has changed since it last ran. Where the other thread is busy it does
  // nothing but ask for a turn: call it again soon. Whether it ran.
  bool look(const std::function<void(const Report&, StreamState)>& look);
  // It will not look any more: nobody need wait for it.
  void close();

  // Of any thread.
  bool open() const { return state_ == StreamState::open; }

 private:
  std::mutex mutex_;
  std::condition_variable turn_;
  Collector collector_;
  std::atomic<StreamState> state_{StreamState::open};
  std::atomic<bool> changed_{false};
  std::atomic<bool> wanted_{false};  // a turn to look
  bool closed_ = false;
};

}  // namespace obby::view
