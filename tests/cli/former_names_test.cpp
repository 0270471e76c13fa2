// Former names of options are accepted everywhere but never shown.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <cstdio>
#include <fstream>

#include "cli/completion.h"
#include "cli/help.h"
#include "cli/manual.h"
#include "cli/parse.h"
#include "cli/rows.h"

namespace obby::cli {
namespace {

ToolSpec renamedTool() {
  ToolSpec spec;
  spec.name = "obby-test";
  spec.summary = "test";
  spec.examples = {{"nothing", "true"}};
  OptionRow again = row("again", ValueType::mode, "MODE", "no", "go on", "Options");
  again.choices = {"no", "yes"};
  again.bare = "yes";
  spec.options = {
      renamed(row("epochs", ValueType::integer, "N", "2", "rounds", "Options"), "laps"),
      renamed(row("fast", ValueType::flag, "", "", "hurry", "Options"), "swift"),
      renamed(std::move(again), "onward"),
      renamed(repeatable(row("style", ValueType::text, "NAME", "", "look", "Options")), "fashion")};
  return spec;
}

Result<Arguments> renamedResolve(std::vector<std::string> words) {
  const ToolSpec spec = renamedTool();
  const auto rows = allRows(spec);
  words.insert(words.begin(), spec.name);
  std::vector<char*> argv;
  for (auto& word : words) argv.push_back(word.data());
  return resolveArguments(spec, rows, parseCommandLine(spec, rows, int(argv.size()), argv.data()));
}

TEST(FormerOptionNames, EveryTypeOfOptionIsParsedByItsFormerName) {
  const auto a = renamedResolve(
      {"--laps", "3", "--swift", "--onward", "--fashion", "x", "--style=y", "--laps=4", "file"});
  ASSERT_TRUE(a) << a.error().text();
  EXPECT_EQ(a->integer("epochs"), 4);
  EXPECT_TRUE(a->flag("fast"));
  EXPECT_EQ(a->text("again"), "yes");
  EXPECT_EQ(a->list("style"), (std::vector<std::string>{"x", "y"}));
  EXPECT_EQ(a->inputs, std::vector<std::string>{"file"});
  EXPECT_TRUE(a->typed("epochs"));
  EXPECT_EQ(renamedResolve({"--onward=no"})->text("again"), "no");
  EXPECT_FALSE(renamedResolve({"--swift=false"})->flag("fast"));
}

TEST(FormerOptionNames, TheLastOfBothNamesCounts) {
  EXPECT_EQ(renamedResolve({"--epochs", "3", "--laps", "5"})->integer("epochs"), 5);
  EXPECT_EQ(renamedResolve({"--laps", "3", "--epochs", "5"})->integer("epochs"), 5);
}

TEST(FormerOptionNames, VariablesAndConfigurationFilesMayUseThem) {
  setenv("OBBY_LAPS", "7", 1);
  EXPECT_EQ(renamedResolve({})->integer("epochs"), 7);
  setenv("OBBY_EPOCHS", "8", 1);
  EXPECT_EQ(renamedResolve({})->integer("epochs"), 8);
  unsetenv("OBBY_EPOCHS");
  unsetenv("OBBY_LAPS");
  const std::string path = testing::TempDir() + "obby-former-names";
  std::ofstream(path) << "laps = 9\n";
  const auto a = renamedResolve({"--config", path});
  ASSERT_TRUE(a) << a.error().text();
  EXPECT_EQ(a->integer("epochs"), 9);
  EXPECT_EQ(std::remove(path.c_str()), 0);
}

TEST(FormerOptionNames, ErrorsNameThePresentName) {
  EXPECT_EQ(renamedResolve({"--laps", "x"}).error().text().substr(0, 9), "--epochs:");
  EXPECT_EQ(renamedResolve({"--laps"}).error().text(), "--epochs: needs a value");
  EXPECT_EQ(renamedResolve({"--lap", "3"}).error().text(),
            "--lap: unknown option (see obby-test --help)");
}

TEST(FormerOptionNames, HelpManualAndCompletionShowOnlyPresentNames) {
  const ToolSpec spec = renamedTool();
  const auto rows = allRows(spec);
  std::string shown = helpText(spec, rows, {80, true}) + manualPage(spec, rows);
  for (const char* shell : {"bash", "zsh", "fish"}) shown += completionScript(spec, rows, shell);
  EXPECT_NE(shown.find("epochs"), std::string::npos);
  for (const char* former : {"laps", "swift", "onward", "fashion"})
    EXPECT_EQ(shown.find(former), std::string::npos) << former;
}

}  // namespace
}  // namespace obby::cli
