// Updates of a page about a growing report: each new item is sent once, and thinned out if the data
// gets too large.
#include "view/live_data.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <thread>

#include "course.h"
#include "view/growing_report.h"

namespace obby::view_test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

view::Collector strict(const std::vector<std::string>& only = {}) {
  return view::Collector([](const io::Record&, Error error) -> Status { return error; }, only);
}

// A collector, and the live data of its report.
struct Growing {
  view::Collector collector = strict();
  view::LiveData data{view::PageOptions{false, "test"}};

  void add(const std::vector<std::string>& lines) {
    for (const std::string& text : lines) {
      ASSERT_TRUE(collector.add(recordOf(text)));
      ASSERT_TRUE(collector.update());
    }
    data.take(collector.report(), view::StreamState::open);
  }
  json since(uint64_t revision) const { return json::parse(data.since(revision)); }
};

std::vector<uint64_t> serials(const json& query) {
  std::vector<uint64_t> out;
  for (const json& path : query["trajectories"]) out.push_back(path["serial"]);
  return out;
}

TEST(LiveData, NothingIsThereAtFirst) {
  Growing growing;
  EXPECT_EQ(growing.data.revision(), 0u);
  const json all = growing.since(0);
  EXPECT_EQ(all["revision"], 0);
  EXPECT_EQ(all["head"]["state"], "live");
  EXPECT_TRUE(all["levels"].empty());
  EXPECT_TRUE(all["queries"].empty());
}

TEST(LiveData, APageGetsNewItemsOnce) {
  auto ahead = walk(kAhead, 200), left = walk(kLeft, 300);
  Growing growing;
  growing.add({kLevel, kQuery, line(left)});
  const uint64_t first = growing.data.revision();
  EXPECT_EQ(growing.since(0)["levels"].size(), 1u);
  EXPECT_EQ(serials(growing.since(0)["queries"][0]), (std::vector<uint64_t>{1}));
  growing.add({line(ahead), resultLine("solved", 200)});
  const json news = growing.since(first);
  EXPECT_TRUE(news["levels"].empty());
  EXPECT_EQ(serials(news["queries"][0]), (std::vector<uint64_t>{2}));
  EXPECT_EQ(news["queries"][0]["serials"], json::parse("[[1,2]]"));
  EXPECT_EQ(news["queries"][0]["facts"]["result"]["verdict"], "solved");
  EXPECT_EQ(news["queries"][0]["trajectories"][0]["data"]["kind"], "solution");
  const uint64_t second = growing.data.revision();
  EXPECT_TRUE(growing.since(second)["queries"].empty());
  // A page gets everything if it connects late, or was connected to another server.
  for (const uint64_t from : {uint64_t(0), second + 1}) {
    EXPECT_EQ(serials(growing.since(from)["queries"][0]), (std::vector<uint64_t>{1, 2}));
    EXPECT_EQ(growing.since(from)["levels"].size(), 1u);
  }
}

TEST(LiveData, TheRevisionStaysWithoutChanges) {
  Growing growing;
  growing.add({kLevel, kQuery});
  const uint64_t before = growing.data.revision();
  growing.add({kQuery});
  EXPECT_EQ(growing.data.revision(), before);
  growing.data.take(growing.collector.report(), view::StreamState::ended);
  EXPECT_EQ(growing.data.revision(), before + 1);
  EXPECT_EQ(growing.since(before)["head"]["state"], "ended");
  EXPECT_TRUE(growing.since(before)["queries"].empty());
}

TEST(LiveData, ReplacedTrajectoriesAreRemoved) {
  auto near = walk(kAhead, 40), ahead = walk(kAhead, 200), nearer = walk(kAhead, 60);
  const auto progress = [](io::RecordBuilder& best) {
    io::RecordBuilder builder;
    auto p = builder.root().initProgress();
    p.setQuery("ahead");
    p.setBest(best.reader().getTrajectory());
    return line(builder);
  };
  Growing growing;
  growing.add({kLevel, kQuery, progress(near)});
  growing.add({progress(nearer)});
  EXPECT_EQ(growing.since(0)["queries"][0]["serials"], json::parse("[[2,2]]"));
  growing.add({line(ahead)});
  const json news = growing.since(growing.data.revision() - 1);
  EXPECT_EQ(news["queries"][0]["serials"], json::parse("[[3,3]]"));
}

