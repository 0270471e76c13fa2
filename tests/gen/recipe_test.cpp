// Tests recipes from JSON: valid ones, and errors that state the place and the remedy.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "gen/generator.h"
#include "gen/styles.h"

namespace obby::test {
namespace {

Status tried(const std::string& text) {
  OBBY_ASSIGN(const gen::Recipe recipe, gen::Recipe::fromJson(text));
  OBBY_RETURN_IF_ERROR(gen::Generator::make(recipe, false));
  return {};
}

TEST(Recipe, EmptyObjectIsTheDefault) {
  const auto recipe = gen::Recipe::fromJson("{}");
  ASSERT_TRUE(recipe);
  EXPECT_EQ(recipe->difficulty.lo, gen::Recipe().difficulty.lo);
}

TEST(Recipe, ValuesAreRead) {
  const auto r = gen::Recipe::fromJson(R"({"styles": {"gaps": 2, "course": 1.5},
    "difficulty": ["easy", 0.9], "obstacles": 2, "turns": 0.25,
    "course": {"obstacles": [4, 8], "first": 0.2, "styles": {"beam": 1}},
    "limits": {"waypoints": 0.1, "jumps": 0.2, "time": 0.3}, "excess": [6, 9],
    "parameters": {"gaps": {"size": [9, 3.5]}, "spinner": {"speed": 1.5}},
    "physics": {"gravity": 80}})");
  ASSERT_TRUE(r) << r.error().text();
  ASSERT_EQ(r->styles.size(), 2u);
  EXPECT_EQ(r->styles[1].name, "course");
  EXPECT_EQ(r->styles[1].value, 1.5f);
  EXPECT_EQ(r->difficulty.lo, 0.25f);
  EXPECT_EQ(r->difficulty.hi, 0.9f);
  EXPECT_EQ(r->obstacles.hi, 2u);
  EXPECT_EQ(r->courseObstacles.hi, 8u);
  EXPECT_EQ(r->courseFirst, 0.2f);
  EXPECT_EQ(r->courseStyles.size(), 1u);
  EXPECT_EQ(r->turns, 0.25f);
  EXPECT_EQ(r->timeLimits, 0.3f);
  EXPECT_EQ(r->excess.hi, 9);
  EXPECT_EQ(r->physics[0].value, 80);
  ASSERT_EQ(r->parameters.size(), 2u);
  EXPECT_EQ(gen::fullName(*r->parameters[0].parameter), "gaps.size");
  EXPECT_EQ(r->parameters[0].easy, 9);
  EXPECT_EQ(r->parameters[0].hard, 3.5f);
  EXPECT_EQ(gen::fullName(*r->parameters[1].parameter), "spinner.speed");
  EXPECT_EQ(r->parameters[1].easy, 1.5f);
  EXPECT_EQ(r->parameters[1].hard, 1.5f);
}

struct Bad {
  const char* text;
  const char* error;
};

TEST(Recipe, ErrorsStatePathAndRemedy) {
  const Bad cases[] = {
      {"{", "column 2: the text ends in the middle of a value"},
      {"{\n \"turns\": 1,\n}", "line 3 column 1: expected a string in double quotes, found '}'"},
      {"[]", "expected an object, found an array of 0"},
      {R"({"style": 1})", "style: unknown key (did you mean styles?)"},
      {R"({"zzz": 1})",
       "zzz: unknown key (expected one of styles, difficulty, obstacles, course, turns, limits, "
       "excess, "
       "parameters, physics)"},
      {R"({"turns": 1, "turns": 0})", "turns: this key is given twice (keep one of the two)"},
      {R"({"turns": "often"})", "turns: expected a number, found text \"often\""},
      {R"({"turns": 2})", "turns: expected a range between 0 and 1, found 2 to 2"},
      {R"({"styles": {"gapps": 1}})",
       "styles.gapps: there is no style \"gapps\" (did you mean gaps?)"},
      {R"({"styles": {"gaps": 0}})", "styles: all weights are 0 (give a style a weight above 0)"},
      {R"({"styles": {"gaps": -1}})", "styles.gaps: expected a weight from 0 to 1000000, found -1"},
      {R"({"difficulty": "brutal"})",
       "difficulty: expected trivial, easy, medium, hard, limit or a number from 0 to 1, found "
       "\"brutal\""},
      {R"({"difficulty": [0.1, 0.2, 0.3]})",
       "difficulty: expected one value or [min, max], found an array of 3"},
      {R"({"difficulty": ["hard", "easy"]})",
       "difficulty: expected a range between 0 and 1, found 0.75 to 0.25 (give the smaller number "
       "first)"},
      {R"({"difficulty": ["easy", true]})", "difficulty[1]: expected a number, found true"},
      {R"({"obstacles": 0})", "obstacles: expected a range between 1 and 200, found 0 to 0"},
      {R"({"obstacles": 1.5})", "obstacles: expected a whole number up to 1000000, found 1.5"},
      {R"({"course": {"first": 1e999}})", "column 26: the number is too large"},
      {R"({"course": {"styles": {"course": 1}}})",
       "course.styles.course: a course cannot be part of a course (leave out this style)"},
      {R"({"parameters": {"gapps": {}}})",
       "parameters.gapps: there is no style \"gapps\" (did you mean gaps?)"},
      {R"({"parameters": {"gaps": {"sise": 5}}})",
       "parameters.gaps.sise: gaps has no parameter \"sise\" (did you mean size?)"},
      {R"({"parameters": {"gaps": {"colour": 5}}})",
       "parameters.gaps.colour: gaps has no parameter \"colour\" (see obby-gen --list --style "
       "gaps)"},
      {R"({"parameters": {"course": {"size": 5}}})",
       "parameters.course.size: course has no parameter \"size\" (see obby-gen --list --style "
       "course)"},
      {R"({"parameters": {"gaps": {"size": [5, 31]}}})",
       "parameters.gaps.size: expected 2 to 30, found 31"},
      {R"({"parameters": {"gaps": {"size": [5]}}})",
       "parameters.gaps.size: expected one value or [trivial, limit], found an array of 1"},
      {R"({"parameters": {"gaps": {"size": 5, "size": 6}}})",
       "parameters.gaps.size: this key is given twice (keep one of the two)"},
      {R"({"parameters": {"gaps": 5}})", "parameters.gaps: expected an object, found 5"},
      {R"({"physics": {"gravty": 80}})",
       "physics.gravty: unknown physics parameter (did you mean gravity?)"},
      {R"({"physics": {"gravity": -1}})",
       "physics.gravity: expected a number from 0 to 2000, found -1"},
      {R"({"physics": {"controlRate": 70000}})", "physics.controlRate: expected a whole number"},
  };
  for (const Bad& bad : cases) {
    const Status status = tried(bad.text);
    ASSERT_FALSE(status) << bad.text;
    EXPECT_EQ(status.error().text().substr(0, std::string(bad.error).size()), bad.error)
        << bad.text;
  }
}

// Comparing each name with all earlier ones would take minutes.
TEST(Recipe, AMillionNamesTakeLessThanAMinute) {
  std::string text = R"({"physics": {)";
  for (int i = 0; i < 1000000; ++i) text += "\"n" + std::to_string(1000000 + i) + "\":1,";
  const Status status = tried(text + R"("n1000000":1}})");
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().text(),
            "physics.n1000000: this key is given twice (keep one of the two)");
}

// Every JSON block of the page is a working recipe.
TEST(Recipe, ExamplesOfTheDocumentationWork) {
  std::ifstream file(OBBY_SOURCE_DIR "/docs/generator.md");
  std::string line, text;
  int blocks = 0;
  bool inside = false;
  while (std::getline(file, line)) {
    if (line == "```json") {
      inside = true;
      text.clear();
    } else if (inside && line == "```") {
      inside = false;
      ++blocks;
      const Status status = tried(text);
      EXPECT_TRUE(status) << status.error().text() << "\n" << text;
    } else if (inside) {
      text += line + "\n";
    }
  }
  EXPECT_GE(blocks, 2);
}

}  // namespace
}  // namespace obby::test
