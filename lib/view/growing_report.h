// A report that one thread fills from a stream while another one reads it.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "view/report.h"

namespace obby::view {

// Limits for an endless stream. Trajectories take some 350 MB in the tool, both as replays and as
// page data, and 200 MB in each browser. Levels, queries and answers take 200 MB.
inline constexpr PageBudget kLiveBudget = {10'000'000, 100, 2, size_t(200) << 20, true};

enum class StreamState { open, ended, broken };

// A lock guards the collector. The reading thread changes the report, the showing thread reads it.
class GrowingReport {
 public:
  explicit GrowingReport(Collector collector) : collector_(std::move(collector)) {}

  // --- The reading thread

  // Adds a record and replays its trajectories. Waits while the other thread requests a look.
  Status add(const io::Record& record);
  // Ends the stream. Error: a requested query was not in the stream. Then the state is `broken`.
  Status end(StreamState state, const std::vector<std::string>& notes);
  // Calls `use` with the report under the lock.
  Status use(const std::function<Status(const Report&)>& use);

  // --- The showing thread

  // Calls `look` if anything has changed since its last call. If the other thread holds the lock,
  // it only requests a turn, and the caller should retry soon. Returns true if `look` was called.
  bool look(const std::function<void(const Report&, StreamState)>& look);
  // Declares that look() will not be called any more, so that no thread waits for it.
  void close();

  // Callable from any thread.
  bool open() const { return state_ == StreamState::open; }

 private:
  std::mutex mutex_;
  std::condition_variable turn_;
  Collector collector_;
  std::atomic<StreamState> state_{StreamState::open};
  std::atomic<bool> changed_{false};
  std::atomic<bool> wanted_{false};  // the showing thread requests a turn
  bool closed_ = false;
};

}  // namespace obby::view
