#include "cli/stop.h"

#include <signal.h>
#include <time.h>
#include <unistd.h>

#include <cstdint>

namespace obby::cli {
namespace {

std::atomic<bool> stopped{false};
std::atomic<int> signalNumber{0};
std::atomic<int64_t> stoppedAt{0};  // milliseconds
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free &&
              std::atomic<int64_t>::is_always_lock_free);

// timeout(1) and other launchers send one signal twice, to a process and to its group. A user does
// not press Ctrl-C twice within this time.
constexpr int64_t kMoment = 300;  // milliseconds

// Reads a clock that is safe in a signal handler.
int64_t milliseconds() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return int64_t(now.tv_sec) * 1000 + int64_t(now.tv_nsec) / 1000000;
}

void onSignal(int number) {
  const int64_t now = milliseconds();
  if (!stopped.load()) {
    stoppedAt.store(now);
  } else if (number == SIGINT && now - stoppedAt.load() >= kMoment) {
    _exit(kSignalExit + number);
  }
  signalNumber.store(number);
  stopped.store(true);
}

void install(int number) {
  struct sigaction action {};
  if (sigaction(number, nullptr, &action) != 0 || action.sa_handler == SIG_IGN) return;
  action = {};
  action.sa_handler = onSignal;  // no SA_RESTART, so that a waiting read returns
  sigaction(number, &action, nullptr);
}

}  // namespace

const std::atomic<bool>& stopFlag() { return stopped; }
int stopSignal() { return signalNumber.load(); }

void installStopHandlers() {
  install(SIGINT);
  install(SIGTERM);
}

}  // namespace obby::cli
