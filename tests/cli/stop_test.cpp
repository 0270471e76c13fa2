// The effect of signals. Each test sends them to its own process.
#include "cli/stop.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <thread>

namespace obby::cli {
namespace {

using std::chrono::milliseconds;

// Sends the signal twice, the second time after `later`. Exits with 0 if the stop flag is set for
// `number`.
void sentTwice(int number, milliseconds later) {
  signal(number, SIG_DFL);  // the parent of the tests may ignore this signal
  installStopHandlers();
  raise(number);
  std::this_thread::sleep_for(later);
  raise(number);
  _exit(stopFlag().load() && stopSignal() == number ? 0 : 1);
}

// timeout(1) sends a signal twice.
TEST(Stop, ASignalRepeatedAtOnceCountsOnce) {
  EXPECT_EXIT(sentTwice(SIGINT, milliseconds(0)), testing::ExitedWithCode(0), "");
  EXPECT_EXIT(sentTwice(SIGTERM, milliseconds(0)), testing::ExitedWithCode(0), "");
}

TEST(Stop, ASecondInterruptEndsAtOnce) {
  EXPECT_EXIT(sentTwice(SIGINT, milliseconds(500)), testing::ExitedWithCode(128 + SIGINT), "");
  EXPECT_EXIT(sentTwice(SIGTERM, milliseconds(500)), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace obby::cli
