// Tests the choice of the backend, and the messages if the requested backend is missing.
#include "sim/backend.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/level_builder.h"

namespace obby::sim {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(Backend, names_are_those_of_the_option) {
  EXPECT_EQ(*backendKind("auto"), BackendKind::automatic);
  EXPECT_EQ(*backendKind("cpu"), BackendKind::cpu);
  EXPECT_EQ(*backendKind("cuda"), BackendKind::cuda);
  EXPECT_EQ(backendKind("gpu").error().text(), "unknown backend 'gpu' (give auto, cpu or cuda)");
}

TEST(Backend, the_cpu_is_always_there) {
  const auto backend = Backend::open(BackendKind::cpu);
  ASSERT_TRUE(backend);
  EXPECT_FALSE(backend->onDevice());
  EXPECT_EQ(backend->note(), "simulating on the CPU");
}

// If CUDA is missing for any reason, `cuda` is an error that gives the reason. `auto` continues and
// gives the same reason as a note.
TEST(Backend, without_a_gpu_cuda_is_an_error_and_auto_takes_the_cpu) {
  const auto wanted = Backend::open(BackendKind::cuda);
  const auto either = Backend::open(BackendKind::automatic);
  ASSERT_TRUE(either);
  if (wanted) {
    EXPECT_TRUE(either->onDevice());
    EXPECT_THAT(either->note(), StartsWith("simulating on "));
    return;
  }
  EXPECT_THAT(wanted.error().message, HasSubstr("CUDA"));
  EXPECT_NE(wanted.error().hint, "");
  EXPECT_FALSE(either->onDevice());
  EXPECT_THAT(either->note(), StartsWith("simulating on the CPU: "));
  EXPECT_THAT(either->note(), HasSubstr(wanted.error().message));
}

TEST(Backend, auto_gives_batches_that_step) {
  ThreadPool pool(2);
  const auto backend = Backend::open(BackendKind::automatic);
  ASSERT_TRUE(backend);
  const level::Level level = support::boxArena(10, 1).compile();
  const Course course = courseOf(level.view(), level.spawns()[0]);
  const auto batch = backend->makeBatch(course, 50, pool);
  ASSERT_TRUE(batch);
  ASSERT_TRUE((*batch)->step(60, Actions::walker(1)));
  const auto lanes = *makeCpuBatch(course, 50, pool);
  ASSERT_TRUE(lanes->step(60, Actions::walker(1)));
  EXPECT_EQ(*(*batch)->hash(), *lanes->hash());
}

}  // namespace
}  // namespace obby::sim
