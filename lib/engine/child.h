// Runs work that may crash, hang or be hostile in forked children that write bytes and end. Private
// to lib/engine.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace obby::engine {

// Cages this process permanently: no files, no network, no new programs, and limits on memory and
// time. Call it in a child. Returns false if the system does not support this.
bool enterCage(double seconds, size_t memory);

// Ends this process once `*beat` has stayed the same for `seconds` of its CPU time.
void watchBeat(const volatile unsigned* beat, double seconds);

class Children {
 public:
  using Clock = std::chrono::steady_clock;
  // The body runs in the child, `done` in this process. `done` receives the bytes that the body
  // returned, or none if the child died or overran.
  using Body = std::function<std::string()>;
  using Done = std::function<void(std::string bytes)>;

  // At most `max` children run at a time.
  explicit Children(size_t max) : max_(max) {}
  ~Children();
  Children(const Children&) = delete;
  Children& operator=(const Children&) = delete;

  // Waits until one more child may run, then forks. A child that takes longer than `seconds` is
  // killed.
  void start(double seconds, const Body& body, Done done);
  void finish();

 private:
  struct Running {
    int pid = -1, pipe = -1;
    Clock::time_point deadline;
    std::string bytes;
    Done done;
  };

  // Waits until one child has ended.
  void wait();
  void end(size_t index, bool killed);

  size_t max_;
  std::vector<Running> running_;
};

}  // namespace obby::engine
