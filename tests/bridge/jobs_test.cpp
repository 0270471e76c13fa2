// Tests which jobs a client can still ask about.
#include "bridge/jobs.h"

#include <gtest/gtest.h>
#include <kj/async-io.h>

#include <memory>
#include <string>
#include <vector>

namespace obby::bridge {
namespace {

JobPlan shell(const std::string& script) {
  JobPlan plan;
  plan.command = {"/bin/sh", {"-c", script}, 0, 0};
  return plan;
}

TEST(Jobs, the_first_to_end_are_forgotten_first) {
  kj::AsyncIoContext async = kj::setupAsyncIo();
  Loop loop{*async.lowLevelProvider, async.unixEventPort, async.provider->getTimer()};
  Limits limits;
  limits.jobs = 2;
  limits.keptJobs = 2;
  std::vector<std::string> forgotten;
  Jobs jobs(loop, limits, [&](const Job& job) { forgotten.push_back(job.id()); });
  const auto client = std::make_shared<Client>(1, limits.ringBytes);
  const auto submit = [&](const std::string& script) {
    return jobs.submit(client, shell(script), jobs.nextNumber())->id();
  };
  const std::string slow = submit("exec sleep 1000");
  const std::string first = submit("exit 0"), second = submit("exit 0"), third = submit("exit 0");
  while (!jobs.find(*client, third)->ended()) {
    loop.timer.afterDelay(1 * kj::MILLISECONDS).wait(async.waitScope);
  }
  jobs.cancel(*jobs.find(*client, slow), "the test says so");
  jobs.whenIdle().wait(async.waitScope);
  EXPECT_EQ(forgotten, (std::vector<std::string>{first, second}));
  ASSERT_NE(jobs.find(*client, slow), nullptr);
  EXPECT_EQ(jobs.find(*client, slow)->state(), JobState::cancelled);
}

TEST(Jobs, answers_that_another_job_still_needs_are_kept) {
  kj::AsyncIoContext async = kj::setupAsyncIo();
  Loop loop{*async.lowLevelProvider, async.unixEventPort, async.provider->getTimer()};
  Limits limits;
  limits.jobs = 2;
  limits.keptJobs = 1;
  std::vector<uint64_t> forgotten;
  Jobs jobs(loop, limits, [&](const Job& job) { forgotten.push_back(job.number()); });
  const auto client = std::make_shared<Client>(1, limits.ringBytes);
  const auto submit = [&](const std::string& script, uint64_t warm) {
    JobPlan plan = shell(script);
    plan.warm = warm;
    return jobs.submit(client, std::move(plan), jobs.nextNumber());
  };
  Job* const first = submit("exit 0", 0);
  const uint64_t answer = first->number();
  jobs.whenIdle().wait(async.waitScope);
  Job* const slow = submit("exec sleep 1000", 0);
  const uint64_t second = submit("exit 0", 0)->number(), third = submit("exit 0", 0)->number();
  const Job* const reader = submit("exit 0", answer);
  const uint64_t last = reader->number();
  while (!reader->ended()) {
    loop.timer.afterDelay(1 * kj::MILLISECONDS).wait(async.waitScope);
  }
  jobs.cancel(*slow, "the test says so");
  jobs.whenIdle().wait(async.waitScope);
  EXPECT_EQ(forgotten, (std::vector<uint64_t>{second, answer, third, last}));
}

// Whatever the number of processors, a program has time to write its results before the system
// kills it. It needs a second until the bridge's check, and the time from SIGINT to SIGKILL.
TEST(Limits, the_system_ends_a_program_only_after_the_bridge_could) {
  for (const uint64_t seconds : {uint64_t(1), uint64_t(60), uint64_t(3600)}) {
    for (const uint32_t processors : {1u, 2u, 64u, 256u}) {
      Limits limits;
      limits.cpuSeconds = seconds;
      limits.stopSeconds = 2.5;
      EXPECT_GE(double(limits.maxCpuSeconds(processors)),
                double(seconds) + processors * (1 + limits.stopSeconds))
          << seconds << " s, " << processors << " processors";
    }
  }
}

}  // namespace
}  // namespace obby::bridge