TEST(LiveData, LongerTrajectoriesRarelyResendMotion) {
  // The door moves only once and takes a minute, so its track grows with the time shown.
  std::string level = kLevel;
  const std::string fan = R"("spin":{"speed":3})";
  level.replace(level.find(fan), fan.size(),
                R"("keys":[{"position":[-30,2,-10]},{"time":60,"position":[-30,20,-10]}])");
  Growing growing;
  growing.add({level, kQuery});
  EXPECT_EQ(growing.since(0)["levels"].size(), 1u);
  size_t sent = 0;
  for (uint32_t ticks = 200; ticks <= 2600; ticks += 200) {
    auto trajectory = walk(kAhead, 2);  // the player stops after the walk
    auto runs = trajectory.root().getTrajectory().initActions(1);
    runs[0].setTicks(ticks);
    trajectory.root().getTrajectory().setTicks(ticks);
    const uint64_t before = growing.data.revision();
    growing.add({line(trajectory)});
    sent += growing.since(before)["levels"].size();
  }
  EXPECT_EQ(sent, 2u);  // sent at 20 and 40 seconds
}

TEST(LiveData, AttemptsBeyondThePagesSizeAreResentThinned) {
  const auto longest = [] {
    auto trajectory = walk(kAhead, 2);
    auto path = trajectory.root().getTrajectory();
    path.initActions(1)[0].setTicks(60000);
    path.setTicks(60000);
    path.setOutcome(schema::Outcome::RUNNING);
    path.setStateHash(0);
    return line(trajectory);
  }();
  Growing growing;
  growing.add({kLevel, kQuery, longest});
  EXPECT_EQ(growing.since(0)["queries"][0]["trajectories"][0]["data"]["stride"], 1);
  uint64_t before = 0;
  for (int i = 0; i < 20; ++i) {  // 1.2 MB each
    before = growing.data.revision();
    growing.add({longest});
    if (growing.since(before)["queries"][0]["trajectories"].size() > 1) break;
  }
  const json news = growing.since(before);
  for (const json& path : news["queries"][0]["trajectories"]) EXPECT_EQ(path["data"]["stride"], 2);
  EXPECT_GT(news["queries"][0]["trajectories"].size(), 10u);
  EXPECT_THAT(news["head"]["notes"].dump(), HasSubstr("one tick in 2"));
  EXPECT_LT(growing.data.since(0).size(), view::kPageTarget);
}

TEST(GrowingReport, CanBeReadWhileAnotherThreadAdds) {
  constexpr int kTrajectories = 200;
  auto left = walk(kLeft, 60);
  const std::string trajectory = line(left);
  view::GrowingReport report(strict());
  std::atomic<size_t> looks{0};
  std::thread reading([&] {
    EXPECT_TRUE(report.add(recordOf(kLevel)));
    EXPECT_TRUE(report.add(recordOf(kQuery)));
    while (looks == 0)
      std::this_thread::yield();  // otherwise the writer may finish before the first look
    for (int i = 0; i < kTrajectories; ++i) EXPECT_TRUE(report.add(recordOf(trajectory)));
    EXPECT_TRUE(report.end(view::StreamState::ended, {"a note"}));
  });
  size_t last = 0;
  bool ended = false;
  while (!ended) {
    report.look([&](const view::Report& seen, view::StreamState state) {
      const size_t trajectories = seen.queries.empty() ? 0 : seen.queries[0].paths.size();
      EXPECT_GE(trajectories, last);
      last = trajectories;
      ++looks;
      ended = state == view::StreamState::ended;
      if (ended) {
        EXPECT_EQ(seen.notes, std::vector<std::string>{"a note"});
      }
    });
    std::this_thread::yield();
  }
  reading.join();
  EXPECT_EQ(last, size_t(kTrajectories));
  EXPECT_GT(looks.load(), 1u);
  EXPECT_FALSE(report.look([](const view::Report&, view::StreamState) {}));  // no change
}

TEST(GrowingReport, ClosingReleasesWaitingThreads) {
  view::GrowingReport report(strict());
  std::atomic<bool> busy{false}, asked{false};
  std::thread reading([&] {
    EXPECT_TRUE(report.use([&](const view::Report&) -> Status {
      busy = true;
      while (!asked) std::this_thread::yield();
      return {};
    }));
    EXPECT_TRUE(report.add(recordOf(kLevel)));  // waits for its turn unless the report is closed
  });
  while (!busy) std::this_thread::yield();
  EXPECT_FALSE(report.look([](const view::Report&, view::StreamState) {}));
  asked = true;
  report.close();
  reading.join();
}

TEST(GrowingReport, AMissingQueryIsAnError) {
  view::GrowingReport report(strict({"never"}));
  EXPECT_TRUE(report.add(recordOf(kLevel)));
  EXPECT_FALSE(report.end(view::StreamState::ended, {}));
  EXPECT_TRUE(report.look([](const view::Report& seen, view::StreamState state) {
    EXPECT_EQ(state, view::StreamState::broken);
    EXPECT_THAT(seen.notes.at(0), HasSubstr("never"));
  }));
}

}  // namespace
}  // namespace obby::view_test
