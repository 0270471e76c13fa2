// The page states the result of the fit, and draws the trajectories.
#include "calibrate/page.h"

#include <gtest/gtest.h>

namespace obby::calibrate {
namespace {

Outcome outcome(const std::string& name, float off) {
  Outcome out{name, false, {}, {}};
  for (int i = 0; i < 2000; ++i) {
    out.path.seconds.push_back(i / 60.0);
    out.path.recorded.push_back({float(i) * 0.1f, 3, 0});
    out.path.simulated.push_back({float(i) * 0.1f, 3 + off, 0});
  }
  out.miss = missOf(out.path);
  return out;
}

Fit fitOf() {
  Fit fit;
  fit.controlRate = 240;
  fit.substeps = 1;
  const Parameter gravity{"gravity", "studs/s^2", 98.1, 392.4, "jump on the flat"};
  const Parameter slope{"max<Slope>", "rad", 1, 2, "walk up ramps"};
  fit.parameters = {{gravity, 190, 189.5, 190.5, true, 196.2}, {slope, 1.5, 1, 2, false, 1.5}};
  return fit;
}

TEST(Miss, IsTheDistanceOfAPathFromTheRecording) {
  const Miss near = missOf(outcome("near", 0.25f).path), far = missOf(outcome("far", 2).path);
  EXPECT_NEAR(near.mean, 0.25, 1e-5);
  EXPECT_NEAR(near.max, 0.25, 1e-5);
  EXPECT_LT(near.parted, 0);
  EXPECT_EQ(far.parted, 0);
}

TEST(Page, ShowsParametersAndTheWorstRecordingFirst) {
  const std::string page = pageOf(fitOf(), {outcome("near", 0.01f), outcome("a <far> one", 2)}, 0.1,
                                  {"in '<far>' they swim"});
  EXPECT_NE(page.find("189.5 to 190.5"), std::string::npos);
  EXPECT_NE(page.find("not determined; to measure it: walk up ramps"), std::string::npos);
  EXPECT_NE(page.find("max&lt;Slope&gt;"), std::string::npos);
  EXPECT_NE(page.find("ticks, with 1 physics step each"), std::string::npos);
  EXPECT_EQ(page.find("<far>"), std::string::npos) << "names are no markup";
  EXPECT_LT(page.find("a &lt;far&gt; one"), page.find("near: "));
  EXPECT_NE(page.find("above the tolerance of 0.1"), std::string::npos);
  EXPECT_LT(page.find("Why the fit is not closer"), page.find("they swim"));
  EXPECT_NE(page.find("half a stud off after 0.00 s"), std::string::npos);
}

// The text must not print a range such as "16 to 16".
TEST(Report, PrintsOneNumberForARangeOfEqualEnds) {
  Fit fit = fitOf();
  const Parameter speed{"walkSpeed", "studs/s", 8, 32, "run straight on"};
  const Parameter landed{"landedTime", "s", 0.002, 0.2, "hold jump", Parameter::Kind::ticks};
  fit.parameters = {{speed, 16, 15.999999, 16.000001, true, 15},
                    {landed, 1 / 60.0, 1 / 60.0, 1 / 60.0, true, 0.05, 1 / 60.0}};
  const std::string text = textOf(fit, {outcome("near", 0.01f)}, 0.1, {});
  EXPECT_NE(text.find("   16 studs/s\n"), std::string::npos) << text;
  EXPECT_NE(text.find("   1 tick\n"), std::string::npos) << text;
  const std::string page = pageOf(fit, {outcome("near", 0.01f)}, 0.1, {});
  EXPECT_EQ(page.find("16 to 16"), std::string::npos);
}

// A time of zero ticks has no logarithm.
TEST(Page, ZeroTicksAreDrawnAtTheEndOfTheBar) {
  Fit fit = fitOf();
  const Parameter landed{"landedTime",          "s", 0.002, 0.2, "hold jump for several jumps",
                         Parameter::Kind::ticks};
  fit.parameters = {{landed, 0, 0, 1 / 60.0, true, 0.05, 1 / 60.0}};
  const std::string page = pageOf(fit, {outcome("near", 0.01f)}, 0.1, {});
  EXPECT_NE(page.find("class=\"is\" x=\"0.0\""), std::string::npos);
  EXPECT_EQ(page.find("inf"), std::string::npos);
  EXPECT_EQ(page.find("nan"), std::string::npos);
}

TEST(Page, SaysThatTheFitWasInterrupted) {
  Fit fit = fitOf();
  EXPECT_EQ(pageOf(fit, {outcome("near", 0.01f)}, 0.1, {}).find("interrupted"), std::string::npos);
  fit.stopped = true;
  EXPECT_NE(pageOf(fit, {outcome("near", 0.01f)}, 0.1, {}).find("interrupted"), std::string::npos);
}

// The page has no script, no external resources, and curves with few points.
TEST(Page, IsOneFileWithoutExternalResources) {
  const std::string page = pageOf(fitOf(), {outcome("near", 0.01f)}, 0.1, {});
  for (const char* reference : {"<script", "src=", "href=", "url(", "@import"})
    EXPECT_EQ(page.find(reference), std::string::npos) << reference;
  EXPECT_LT(page.size(), 60000u);
}

}  // namespace
}  // namespace obby::calibrate
