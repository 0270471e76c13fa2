// The bridge's private folder.
#include "bridge/store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <thread>

#include "io/scratch_folder.h"

namespace obby::bridge {
namespace {

using testing::ElementsAre;

const std::string kLines =
    "{\"type\":\"level\",\"name\":\"a\"}\n{\"type\":\"query\",\"id\":\"q \\\"1\\\"\"}\n"
    "{\"type\":\"level\",\"name\":\"b\"}\n{\"type\":\"query\"}\n";

TEST(Store, folder_is_closed_to_others) {
  const test::ScratchFolder folder;
  ASSERT_EQ(mkdir((folder / "state").c_str(), 0755), 0);
  ASSERT_TRUE(Store::open(folder / "state", Limits()));
  struct stat about {};
  for (const char* part : {"state", "state/levels", "state/answers"}) {
    ASSERT_EQ(stat((folder / part).c_str(), &about), 0);
    EXPECT_EQ(about.st_mode & 0777, 0700u) << part;
  }
}

TEST(Store, a_failure_to_create_the_folder_states_the_remedy) {
  const test::ScratchFolder folder;
  std::ofstream(folder / "file") << "x";
  const auto store = Store::open(folder / "file", Limits());
  ASSERT_FALSE(store);
  EXPECT_NE(store.error().hint.find("--state-dir"), std::string::npos);
  EXPECT_FALSE(Store::open(folder / "file/below", Limits()));
}

TEST(Store, levels_are_restored_in_parts) {
  const test::ScratchFolder folder;
  const auto store = Store::open(folder / "state", Limits());
  ASSERT_TRUE(store);
  const std::string id = Store::idOf("some bytes");
  EXPECT_EQ(id.size(), 32u);
  EXPECT_EQ(id, Store::idOf("some bytes"));
  EXPECT_NE(id, Store::idOf("some byteS"));
  EXPECT_FALSE(store->has(id));
  ASSERT_TRUE(store->put(id, kLines, {}));
  const auto level = store->get(id);
  ASSERT_TRUE(level && *level);
  EXPECT_EQ((*level)->levels,
            "{\"type\":\"level\",\"name\":\"a\"}\n{\"type\":\"level\",\"name\":\"b\"}\n");
  EXPECT_THAT((*level)->queries,
              ElementsAre("{\"type\":\"query\",\"id\":\"q \\\"1\\\"\"}", "{\"type\":\"query\"}"));
  EXPECT_EQ(queryIdOfLine((*level)->queries[0]), "q \"1\"");
  EXPECT_EQ(queryIdOfLine((*level)->queries[1]), "");
}

TEST(Store, reports_on_a_level_are_kept_with_it) {
  const std::vector<std::string> reports = {"{\"type\":\"warning\",\"message\":\"no start\"}",
                                            "{\"message\":\"odd\"}"};
  const test::ScratchFolder folder;
  Limits limits;
  limits.storeBytes = 2 * kLines.size();
  const auto store = Store::open(folder / "state", limits);
  ASSERT_TRUE(store);
  ASSERT_TRUE(store->put("a", kLines, reports));
  const auto level = store->get("a");
  ASSERT_TRUE(level && *level);
  EXPECT_EQ((*level)->reports, reports);
  EXPECT_EQ((*level)->queries.size(), 2u);
  EXPECT_EQ((*level)->levels.find("no start"), std::string::npos);
  ASSERT_TRUE(
      store->put("b", kLines, {}));  // the store is too small for both levels and the reports
  EXPECT_FALSE(store->has("a"));
}

TEST(Store, least_recently_used_levels_go_first) {
  const test::ScratchFolder folder;
  Limits limits;
  limits.storeBytes = 3 * kLines.size();
  const auto store = Store::open(folder / "state", limits);
  ASSERT_TRUE(store);
  const auto pause = [] { std::this_thread::sleep_for(std::chrono::milliseconds(20)); };
  for (const char* id : {"a", "b", "c"}) {
    ASSERT_TRUE(store->put(id, kLines, {}));
    pause();
  }
  ASSERT_TRUE(store->get("a"));  // most recently used
  pause();
  ASSERT_TRUE(store->put("d", kLines, {}));
  EXPECT_TRUE(store->has("a"));
  EXPECT_FALSE(store->has("b"));
  EXPECT_TRUE(store->has("c"));
  EXPECT_TRUE(store->has("d"));
}

TEST(Store, record_lines_have_a_type) {
  EXPECT_EQ(typeOfLine("{\"type\":\"level\",\"name\":\"x\"}"), "level");
  EXPECT_EQ(typeOfLine("{\"type\":\"level"), "");
  EXPECT_EQ(typeOfLine("{\"name\":\"x\",\"type\":\"level\"}"), "");
  EXPECT_EQ(typeOfLine(""), "");
}

}  // namespace
}  // namespace obby::bridge
