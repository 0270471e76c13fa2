// Tests the files of a training run: what is written, when a run resumes, and which files are
// refused.
#include "train/run/checkpoint_store.h"

#include "policy/policy_file.h"
#include "train/run_fixture.h"

namespace obby::train {
namespace {

class CheckpointStores : public RunFolder {
 protected:
  std::string refused(RunFiles files) {
    CheckpointStore other = store(std::move(files));
    const Status opened = other.open();
    return opened ? "" : opened.error().text();
  }
};

TEST_F(CheckpointStores, TheDefaultCheckpointIsNextToARegularPolicy) {
  EXPECT_EQ(defaultCheckpoint(in("new.obp")), in("new.obp.checkpoint"));
  EXPECT_EQ(defaultCheckpoint("/dev/null"), "");
}

TEST_F(CheckpointStores, ThePolicySaysHowItWasTrained) {
  CheckpointStore first = store(files());
  const auto trainer = trained(first, 1);
  ASSERT_TRUE(trainer) << trainer.error().text();
  ASSERT_TRUE(first.save(**trainer, 12));
  const auto policy = policy::readPolicy(*io::readFile(in("policy.obp")), "policy");
  ASSERT_TRUE(policy) << policy.error().text();
  EXPECT_EQ(policy->training.command, "obby-train --test");
  EXPECT_EQ(policy->training.decisions, (*trainer)->decisions());
  EXPECT_EQ(policy->training.seconds, 12);
}

TEST_F(CheckpointStores, AResumedRunHasTheSameBits) {
  std::vector<float> whole;
  {
    CheckpointStore first = store(files());
    const auto trainer = trained(first, 1);
    ASSERT_TRUE(trainer) << trainer.error().text();
    ASSERT_TRUE(first.save(**trainer, 12));
    ASSERT_TRUE((*trainer)->iterate());
    whole = (*trainer)->network().numbers();
  }
  CheckpointStore second = store(files(Resume::yes));
  const auto trainer = trained(second, 1);
  ASSERT_TRUE(trainer) << trainer.error().text();
  EXPECT_EQ((*trainer)->iterations(), 2u);
  EXPECT_EQ(second.secondsBefore(), 12);
  EXPECT_EQ((*trainer)->network().numbers(), whole);
}

TEST_F(CheckpointStores, ResumingNeedsACheckpointUnlessItIsAutomatic) {
  EXPECT_NE(refused(files(Resume::yes)).find("use --resume=auto"), std::string::npos);
  EXPECT_EQ(refused(files(Resume::automatic)), "");
  RunFiles toDevice = files(Resume::yes);
  toDevice.policy = "/dev/null";
  toDevice.checkpoint = "";
  EXPECT_NE(refused(toDevice).find("no checkpoint is kept next to it"), std::string::npos);
}

TEST_F(CheckpointStores, OtherSettingsAreRefusedByName) {
  {
    CheckpointStore first = store(files());
    const auto trainer = trained(first, 1);
    ASSERT_TRUE(trainer && first.save(**trainer, 12));
  }
  CheckpointStore second = store(files(Resume::yes));
  ASSERT_TRUE(second.open());
  TrainerSettings other = tiny();
  other.ppo.epochs = 7;
  ASSERT_TRUE(second.setRun(other, {{"levels", "gaps"}}, false));
  const auto trainer = second.trainer(engine());
  ASSERT_FALSE(trainer);
  EXPECT_NE(trainer.error().text().find("'epochs' was 2 in the earlier run and is 7 now"),
            std::string::npos)
      << trainer.error().text();
  EXPECT_EQ(trainer.error().input, in("policy.obp.checkpoint"));
}

TEST_F(CheckpointStores, TrainingStartsFromAPolicy) {
  std::vector<float> numbers;
  {
    CheckpointStore first = store(files());
    const auto trainer = trained(first, 1);
    ASSERT_TRUE(trainer && first.save(**trainer, 12));
    numbers = (*trainer)->network().numbers();
  }
  RunFiles next = files();
  next.policy = in("next.obp");
  next.checkpoint = in("next.checkpoint");
  next.startFrom = in("policy.obp");
  CheckpointStore second = store(next);
  const auto trainer = trained(second, 0);
  ASSERT_TRUE(trainer) << trainer.error().text();
  EXPECT_EQ((*trainer)->iterations(), 0u);
  EXPECT_EQ((*trainer)->network().numbers(), numbers);
}

TEST_F(CheckpointStores, FilesOfARunningRunAreLocked) {
  CheckpointStore first = store(files());
  ASSERT_TRUE(first.open());
  EXPECT_NE(refused(files()).find("--output: another obby-train is writing"), std::string::npos);
  RunFiles other = files();
  other.policy = in("other.obp");
  EXPECT_NE(refused(other).find("--checkpoint: another obby-train is writing"), std::string::npos);
  other.checkpoint = "";
  EXPECT_EQ(refused(other), "");
}

TEST_F(CheckpointStores, FilesThatCannotBeWrittenAreRefusedAtOnce) {
  RunFiles nowhere = files();
  nowhere.policy = in("nowhere/policy.obp");
  EXPECT_NE(refused(nowhere).find("cannot create"), std::string::npos);
}

// A run that ends before it has learned anything does not replace an earlier result.
TEST_F(CheckpointStores, AnUntrainedPolicyReplacesNothing) {
  std::string before;
  {
    CheckpointStore first = store(files());
    const auto trainer = trained(first, 1);
    ASSERT_TRUE(trainer && first.save(**trainer, 12));
    before = *io::readFile(in("policy.obp"));
  }
  CheckpointStore second = store(files());
  const auto trainer = trained(second, 0);
  ASSERT_TRUE(trainer && second.save(**trainer, 0));
  EXPECT_EQ(*io::readFile(in("policy.obp")), before);
}

TEST_F(CheckpointStores, ThePolicyIsWrittenEvenIfTheCheckpointCannotBe) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  RunFiles full = files();
  full.checkpoint = "/dev/full";
  CheckpointStore first = store(full);
  const auto trainer = trained(first, 1);
  ASSERT_TRUE(trainer) << trainer.error().text();
  const Status saved = first.save(**trainer, 12);
  ASSERT_FALSE(saved);
  EXPECT_EQ(saved.error().input, "/dev/full");
  EXPECT_TRUE(exists("policy.obp"));
}

}  // namespace
}  // namespace obby::train
