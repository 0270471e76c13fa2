// Levels are made ahead, as for a GPU. Training ends without waiting for these levels.
#include <gtest/gtest.h>

#include "sim/host_device.h"
#include "train/device/device_engine.h"
#include "train/gaps.h"
#include "train/level_lines.h"
#include "train/standing.h"

namespace obby::train {
namespace {

// This happens, for example, if an output cannot be opened after the first levels have arrived.
TEST(ReadAhead, OfAStalledStreamEndsWithTheEngine) {
  const TrainerSettings settings = tiny();
  std::string text = kHeaderLine;
  for (uint64_t i = 0; i < settings.envGroups * settings.envGroup.levels; ++i) text += lineOf(i);
  const Standing standing(text);
  const std::atomic<bool> interrupted{false};
  Timeout timeout(interrupted, Timeout::kNone);
  const LevelStream stream(standing.options(timeout), {.choices = 1, .timeout = &timeout});
  ThreadPool pool(1);
  sim::HostDevice device(pool);
  {
    const auto trainer =
        Trainer::make(settings, makeDeviceEngine(settings, stream, device, pool, alone()), alone());
    ASSERT_TRUE(trainer) << trainer.error().text();
    EXPECT_FALSE(bool(timeout.stop()));
  }
  EXPECT_TRUE(bool(timeout.stop()));
  EXPECT_FALSE(timeout.expired());
}

}  // namespace
}  // namespace obby::train
