// The options that a client may set for a job, and the resulting command line.
#include "bridge/order.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace obby::bridge {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::string kLevel = "\"level\":\"0123456789abcdef0123456789abcdef\"";

Result<Order> parse(const std::string& members) {
  return parseOrder("{" + kLevel + (members.empty() ? "" : ",") + members + "}", Limits());
}

std::string pathOf(const Result<Order>& order) { return order ? "no error" : order.error().path; }

TEST(Order, a_level_alone_runs_all_its_queries) {
  const auto order = parse("");
  ASSERT_TRUE(order);
  EXPECT_EQ(order->task, Task::solve);
  EXPECT_THAT(order->ask, IsEmpty());
  EXPECT_THAT(order->arguments, IsEmpty());
}

TEST(Order, budget_becomes_options_by_one_table) {
  const auto order = parse(
      "\"budget\":{\"timeLimit\":2.5,\"maxSteps\":9000000000000000,\"solutions\":3,\"diverse\":"
      "true,"
      "\"explain\":false,\"paths\":true,\"heatMap\":true,\"seed\":\"18446744073709551615\"}");
  ASSERT_TRUE(order) << order.error().text();
  EXPECT_THAT(order->arguments,
              ElementsAre("--time-limit=2.5", "--max-steps=9000000000000000", "--solutions=3",
                          "--diverse", "--paths", "--heat-map", "--seed=18446744073709551615"));
}

TEST(Order, budget_is_bounded_and_unknown_names_are_errors) {
  EXPECT_EQ(pathOf(parse("\"budget\":{\"timeLimit\":601}")), "budget.timeLimit");
  EXPECT_EQ(pathOf(parse("\"budget\":{\"timeLimit\":1e999}")), "");  // invalid in JSON
  EXPECT_EQ(pathOf(parse("\"budget\":{\"solutions\":0}")), "budget.solutions");
  EXPECT_EQ(pathOf(parse("\"budget\":{\"solutions\":2.5}")), "budget.solutions");
  EXPECT_EQ(pathOf(parse("\"budget\":{\"solutions\":-1}")), "budget.solutions");
  EXPECT_EQ(pathOf(parse("\"budget\":{\"diverse\":1}")), "budget.diverse");
  EXPECT_EQ(pathOf(parse("\"budget\":{\"seed\":\"1 --output=x\"}")), "budget.seed");
  EXPECT_EQ(pathOf(parse("\"budget\":{\"seed\":\"\"}")), "budget.seed");
  EXPECT_EQ(pathOf(parse("\"budget\":{\"output\":\"/tmp/x\"}")), "budget.\"output\"");
  EXPECT_TRUE(parse("\"budget\":[]"));  // Luau writes an empty table like this
}

TEST(Order, queries_are_checked_by_the_schema) {
  const auto order = parse(
      "\"queries\":[{\"id\":\"a\",\"goal\":{\"position\":[0,1.50,0],\"size\":[5,4,4]},"
      "\"unheardOf\":7}]");
  ASSERT_TRUE(order) << order.error().text();
  EXPECT_THAT(order->records,
              ElementsAre("{\"type\":\"query\",\"id\":\"a\",\"goal\":{\"position\":[0,1.5,0],"
                          "\"size\":[5,4,4]}}"));
  EXPECT_EQ(pathOf(parse("\"queries\":[{},{\"maxJumps\":\"x\"}]")), "queries[1].maxJumps");
  EXPECT_EQ(pathOf(parse("\"queries\":[{\"type\":\"level\"}]")), "queries[0].type");
  EXPECT_EQ(pathOf(parse("\"queries\":[5]")), "queries[0]");
  EXPECT_EQ(pathOf(parse("\"queries\":{\"a\":1}")), "queries");
}

TEST(Order, physics_become_a_params_record) {
  const auto order = parse("\"physics\":{\"gravity\":190.50,\"unheardOf\":1}");
  ASSERT_TRUE(order) << order.error().text();
  EXPECT_EQ(order->physics, "{\"type\":\"params\",\"gravity\":190.5}");
  EXPECT_EQ(pathOf(parse("\"physics\":{\"gravity\":\"x\"}")), "physics.gravity");
  EXPECT_EQ(pathOf(parse("\"physics\":7")), "physics");
  EXPECT_EQ(pathOf(parse("\"task\":\"calibrate\",\"recordings\":[{}],\"physics\":{}")), "physics");
}

TEST(Order, counts_are_bounded) {
  std::string many = "\"ask\":[\"q\"";
  for (int i = 0; i < 1000; i++) many += ",\"q\"";
  EXPECT_EQ(pathOf(parse(many + "]")), "ask");
}

TEST(Order, conflicting_members_are_refused) {
  EXPECT_EQ(pathOf(parse("\"ask\":[\"a\"],\"queries\":[{}]")), "ask");
  EXPECT_EQ(pathOf(parse("\"budget\":{\"trials\":50}")), "budget.trials");
  EXPECT_EQ(pathOf(parse("\"budget\":{\"trials\":50,\"difficulty\":false}")), "budget.trials");
  EXPECT_TRUE(parse("\"budget\":{\"trials\":50,\"difficulty\":true}"));
  EXPECT_TRUE(parse("\"budget\":{\"improve\":0}"));
  EXPECT_EQ(pathOf(parse("\"budget\":{\"improve\":601}")), "budget.improve");
  for (const char* prefer : {"natural", "fast", "safe", "few-jumps", "first"})
    EXPECT_TRUE(parse(fmt::format("\"budget\":{{\"prefer\":\"{}\"}}", prefer))) << prefer;
  for (const char* prefer : {"\"--help\"", "\"\"", "1", "true"})
    EXPECT_EQ(pathOf(parse(fmt::format("\"budget\":{{\"prefer\":{}}}", prefer))), "budget.prefer");
  EXPECT_EQ(pathOf(parse("\"recordings\":[{}]")), "recordings");
  EXPECT_EQ(pathOf(parse("\"recordings\":[{}],\"queries\":[{}]")), "queries");
  const std::string calibrate = "\"task\":\"calibrate\",\"recordings\":[{}]";
  EXPECT_TRUE(parse(calibrate));
  EXPECT_TRUE(parse(calibrate + ",\"budget\":{\"restarts\":2,\"seed\":1}"));
  EXPECT_EQ(pathOf(parse(calibrate + ",\"budget\":{\"timeLimit\":2}")), "budget.timeLimit");
  EXPECT_EQ(pathOf(parse(calibrate + ",\"ask\":[\"a\"]")), "ask");
  EXPECT_EQ(pathOf(parse(calibrate + ",\"warm\":\"j1\"")), "warm");
  EXPECT_EQ(pathOf(parse("\"task\":\"calibrate\"")), "recordings");
  EXPECT_EQ(pathOf(parse("\"budget\":{\"restarts\":2}")), "budget.restarts");
  EXPECT_EQ(pathOf(parseOrder("{}", Limits())), "level");
  EXPECT_EQ(pathOf(parseOrder("{\"level\":\"../../x\"}", Limits())), "level");
  EXPECT_EQ(pathOf(parse("\"warm\":\"/tmp/x\"")), "warm");
  EXPECT_EQ(pathOf(parse(kLevel)), "");  // given twice
}

}  // namespace
}  // namespace obby::bridge
