// The number of threads that the process may use: Slurm's value or, without it, the CPU affinity.
#include <gtest/gtest.h>
#include <sched.h>

#include <cstdlib>
#include <optional>
#include <string>

#include "base/thread_pool.h"

namespace obby {
namespace {

// Sets SLURM_CPUS_PER_TASK for one test and restores it afterwards.
class SlurmVariable {
 public:
  explicit SlurmVariable(const char* value) {
    if (const char* old = std::getenv(kName)) old_ = old;
    value ? setenv(kName, value, 1) : unsetenv(kName);
  }
  ~SlurmVariable() { old_ ? setenv(kName, old_->c_str(), 1) : unsetenv(kName); }
  SlurmVariable(const SlurmVariable&) = delete;
  SlurmVariable& operator=(const SlurmVariable&) = delete;

 private:
  static constexpr const char* kName = "SLURM_CPUS_PER_TASK";
  std::optional<std::string> old_;
};

int affinity() {
  cpu_set_t set;
  return sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
}

TEST(AvailableThreads, FollowsSlurm) {
  const SlurmVariable variable("13");
  EXPECT_EQ(availableThreads(), 13);
}

TEST(AvailableThreads, FallsBackToTheAffinity) {
  const SlurmVariable variable(nullptr);
  EXPECT_EQ(availableThreads(), affinity());
}

TEST(AvailableThreads, IgnoresAnInvalidSlurmValue) {
  for (const char* text : {"", "0", "-4", "many"}) {
    const SlurmVariable variable(text);
    EXPECT_EQ(availableThreads(), affinity()) << text;
  }
}

}  // namespace
}  // namespace obby
