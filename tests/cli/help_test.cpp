// The help text and its width.
#include "cli/help.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "cli/parse.h"
#include "cli/rows.h"

namespace obby::cli {
namespace {

ToolSpec exampleTool() {
  ToolSpec spec;
  spec.name = "obby-test";
  spec.summary = "test what help does with a summary that is a little longer than it has to be";
  for (int i = 1; i <= 7; i++) spec.examples.push_back({fmt::format("Do it {} times", i), "true"});
  spec.options = {commonRow(Common::output), commonRow(Common::progress), commonRow(Common::seed),
                  withDefault(commonRow(Common::timeLimit), "5")};
  spec.options.push_back(rare(row("strange", ValueType::flag, "", "", "few want this",
                                  "Strange options for those who want them")));
  OptionRow method = row("method", ValueType::choice, "", "auto", "how to do it", "Options");
  method.choices = {"auto",    "quickly",     "thoroughly", "elegantly",
                    "cheaply", "in-parallel", "again"};
  method.details = "auto: whatever is best\nquickly: before anyone looks";
  spec.options.push_back(method);
  return spec;
}

std::string helpOf(const ToolSpec& spec, size_t width, bool all = false) {
  return helpText(spec, allRows(spec), {width, all});
}

size_t widest(const std::string& text) {
  std::istringstream lines(text);
  size_t out = 0;
  for (std::string line; std::getline(lines, line);) out = std::max(out, line.size());
  return out;
}

size_t countOf(const std::string& text, const std::string& part) {
  size_t out = 0;
  for (size_t i = text.find(part); i != std::string::npos; i = text.find(part, i + 1)) out++;
  return out;
}

bool has(const std::string& text, const std::string& part) { return countOf(text, part) > 0; }

TEST(Help, FitsTheWidth) {
  ToolSpec spec = exampleTool();
  spec.name = "obby-with-a-long-name";
  const std::string fits(40, 'f'), sentence(30, 's');
  spec.notes = sentence + " " + sentence + "\n\n" + fits;
  for (const size_t width : {40, 63, 64, 80, 120}) {
    for (const bool all : {false, true}) EXPECT_LE(widest(helpOf(spec, width, all)), width);
  }
  EXPECT_GT(widest(helpOf(spec, 120)), 100u);
  EXPECT_TRUE(has(helpOf(spec, 40), "\n\n" + sentence + "\n" + sentence + "\n\n" + fits + "\n"));
}

TEST(Help, HasOneColumnOnANarrowTerminalAndTwoElsewhere) {
  EXPECT_TRUE(has(helpOf(exampleTool(), 80), "\n      --seed N              random seed"));
  EXPECT_TRUE(has(helpOf(exampleTool(), 40), "\n      --seed N\n        random seed"));
}

TEST(Help, BreaksAListOfChoicesAfterABar) {
  EXPECT_TRUE(has(helpOf(exampleTool(), 40),
                  "\n      --method auto|quickly|thoroughly|\n          elegantly|"))
      << helpOf(exampleTool(), 40);
}

TEST(Help, ShowsFiveExamplesAndTheCommonOptions) {
  const std::string few = helpOf(exampleTool(), 80), all = helpOf(exampleTool(), 80, true);
  EXPECT_EQ(countOf(few, "\n  $ "), 5u);
  EXPECT_EQ(countOf(all, "\n  $ "), 7u);
  for (const char* rare :
       {"--strange", "Strange options for", "--json-errors", "quickly: before"}) {
    EXPECT_FALSE(has(few, rare)) << rare;
    EXPECT_TRUE(has(all, rare)) << rare;
  }
  EXPECT_TRUE(has(few, "how to do it [default: auto] (see --help-all)"));
  EXPECT_TRUE(has(few, "obby-test --help-all"));
  EXPECT_FALSE(has(all, "--man"));
}

TEST(Help, PutsMessagesLastAndEachGroupOnce) {
  const std::string text = helpOf(exampleTool(), 80);
  EXPECT_EQ(countOf(text, "\nHelp and messages:\n"), 1u);
  EXPECT_GT(text.find("\nHelp and messages:\n"), text.find("--method"));
  EXPECT_GT(text.find("--progress"), text.find("\nHelp and messages:\n"));
}

TEST(Help, BreaksALongExampleAfterItsOperators) {
  ToolSpec spec = exampleTool();
  spec.examples = {{"Do much", "obby-gen --count 60 --style gaps && obby-solve x | obby-view"}};
  EXPECT_TRUE(has(helpOf(spec, 80),
                  "\n  $ obby-gen --count 60 --style gaps && obby-solve x | obby-view\n"));
  EXPECT_TRUE(
      has(helpOf(spec, 40),
          "\n  $ obby-gen --count 60 --style gaps && \\\n        obby-solve x | obby-view\n"))
      << helpOf(spec, 40);
}

TEST(Help, VersionNamesTheSchema) {
  const std::string line = versionLine(exampleTool());
  EXPECT_TRUE(line.starts_with("obby-test ")) << line;
  EXPECT_TRUE(has(line, "schema ")) << line;
  EXPECT_EQ(line.back(), ')') << line;
}

}  // namespace
}  // namespace obby::cli
