// Tests environment variables that misspell an option.
#include "cli/variables.h"

#include <gtest/gtest.h>

#include "cli/rows.h"

namespace obby::cli {
namespace {

std::string slips(std::vector<const char*> environment) {
  environment.push_back(nullptr);
  std::vector<OptionRow> rows = universalRows();
  rows.push_back(commonRow(Common::timeLimit));
  OptionRow own;
  own.name = "juggle";  // an option that only this tool has
  own.formerly = "time-limits";
  rows.push_back(own);
  std::string out;
  for (const MisspeltVariable& slip : misspeltVariables(rows, environment.data()))
    out += slip.name + " " + slip.meant + "; ";
  return out;
}

TEST(Variables, AMisspeltOneNamesTheNearestOption) {
  EXPECT_EQ(slips({"HOME=/", "OBBY_TIME_LIMT=3", "OBBY_VERBOS=no"}),
            "OBBY_TIME_LIMT OBBY_TIME_LIMIT; OBBY_VERBOS OBBY_VERBOSE; ");
  EXPECT_EQ(slips({"OBBY_JUGLE=1"}), "OBBY_JUGLE OBBY_JUGGLE; ");
}

TEST(Variables, VariablesOfAnyToolAreNotMisspelt) {
  EXPECT_EQ(slips({"OBBY_TIME_LIMIT=3", "OBBY_JUGGLE=1", "OBBY_QUIET=1"}), "");
  EXPECT_EQ(slips({"OBBY_MAX_TIME=3", "OBBY_TRIALS=1", "OBBY_CONFIG=c"}), "");
}

TEST(Variables, AFormerNameIsNotMisspeltAndIsNotSuggested) {
  EXPECT_EQ(slips({"OBBY_TIME_LIMITS=3"}), "");
  EXPECT_EQ(slips({"OBBY_TIME_LIMITZ=3"}), "OBBY_TIME_LIMITZ OBBY_TIME_LIMIT; ");
}

TEST(Variables, VariablesUnlikeAnyOptionAreIgnored) {
  EXPECT_EQ(slips({"OBBY_PRESET=ci", "OBBY_WRITE_GOLDEN=1", "OBBY=1", "OBBY_", "OBBY_=1",
                   "OBBY_VERBOS="}),
            "");
  EXPECT_EQ(slips({"LOBBY_TIME_LIMT=1", "obby_verbos=1"}), "");
}

}  // namespace
}  // namespace obby::cli
