// Commands as text for a shell.
#include "cli/command_text.h"

#include <gtest/gtest.h>

namespace obby::cli {
namespace {

Arguments::Value valueOf(ValueType type, std::vector<std::string> texts) {
  Arguments::Value value;
  value.row.type = type;
  value.texts = std::move(texts);
  value.given = true;
  return value;
}

TEST(CommandText, WordsAreQuotedOnlyIfNecessary) {
  EXPECT_EQ(shellWord("levels/gap-2.jsonl"), "levels/gap-2.jsonl");
  EXPECT_EQ(shellWord(""), "''");
  EXPECT_EQ(shellWord("a b"), "'a b'");
  EXPECT_EQ(shellWord("it's"), "'it'\\''s'");
}

TEST(CommandText, OptionsAreWrittenAsTyped) {
  EXPECT_EQ(optionText("seed", valueOf(ValueType::seed, {"3"})), "--seed 3");
  EXPECT_EQ(optionText("style", valueOf(ValueType::text, {"gaps", "a b"})),
            "--style gaps --style 'a b'");
  EXPECT_EQ(optionText("resume", valueOf(ValueType::mode, {"auto"})), "--resume=auto");
  EXPECT_EQ(optionText("quiet", valueOf(ValueType::flag, {"true"})), "--quiet");
  EXPECT_EQ(optionText("quiet", valueOf(ValueType::flag, {"false"})), "");
  EXPECT_EQ(optionText("config", valueOf(ValueType::file, {})), "");
}

TEST(CommandText, ACommandHasTheGivenOptionsAndInputs) {
  Arguments arguments;
  arguments.values["seed"] = valueOf(ValueType::seed, {"3"});
  arguments.values["resume"] = valueOf(ValueType::mode, {"yes"});
  arguments.values["worlds"] = valueOf(ValueType::integer, {"256"});
  arguments.values["worlds"].given = false;
  arguments.inputs = {"-", "my level"};
  EXPECT_EQ(commandText("obby-train", arguments, {"resume"}), "obby-train --seed 3 'my level'");
}

TEST(CommandText, AllOptionsAreListedForAComparison) {
  Arguments arguments;
  arguments.values["seed"] = valueOf(ValueType::seed, {"3"});
  arguments.values["style"] = valueOf(ValueType::text, {});
  arguments.values["threads"] = valueOf(ValueType::integer, {"2"});
  arguments.inputs = {"level"};
  EXPECT_EQ(optionTexts(arguments, {"threads"}),
            (std::vector<std::string>{"with --seed 3", "without --style", "with 1 input",
                                      "with the input level"}));
}

}  // namespace
}  // namespace obby::cli
