#include "cli/stop.h"

#include <signal.h>
#include <unistd.h>

namespace obby::cli {
namespace {

std::atomic<bool> stopped{false};
std::atomic<int> signalNumber{0};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

constexpr int kSignalExit = 128;

void onSignal(int number) {
  if (number == SIGINT && stopped.load()) _exit(kSignalExit + number);
  signalNumber.store(number);
  stopped.store(true);
}

void install(int number) {
  struct sigaction action {};
  if (sigaction(number, nullptr, &action) != 0 || action.sa_handler == SIG_IGN) return;
  action = {};
  action.sa_handler = onSignal;  // no SA_RESTART: a waiting read comes back
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
