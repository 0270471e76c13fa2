// Tests the bridge's replies if obby-import does not finish a level.
#include "bridge/importing.h"

#include <gtest/gtest.h>
#include <kj/async-io.h>
#include <sys/stat.h>

#include <fstream>
#include <string>

#include "io/scratch_folder.h"

namespace obby::bridge {
namespace {

// Returns the bridge's refusal if this shell script runs instead of obby-import.
Reply refusalOf(const std::string& script, const Limits& limits) {
  const test::ScratchFolder folder;
  const std::string program = folder / "obby-import";
  std::ofstream(program) << "#!/bin/sh\n" << script << "\n";
  chmod(program.c_str(), 0700);
  kj::AsyncIoContext async = kj::setupAsyncIo();
  Loop loop{*async.lowLevelProvider, async.unixEventPort, async.provider->getTimer()};
  return importLevel(loop, program, "a place", limits).wait(async.waitScope).refusal;
}

TEST(Importing, says_that_processor_time_is_used_up) {
  Limits limits;
  limits.cpuSeconds = 1;
  const Reply reply = refusalOf("while :; do :; done", limits);
  EXPECT_EQ(reply.status, 504);
  EXPECT_NE(reply.body.find("--cpu-time"), std::string::npos) << reply.body;
}

TEST(Importing, tells_signals_from_exit_codes) {
  const Reply killed = refusalOf("kill -SEGV $$", Limits());
  EXPECT_EQ(killed.status, 422);
  EXPECT_NE(killed.body.find("by signal 11"), std::string::npos) << killed.body;
  const Reply failed = refusalOf("cat >/dev/null; exit 11", Limits());
  EXPECT_EQ(failed.status, 422);
  EXPECT_NE(failed.body.find("ended with exit code 11"), std::string::npos) << failed.body;
}

}  // namespace
}  // namespace obby::bridge
