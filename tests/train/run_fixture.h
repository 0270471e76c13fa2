// A folder for the files of a training run, and small runs in it.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "io/read_file.h"
#include "train/gaps.h"
#include "train/run/checkpoint_store.h"

namespace obby::train {

class RunFolder : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string in(const std::string& name) const { return folder_ + "/" + name; }
  bool exists(const std::string& name) const { return std::filesystem::exists(in(name)); }

  RunFiles files(Resume resume = Resume::no) const {
    return {in("policy.obp"), in("policy.obp.checkpoint"), "", resume};
  }
  CheckpointStore store(RunFiles files) {
    return {std::move(files), {"obby-train --test", {"obby-train", "1", 5}}, alone(), no_, no_};
  }
  // Returns the CPU engine with small levels.
  std::unique_ptr<Engine> engine() { return makeCpuEngine(tiny(), gaps_, pool_, alone()); }

  // Opens the store, and returns its trainer after some iterations.
  Result<std::unique_ptr<Trainer>> trained(CheckpointStore& store, int iterations) {
    OBBY_RETURN_IF_ERROR(store.open());
    OBBY_RETURN_IF_ERROR(store.setRun(tiny(), {{"levels", "gaps"}}, false));
    OBBY_ASSIGN(auto trainer, store.trainer(engine()));
    for (int i = 0; i < iterations; ++i) OBBY_RETURN_IF_ERROR(trainer->iterate());
    return trainer;
  }

  std::string folder_ = testing::TempDir() + "obby_run_" +
                        testing::UnitTest::GetInstance()->current_test_info()->name();
  std::atomic<bool> no_{false};
  Gaps gaps_;
  ThreadPool pool_{1};
};

}  // namespace obby::train
