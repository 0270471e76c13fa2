// A training run: when it ends, what it writes, and which failures it survives.
#include "train/run/training_run.h"

#include "train/run_fixture.h"

namespace obby::train {
namespace {

class TrainingRuns : public RunFolder {
 protected:
  // Runs until a limit. `watch` receives the number of the iteration and the timeout.
  Status run(RunLimits limits, const std::function<void(int, Timeout&)>& watch = {}) {
    CheckpointStore files = store({in("disk/policy.obp"), in("disk/checkpoint"), "", Resume::no});
    std::filesystem::create_directories(in("disk"));
    auto trainer = trained(files, 0);
    if (!trainer) return trainer.error();
    auto metrics = MetricsStream::open(
        {io::StreamWriter::toBytes(io::Format::jsonl, &metrics_), [](int) { return true; }},
        {"obby-train", "1", 5}, no_, no_);
    auto events = EventLog::open(in("events"), 0);
    if (!metrics || !events) return makeError("cannot open the outputs");
    Timeout timeout(no_, limits.seconds);
    RunReport report{[&](const std::string& text) { warnings_.push_back(text); },
                     [&](const std::string& text) { notes_.push_back(text); },
                     [&](const RunProgress& p) {
                       progress_.push_back(p);
                       if (watch) watch(int(progress_.size()), timeout);
                     }};
    TrainingRun training(**trainer, alone(), files, limits, {&*metrics, &*events}, report, timeout);
    Status done = training.run();
    return metrics->finish({}, std::move(done));
  }

  static RunLimits limits() {
    RunLimits limits;
    limits.decisions = 5 * uint64_t(tiny().worlds()) * tiny().ticks;  // five iterations
    limits.seconds = Timeout::kNone;
    limits.saveSeconds = 1e6;
    limits.eventsEvery = 2;
    return limits;
  }

  std::string metrics_;
  std::vector<std::string> warnings_, notes_;
  std::vector<RunProgress> progress_;
};

TEST_F(TrainingRuns, ARunEndsAfterItsDecisionsAndWritesEverything) {
  const Status done = run(limits());
  ASSERT_TRUE(done) << done.error().text();
  EXPECT_EQ(progress_.size(), 5u);
  EXPECT_FLOAT_EQ(float(progress_.back().share), 1);
  EXPECT_EQ(progress_.back().secondsLeft, 0);
  EXPECT_TRUE(exists("disk/policy.obp") && exists("disk/checkpoint"));
  EXPECT_NE(metrics_.find(R"("step":"5")"), std::string::npos) << "the last iteration";
  EXPECT_NE(metrics_.find(R"("status":"complete")"), std::string::npos);
  size_t events = 0;
  for (const auto& entry : std::filesystem::directory_iterator(in("events"))) {
    const std::string bytes = *io::readFile(entry.path().string());
    for (size_t at = 0; (at = bytes.find("train/approxKl", at)) != std::string::npos; ++at)
      ++events;
  }
  EXPECT_EQ(events, 3u) << "iterations 2, 4 and the last";
}

TEST_F(TrainingRuns, ARunThatIsStoppedSavesItsFiles) {
  const Status done = run(limits(), [](int iteration, Timeout& timeout) {
    if (iteration == 2) timeout.end();
  });
  ASSERT_TRUE(done) << done.error().text();
  EXPECT_EQ(progress_.size(), 2u);
  EXPECT_TRUE(exists("disk/policy.obp") && exists("disk/checkpoint"));
}

TEST_F(TrainingRuns, ARunEndsWithItsTime) {
  RunLimits timed = limits();
  timed.decisions = 1'000'000'000;
  timed.seconds = 0.3;
  const Status done = run(timed);
  ASSERT_TRUE(done) << done.error().text();
  EXPECT_GE(progress_.size(), 1u);
  EXPECT_TRUE(exists("disk/policy.obp"));
}

TEST_F(TrainingRuns, AFailingSaveBetweenGoodOnesIsAWarning) {
  RunLimits often = limits();
  often.saveSeconds = 0;
  const Status done = run(often, [&](int iteration, Timeout&) {
    if (iteration == 2) std::filesystem::rename(in("disk"), in("away"));
    if (iteration == 4) std::filesystem::rename(in("away"), in("disk"));
  });
  ASSERT_TRUE(done) << done.error().text();
  ASSERT_EQ(warnings_.size(), 1u);
  EXPECT_NE(warnings_[0].find("training continues, and saving is tried again later"),
            std::string::npos);
  EXPECT_EQ(notes_, std::vector<std::string>{"the checkpoint and the policy can be saved again"});
}

TEST_F(TrainingRuns, AFailingFirstSaveEndsTheRun) {
  RunLimits often = limits();
  often.saveSeconds = 0;
  const Status done = run(often, [&](int iteration, Timeout&) {
    if (iteration == 1) std::filesystem::rename(in("disk"), in("away"));
  });
  EXPECT_FALSE(done);
  EXPECT_LE(progress_.size(), 2u);
}

TEST_F(TrainingRuns, AFailingLastSaveIsAnError) {
  const Status done = run(limits(), [&](int iteration, Timeout&) {
    if (iteration == 5) std::filesystem::rename(in("disk"), in("away"));
  });
  EXPECT_FALSE(done);
  EXPECT_NE(metrics_.find(R"("status":"failed")"), std::string::npos);
}

}  // namespace
}  // namespace obby::train
