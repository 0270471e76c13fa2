// Tests programs that the bridge starts, and the descendants of these programs.
#include "bridge/process.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <unistd.h>

namespace obby::bridge {
namespace {

Result<Process> processShell(const std::string& script) {
  return Process::start({"/bin/sh", {"-c", script}, 0, 0});
}

std::string readAll(int fd) {
  std::string out;
  char buffer[4096];
  for (ssize_t n = 0; (n = read(fd, buffer, sizeof buffer)) > 0;) out.append(buffer, size_t(n));
  return out;
}

Exit waitFor(Process& process) {
  pollfd wait{process.exitFd(), POLLIN, 0};
  EXPECT_EQ(poll(&wait, 1, 20000), 1);
  return process.reap();
}

TEST(Process, streams_and_exit_code_are_delivered) {
  auto process = processShell("cat; echo oh >&2; exit 3");
  ASSERT_TRUE(process);
  ASSERT_EQ(write(process->input.get(), "hello", 5), 5);
  process->input = OwnedFd();
  EXPECT_EQ(readAll(process->output.get()), "hello");
  EXPECT_EQ(readAll(process->errors.get()), "oh\n");
  const Exit how = waitFor(*process);
  EXPECT_EQ(how.code, 3);
  EXPECT_EQ(how.signal, 0);
}

TEST(Process, arguments_are_not_interpreted_by_a_shell) {
  auto process = Process::start({"/bin/echo", {"$(id)", "a b", "; touch x", ""}, 0, 0});
  ASSERT_TRUE(process);
  EXPECT_EQ(readAll(process->output.get()), "$(id) a b ; touch x \n");
  waitFor(*process);
}

TEST(Process, a_failed_start_states_the_reason) {
  const auto process = Process::start({"/nowhere/obby-solve", {}, 0, 0});
  ASSERT_FALSE(process);
  EXPECT_NE(process.error().text().find("No such file"), std::string::npos);
}

TEST(Process, signals_reach_the_whole_group) {
  auto process = processShell("sleep 100 & echo ready; wait; sleep 100");
  ASSERT_TRUE(process);
  char first = 0;
  ASSERT_EQ(read(process->output.get(), &first, 1), 1);
  process->signal(SIGKILL);
  EXPECT_EQ(waitFor(*process).signal, SIGKILL);
  EXPECT_EQ(readAll(process->output.get()),
            "eady\n");  // ends at once, since no descendant holds the pipe open
}

TEST(Process, descendants_end_with_the_leader) {
  auto process = processShell("sleep 100 & exit 0");
  ASSERT_TRUE(process);
  EXPECT_EQ(waitFor(*process).code, 0);
  EXPECT_EQ(readAll(process->output.get()), "");  // blocks if a descendant survives
}

TEST(Process, its_processor_time_is_known_until_it_is_reaped) {
  auto process = processShell("while :; do :; done");
  ASSERT_TRUE(process);
  for (int i = 0; i < 2000 && process->cpuSeconds() < 0.05; i++) usleep(10000);
  EXPECT_GE(process->cpuSeconds(), 0.05);
  process->signal(SIGKILL);
  waitFor(*process);
  EXPECT_EQ(process->cpuSeconds(), 0);
}

TEST(Process, a_dropped_process_is_killed) {
  pid_t id = 0;
  {
    auto process = processShell("sleep 100");
    ASSERT_TRUE(process);
    id = process->id();
    EXPECT_EQ(getpgid(id), id);
    EXPECT_EQ(kill(id, 0), 0);
  }
  EXPECT_NE(kill(id, 0), 0);
}

TEST(Process, ignored_signals_of_the_bridge_are_not_inherited) {
  signal(SIGPIPE, SIG_IGN);
  auto process = processShell("kill -PIPE $$; echo alive");
  signal(SIGPIPE, SIG_DFL);
  ASSERT_TRUE(process);
  EXPECT_EQ(waitFor(*process).signal, SIGPIPE);
}

}  // namespace
}  // namespace obby::bridge
