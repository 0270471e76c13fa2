// Values of options: accepted values, errors, and the precedence of sources.
#include "cli/arguments.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <cstdio>
#include <fstream>

#include "cli/check_value.h"
#include "cli/parse.h"
#include "cli/rows.h"

namespace obby::cli {
namespace {

OptionRow integerRow(double min, double max) {
  OptionRow row;
  row.name = "count";
  row.type = ValueType::integer;
  row.min = min;
  row.max = max;
  return row;
}

std::string verdict(const OptionRow& row, std::string text) {
  const auto wrong = checkValue(row, text);
  return wrong ? *wrong : "ok " + text;
}

TEST(Joined, KeepsTheOrderOfGroupsAndRows) {
  const OptionRow a = flagRow("a", "", ""), b = flagRow("b", "", ""), c = flagRow("c", "", "");
  std::vector<std::string> names;
  for (const OptionRow& row : joined({{b, a}, {}, {c}})) names.push_back(row.name);
  EXPECT_EQ(names, (std::vector<std::string>{"b", "a", "c"}));
}

TEST(CheckValue, NumbersMustBeWholeTextsInRange) {
  const OptionRow row = integerRow(-3, 16);
  EXPECT_EQ(verdict(row, "16"), "ok 16");
  EXPECT_EQ(verdict(row, "-3"), "ok -3");
  for (const char* bad : {"17", "-4", "1.0", "1x", "", " 1", "+1", "99999999999999999999"})
    EXPECT_EQ(verdict(row, bad),
              "expected a whole number from -3 to 16, found \"" + std::string(bad) + "\"");
  OptionRow open = row;
  open.type = ValueType::number;
  open.max = std::numeric_limits<double>::max();
  EXPECT_EQ(verdict(open, "1e300"), "ok 1e300");
  EXPECT_EQ(verdict(open, "inf"), "expected a number of at least -3, found \"inf\"");
  EXPECT_EQ(verdict(open, "nan"), "expected a number of at least -3, found \"nan\"");
}

TEST(CheckValue, SeedsCoverAll64Bits) {
  const OptionRow row = commonRow(Common::seed);
  EXPECT_EQ(verdict(row, "18446744073709551615"), "ok 18446744073709551615");
  EXPECT_NE(verdict(row, "18446744073709551616").substr(0, 2), "ok");
  EXPECT_NE(verdict(row, "-1").substr(0, 2), "ok");
}

TEST(CheckValue, FlagsHaveManySpellingsAndTwoMeanings) {
  OptionRow row;
  for (const char* yes : {"true", "1", "yes", "on"}) EXPECT_EQ(verdict(row, yes), "ok true");
  for (const char* no : {"false", "0", "no", "off"}) EXPECT_EQ(verdict(row, no), "ok false");
  EXPECT_EQ(verdict(row, "si"), "expected true or false, found \"si\"");
}

TEST(CheckValue, ChoicesSuggestTheNearest) {
  const OptionRow row = commonRow(Common::backend);
  EXPECT_EQ(verdict(row, "cuda"), "ok cuda");
  EXPECT_EQ(verdict(row, "cud"),
            "expected one of auto, cpu, cuda, found \"cud\" (did you mean cuda?)");
  EXPECT_EQ(verdict(row, "fpga"), "expected one of auto, cpu, cuda, found \"fpga\"");
}

ToolSpec tool() {
  ToolSpec spec;
  spec.name = "obby-test";
  spec.summary = "test";
  spec.examples = {{"nothing", "true"}};
  spec.options = {commonRow(Common::seed), withDefault(commonRow(Common::timeLimit), "5")};
  return spec;
}

Result<Arguments> resolve(std::vector<std::string> words) {
  const ToolSpec spec = tool();
  const auto rows = allRows(spec);
  words.insert(words.begin(), spec.name);
  std::vector<char*> argv;
  for (auto& word : words) argv.push_back(word.data());
  return resolveArguments(spec, rows, parseCommandLine(spec, rows, int(argv.size()), argv.data()));
}

TEST(Arguments, TheCommandLineWinsOverTheEnvironmentOverTheDefault) {
  EXPECT_EQ(resolve({})->number("time-limit"), 5);
  EXPECT_FALSE(resolve({})->has("time-limit"));
  setenv("OBBY_TIME_LIMIT", "7", 1);
  EXPECT_EQ(resolve({})->number("time-limit"), 7);
  EXPECT_TRUE(resolve({})->has("time-limit"));
  EXPECT_EQ(resolve({"--time-limit", "8"})->number("time-limit"), 8);
  setenv("OBBY_TIME_LIMIT", "x", 1);
  EXPECT_EQ(resolve({}).error().text(),
            "OBBY_TIME_LIMIT: expected a number from 0 to 1000000000, found \"x\"");
  unsetenv("OBBY_TIME_LIMIT");
}

// A file from --print-config states defaults that the user did not choose.
TEST(Arguments, AConfigurationFileWithTheDefaultSetsNothing) {
  const std::string path = testing::TempDir() + "obby-states-the-default";
  const auto given = [&](const std::string& text) {
    std::ofstream(path) << text;
    const auto arguments = resolve({"--config", path});
    EXPECT_TRUE(arguments) << arguments.error().text();
    return arguments->has("time-limit");
  };
  EXPECT_FALSE(given("time-limit = 5\n"));
  EXPECT_TRUE(given("time-limit = 6\n"));
  EXPECT_EQ(std::remove(path.c_str()), 0);
}

TEST(Arguments, OnlyTheCommandLineIsTypedAndAFlagOnlyAsOn) {
  EXPECT_TRUE(resolve({"--seed", "0"})->typed("seed"));
  EXPECT_TRUE(resolve({"-q"})->typed("quiet"));
  EXPECT_FALSE(resolve({"--quiet=no"})->typed("quiet"));
  setenv("OBBY_QUIET", "yes", 1);
  EXPECT_TRUE(resolve({})->flag("quiet"));
  EXPECT_FALSE(resolve({})->typed("quiet"));
  unsetenv("OBBY_QUIET");
}

TEST(Arguments, AnOptionWithoutEffectIsRefusedByName) {
  const auto refused = [](std::vector<std::string> words) {
    const Status status = refuseTyped(*resolve(std::move(words)), {"seed", "quiet"}, "no", "why");
    return status ? "" : status.error().text();
  };
  EXPECT_EQ(refused({"--time-limit", "3", "--quiet=false"}), "");
  EXPECT_EQ(refused({"-q"}), "--quiet: no (why)");
  EXPECT_EQ(refused({"-q", "--seed", "1"}), "--seed: no (why)");
}

TEST(Arguments, InputsKeepTheirOrderAmongOptions) {
  const auto arguments = resolve({"b", "--seed", "3", "-", "-q", "--", "--seed", "-v"});
  ASSERT_TRUE(arguments) << arguments.error().text();
  EXPECT_EQ(arguments->inputs, (std::vector<std::string>{"b", "-", "--seed", "-v"}));
  EXPECT_EQ(arguments->seed(), 3u);
  EXPECT_TRUE(arguments->flag("quiet"));
  EXPECT_FALSE(arguments->flag("verbose"));
  EXPECT_EQ(resolve({})->inputs, std::vector<std::string>{"-"});
  EXPECT_EQ(resolve({"-", "b", "-"}).error().text(),
            "- is given twice (standard input can be read only once)");
}

TEST(Arguments, AnEmptyValueDoesNotTakeTheNextWord) {
  EXPECT_EQ(resolve({"--seed=", "5"}).error().text(),
            "--seed: expected a whole number from 0 to 2^64 - 1, found \"\"");
  EXPECT_EQ(resolve({"--quiet=", "5"}).error().text(),
            "--quiet: expected true or false, found \"\"");
  const auto arguments = resolve({"--", "--seed=", "--x=[y]", "[z]"});
  ASSERT_TRUE(arguments) << arguments.error().text();
  EXPECT_EQ(arguments->inputs, (std::vector<std::string>{"--seed=", "--x=[y]", "[z]"}));
}

TEST(Arguments, LettersMayBeJoinedAndValuesMayFollowDirectly) {
  const auto arguments = resolve({"-qv"});
  ASSERT_TRUE(arguments);
  EXPECT_TRUE(arguments->flag("quiet") && arguments->flag("verbose"));
}

}  // namespace
}  // namespace obby::cli
