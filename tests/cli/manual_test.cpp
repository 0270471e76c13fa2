// Manual pages: text that roff would interpret, and required sections.
#include "cli/manual.h"

#include <gtest/gtest.h>

#include "cli/parse.h"
#include "cli/roff.h"
#include "cli/rows.h"

namespace obby::cli {
namespace {

TEST(Roff, TextIsNeitherARequestNorAnEscape) {
  EXPECT_EQ(roff::escaped("--seed=\\n"), "\\-\\-seed=\\en");
  EXPECT_EQ(roff::escaped(".capnp, 'x'\n.TH"), "\\&.capnp, \\(aqx\\(aq\n\\&.TH");
  EXPECT_EQ(roff::escaped("a.b `c` ~ ^"), "a.b \\(gac\\(ga \\(ti \\(ha");
  EXPECT_EQ(roff::argument("say \"hi\""), "\"say \\(dqhi\\(dq\"");
  EXPECT_EQ(roff::bold("-o"), "\\fB\\-o\\fR");
}

TEST(Manual, HasDetailsThatHelpOmitsButNoHiddenOptions) {
  ToolSpec spec;
  spec.name = "obby-view";
  spec.summary = "show it";
  spec.examples = {{"Show it", "obby-view 'a b'"}};
  spec.options = {rare(
      detailed(row("odd", ValueType::text, "X", "", "be odd", "Odd options"), "First.\n.Second."))};
  spec.notes = "One.\n\nTwo.";
  spec.details = "Three.";
  spec.exitCodes = {{"1", "No."}};
  spec.files = {{"~/.x", "A file."}};
  const std::string page = manualPage(spec, allRows(spec));
  for (const char* part : {".TH OBBY\\-VIEW 1 ", "\n.SH NAME\nobby\\-view \\- show it\n",
                           "\n.PP\nTwo.\n", "\nThree.\n",
                           "\n.SS \"Odd options\"\n.TP\n\\fB\\-\\-odd\\fR \\fIX\\fR\nBe "
                           "odd.\n.br\nFirst.\n.br\n\\&.Second.\n",
                           "\n.nf\nobby\\-view \\(aqa b\\(aq\n.fi\n", "\n.TP\n\\fB1\\fR\nNo.\n",
                           "\\(ti/.x", "\\fBobby\\-solve\\fR(1)", "\\-\\-json\\-errors"}) {
    EXPECT_NE(page.find(part), std::string::npos) << part << page;
  }
  EXPECT_EQ(page.find("\\-\\-man\\fR"), std::string::npos);
  EXPECT_EQ(page.find("\\fBobby\\-view\\fR(1)"), std::string::npos);
}

}  // namespace
}  // namespace obby::cli
