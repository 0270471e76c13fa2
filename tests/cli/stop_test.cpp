// What signals do: each test sends them to a process of its own.
#include "cli/stop.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <thread>

namespace obby::cli {
namespace {

using std::chrono::milliseconds;

// Two of them, the second so much later; ends with 0 if they have asked for an end, as `number`.
void sentTwice(int number, milliseconds later) {
  signal(number, SIG_DFL);  // it may have been ignored where the tests were started
  installStopHandlers();
  raise(number);
  std::this_thread::sleep_for(later);
  raise(number);
  _exit(stopFlag().load() && stopSignal() == number ? 0 : 1);
}

// As timeout(1) does.
TEST(Stop, OneSignalThatIsSentTwiceAsksForAnEnd) {
  EXPECT_EXIT(sentTwice(SIGINT, milliseconds(0)), testing::ExitedWithCode(0), "");
  EXPECT_EXIT(sentTwice(SIGTERM, milliseconds(0)), testing::ExitedWithCode(0), "");
}

TEST(Stop, ASecondInterruptEndsAtOnce) {
  EXPECT_EXIT(sentTwice(SIGINT, milliseconds(500)), testing::ExitedWithCode(128 + SIGINT), "");
  EXPECT_EXIT(sentTwice(SIGTERM, milliseconds(500)), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace obby::cli
