// Tests a program on the event loop, and the callbacks that receive its lines.
#include "bridge/run.h"

#include <gtest/gtest.h>
#include <kj/async-io.h>
#include <poll.h>

#include <new>
#include <string>
#include <string_view>
#include <utility>

namespace obby::bridge {
namespace {

// Returns the reason why the run failed, or an empty text on success, or "it hangs" after a minute.
std::string endOf(const std::string& script, Run::OnLine onOutput, Run::OnLine onError) {
  kj::AsyncIoContext async = kj::setupAsyncIo();
  Loop loop{*async.lowLevelProvider, async.unixEventPort, async.provider->getTimer()};
  auto process = Process::start({"/bin/sh", {"-c", script}, 0, 0});
  if (!process) return process.error().text();
  Run run(loop, *std::move(process), {}, std::move(onOutput), std::move(onError));
  auto ended =
      run.done().then([](Exit) { return std::string(); },
                      [](kj::Exception&& e) -> std::string { return e.getDescription().cStr(); });
  auto late = loop.timer.afterDelay(60 * kj::SECONDS).then([] { return std::string("it hangs"); });
  return ended.exclusiveJoin(kj::mv(late)).wait(async.waitScope);
}

TEST(Run, a_program_is_ended_if_a_callback_throws) {
  const Run::OnLine fails = [](std::string_view) { throw std::bad_alloc(); };
  std::string taken;
  const Run::OnLine takes = [&taken](std::string_view line) { taken += line; };
  EXPECT_NE(endOf("while echo more; do :; done", fails, takes).find("bad_alloc"),
            std::string::npos);
  EXPECT_NE(endOf("while echo more >&2; do :; done", takes, fails).find("bad_alloc"),
            std::string::npos);
  EXPECT_EQ(taken, "");
  EXPECT_EQ(endOf("echo a; echo b", takes, fails), "");
  EXPECT_EQ(taken, "ab");
}

TEST(Run, a_program_may_end_before_its_input) {
  kj::AsyncIoContext async = kj::setupAsyncIo();
  Loop loop{*async.lowLevelProvider, async.unixEventPort, async.provider->getTimer()};
  auto process = Process::start({"/bin/sh", {"-c", "exit 11"}, 0, 0});
  ASSERT_TRUE(process) << process.error().text();
  pollfd exited{process->exitFd(), POLLIN, 0};
  ASSERT_EQ(poll(&exited, 1, 60000), 1);  // timeout in milliseconds
  const auto ignored = [](std::string_view) {};
  bridge::Run run(loop, *std::move(process), "input", ignored, ignored);
  EXPECT_EQ(run.done().wait(async.waitScope).code, 11);
}

}  // namespace
}  // namespace obby::bridge
