// Tests pictures without a display: camera, occlusion, light, trajectories, and files.
#include "view/picture/picture.h"

#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <cmath>

#include "view/course.h"
#include "view/extent.h"
#include "view/picture/drawing.h"
#include "view/picture/pen.h"
#include "view/picture/png.h"
#include "view/picture/shade.h"
#include "view/picture/world.h"

namespace obby::view {
namespace {

Solid block(Vec3 center, Vec3 half) {
  Solid solid;
  solid.pose.position = center;
  solid.shape.half = half;
  return solid;
}

Camera sideways(int width, int height) {
  return framed({{-10, -10, -10}, {10, 10, 10}}, {0, 0, -1}, width, height, true);
}

TEST(Camera, FramesAllPointsAndWastesLittle) {
  const std::vector<Vec3> points = {{0, 0, 0}, {100, 5, 0}, {50, 40, -30}, {20, -8, 10}};
  for (const Vec3 look : {Vec3{0.3f, -0.5f, -1}, Vec3{-1, -0.2f, 0.1f}, Vec3{0, -1, 0}}) {
    for (const bool perspective : {true, false}) {
      const Camera camera = framed(points, look, 640, 360, perspective);
      float left = 640, right = 0, top = 360, bottom = 0;
      for (const Vec3 p : points) {
        const Vec3 at = camera.project(p);
        EXPECT_GT(at.z, 0);
        left = std::min(left, at.x), right = std::max(right, at.x);
        top = std::min(top, at.y), bottom = std::max(bottom, at.y);
      }
      EXPECT_GT(left, 0);
      EXPECT_LT(right, 640);
      EXPECT_GT(top, 0);
      EXPECT_LT(bottom, 360);
      EXPECT_TRUE(right - left > 0.8f * 640 || bottom - top > 0.8f * 360);
    }
  }
}

TEST(Camera, RaysAreTheInverseOfProjections) {
  for (const bool perspective : {true, false}) {
    const Camera camera =
        framed({{-9, 0, 3}, {14, 8, -20}}, {0.4f, -0.3f, -1}, 200, 120, perspective);
    const Vec3 point{3, 4, -7}, at = camera.project(point);
    Vec3 origin, direction;
    camera.ray(at.x, at.y, origin, direction);
    EXPECT_LT(length(origin + direction * at.z - point), 1e-3f);
  }
}

TEST(Depths, TheNearerSolidIsSeen) {
  Depths seen(sideways(60, 60), 60, 60);
  seen.add(block({0, 0, 0}, {8, 8, 1}), 0);
  seen.add(block({0, 0, 5}, {3, 3, 1}), 1);
  EXPECT_EQ(seen.id(30, 30), 1u);
  const Vec3 beside = seen.camera().project({-7, 0, 1});
  EXPECT_EQ(seen.id(int(beside.x), int(beside.y)), 0u);
  EXPECT_EQ(seen.id(1, 1), kNothing);
  EXPECT_NEAR(seen.point(30, 30).z, 6, 1e-3f) << "its front";
  EXPECT_NEAR(seen.normal(30, 30).z, 1, 1e-5f);
}

// In a long course, most parts lie behind a camera that looks at one stage.
TEST(Depths, SolidsBehindTheCameraAreSkipped) {
  Camera camera = sideways(60, 60);
  const Vec3 behind = camera.eye - camera.forward * 20;
  Depths seen(camera, 60, 60);
  EXPECT_TRUE(seen.samplesOf(block(behind, {3, 3, 3})).empty());
  EXPECT_FALSE(seen.samplesOf(block({}, {3, 3, 3})).empty());
  const Samples around = seen.samplesOf(block(camera.eye, {3, 3, 3}));
  EXPECT_EQ(around.x1 - around.x0, 60) << "who stands in it may see it everywhere";
  camera.perspective = false;
  EXPECT_FALSE(Depths(camera, 60, 60).samplesOf(block(behind, {3, 3, 3})).empty());
}

TEST(Depths, ABallIsRoundAndATranslucentSolidHasHoles) {
  Solid ball = block({}, {6, 6, 6});
  ball.kind = geom::ShapeKind::ball;
  Depths seen(sideways(100, 100), 100, 100);
  seen.add(ball, 0);
  const Vec3 corner = seen.camera().project({5.5f, 5.5f, 0});
  EXPECT_EQ(seen.id(int(corner.x), int(corner.y)), kNothing);
  EXPECT_EQ(seen.id(50, 50), 0u);
  Solid veil = block({}, {6, 6, 6});
  veil.coverage = 0.25f;
  Depths half(sideways(100, 100), 100, 100);
  half.add(veil, 0);
  int count = 0;
  for (int y = 40; y < 60; ++y) {
    for (int x = 40; x < 60; ++x) count += half.id(x, y) == 0;
  }
  EXPECT_EQ(count, 100) << "a quarter of 400";
}

TEST(Depths, AWindowEqualsItsPartOfThePicture) {
  const Samples window{20, 31, 57, 48};
  Solid veil = block({2, -3, 5}, {3, 3, 1});
  veil.coverage = 0.5f;
  Depths all(sideways(60, 60), 60, 60), part(sideways(60, 60), 60, 60, window);
  for (Depths* seen : {&all, &part}) seen->add(block({}, {8, 8, 1}), 0), seen->add(veil, 1);
  for (int y = window.y0; y < window.y1; ++y) {
    for (int x = window.x0; x < window.x1; ++x) {
      EXPECT_EQ(part.id(x, y), all.id(x, y));
      EXPECT_EQ(part.depth(x, y), all.depth(x, y));
    }
  }
  EXPECT_TRUE(part.samplesOf(block({-8, 8, 0}, {1, 1, 1})).empty()) << "above it";
}

TEST(Shade, ASolidBelowAnotherIsInItsShadow) {
  const std::vector<Solid> solids = {block({0, 0, 0}, {10, 0.5f, 10}),
                                     block({0, 6, 0}, {3, 0.5f, 3})};
  const std::vector<Surface> surfaces = {{{0.5f, 0.5f, 0.5f}}, {{0.5f, 0.5f, 0.5f}}};
  Depths seen(framed({{-10, 0, -10}, {10, 6, 10}}, {0, -0.4f, -1}, 200, 200, true), 200, 200);
  Depths sun(framed({{-10, 0, -10}, {10, 6, 10}}, -sunward(), 256, 256, false), 256, 256);
  for (uint32_t i = 0; i < 2; ++i) seen.add(solids[i], i), sun.add(solids[i], i);
  const std::vector<Color> colors = shade(seen, sun, surfaces);
  const auto at = [&](Vec3 p) {
    const Vec3 pixel = seen.camera().project(p);
    EXPECT_EQ(seen.id(int(pixel.x), int(pixel.y)), 0u);
    return colors[size_t(int(pixel.y)) * 200 + size_t(int(pixel.x))];
  };
  // The shadow lies along the sun's rays through the upper block.
  const Vec3 below = Vec3{0, 6, 0} - sunward() * (5.5f / sunward().y) + Vec3{0, 0, 1};
  EXPECT_LT(at(below).r, 0.7f * at({8, 0.5f, 8}).r);
}

TEST(Pen, LinesShowFaintlyBehindSolids) {
  Depths seen(sideways(100, 100), 100, 100);
  seen.add(block({0, 0, 5}, {3, 3, 1}), 0);
  std::vector<Color> colors(100 * 100, Color{1, 1, 1});
  Pen pen(seen, colors);
  pen.line({{-9, 0, 0}, {9, 0, 0}}, {{0, 0, 0}, 3, 1, 0.25f});
  const Vec3 open = seen.camera().project({-8, 0, 0}), hidden = seen.camera().project({0, 0, 0});
  EXPECT_NEAR(colors[size_t(open.y) * 100 + size_t(open.x)].r, 0, 1e-5f);
  EXPECT_NEAR(colors[size_t(hidden.y) * 100 + size_t(hidden.x)].r, 0.75f, 1e-5f);
  EXPECT_EQ(colors[0].r, 1);
}

TEST(Png, ReadsBackAsTheSamePixels) {
  Image image{3, 2, {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {1, 2, 3}, {4, 5, 6}, {7, 8, 9}}};
  const auto bytes = pngOf(image);
  ASSERT_TRUE(bytes);
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  ASSERT_TRUE(png_image_begin_read_from_memory(&header, bytes->data(), bytes->size()));
  header.format = PNG_FORMAT_RGB;
  std::vector<Rgb> back(6);
  ASSERT_EQ(header.width, 3u);
  ASSERT_TRUE(png_image_finish_read(&header, nullptr, back.data(), 0, nullptr));
  EXPECT_EQ(back, image.pixels);
}

size_t like(const Image& image, Rgb wanted) {
  size_t count = 0;
  for (const Rgb p : image.pixels)
    count += std::abs(p.r - wanted.r) + std::abs(p.g - wanted.g) + std::abs(p.b - wanted.b) < 60;
  return count;
}

TEST(Picture, ShowsPartsPathsAndIsTheSameEveryTime) {
  const Report shown = view_test::solvedReport();
  ASSERT_EQ(shown.queries.size(), 1u);
  const PictureOptions options{320, 180};
  const Image image = pictureOf(shown.levels[0], &shown.queries[0], options);
  ASSERT_EQ(image.pixels.size(), 320u * 180);
  EXPECT_EQ(image.pixels, pictureOf(shown.levels[0], &shown.queries[0], options).pixels);
  EXPECT_GT(like(image, {221, 65, 73}), 200u) << "the lava";
  const Image bare = pictureOf(shown.levels[0], nullptr, options);
  EXPECT_NE(bare.pixels, image.pixels);
}

TEST(Drawing, HasPartsPathsAndAnEscapedTitle) {
  const Report shown = view_test::solvedReport();
  for (const Side side : {Side::best, Side::above, Side::lateral}) {
    const std::string svg = drawingOf(shown.levels[0], &shown.queries[0], {side, true, 640});
    EXPECT_EQ(svg.find("</script>"), std::string::npos);
    EXPECT_NE(svg.find("&lt;/script&gt;"), std::string::npos);
    EXPECT_NE(svg.find("class=\"part\""), std::string::npos);
    EXPECT_NE(svg.find("class=\"death\""), std::string::npos);
    EXPECT_NE(svg.find("class=\"region avoid\""), std::string::npos);
    EXPECT_NE(svg.find(">1</text>"), std::string::npos) << "the waypoint's number";
    EXPECT_EQ(svg.find("nan"), std::string::npos);
  }
}

TEST(Drawing, HasFailedAttemptsOnRequest) {
  const Report shown = view_test::solvedReport();
  for (const Side side : {Side::best, Side::above}) {
    const std::string plain = drawingOf(shown.levels[0], &shown.queries[0], {side});
    EXPECT_NE(plain.find("class=\"solution\""), std::string::npos);
    EXPECT_EQ(plain.find("class=\"attempt\""), std::string::npos);
    EXPECT_NE(drawingOf(shown.levels[0], &shown.queries[0], {side, true}).find("class=\"attempt\""),
              std::string::npos);
  }
  EXPECT_NE(pictureOf(shown.levels[0], &shown.queries[0], {320, 180, true}).pixels,
            pictureOf(shown.levels[0], &shown.queries[0], {320, 180, false}).pixels);
}

// A button makes a bridge appear, and bars blink in turn.
TEST(World, KnowsWhichPartsAreAwayAtATick) {
  const auto shown = view_test::collect(
      {R"({"type":"level","name":"bridges","parts":[{"button":{"signal":"bridge","seconds":6}},)"
       R"({"position":[0,0,-10],"vanish":{"trigger":"signal","signal":"bridge","inverted":true}},)"
       R"({"position":[0,0,-20],"vanish":{"trigger":"timer","delay":1,"away":1}},)"
       R"({"position":[0,0,-30],"vanish":{"trigger":"timer","delay":1,"away":1,"inverted":true}},)"
       R"({"position":[0,0,-40],"vanish":{"delay":1,"away":1}}]})"});
  ASSERT_TRUE(shown) << shown.error().text();
  const LevelEntry& bridges = shown->levels[0];
  const auto awayAt = [&](uint32_t tick) {
    const World world = worldOf(bridges, tick);
    std::vector<uint32_t> parts;
    for (size_t i = 0; i < world.solids.size(); ++i) {
      EXPECT_EQ(world.solids[i].coverage, world.away[i] ? 0.1f : 1.0f);
      if (world.away[i]) parts.push_back(bridges.level->view().colliders[i].part);
    }
    std::sort(parts.begin(), parts.end());
    return parts;
  };
  EXPECT_EQ(awayAt(0), (std::vector<uint32_t>{1, 3}));
  EXPECT_EQ(awayAt(60), (std::vector<uint32_t>{1, 2}));
}

TEST(Picture, PartsAwayAtTheStartAreFaint) {
  const auto shownOf = [](const char* inverted) {
    return view_test::collect(
        {std::string(R"({"type":"level","name":"tile","parts":[{"size":[20,1,20],)") +
         R"("vanish":{"trigger":"timer","delay":1,"away":1)" + inverted + "}}]}"});
  };
  const auto there = shownOf(""), away = shownOf(R"(,"inverted":true)");
  ASSERT_TRUE(there) << there.error().text();
  ASSERT_TRUE(away) << away.error().text();
  const auto yellow = [](const Report& report) {
    return like(pictureOf(report.levels[0], nullptr, {320, 180}), {230, 200, 90});
  };
  EXPECT_GT(yellow(*there), 1000u);
  EXPECT_LT(yellow(*away), yellow(*there) / 10);
  const auto dashed = [](const Report& report) {
    const std::string svg = drawingOf(report.levels[0], nullptr, {});
    return svg.find("<path class=\"part away\"") != svg.npos &&
           svg.find("fill-opacity:0.10") != svg.npos;
  };
  EXPECT_FALSE(dashed(*there));
  EXPECT_TRUE(dashed(*away));
}

// The picture shows the start on the left, for one goal and for a list of goals.
TEST(Drawing, RunsFromTheStartTowardsGoalsToo) {
  const std::string level =
      R"({"type":"level","name":"back","spawns":[{}],"parts":[{"position":[0,-1,20],"size":[8,2,60]}]})";
  for (const char* goal : {R"("goal":{"position":[0,2,40],"size":[4,4,4]}})",
                           R"("goals":[{"position":[0,2,40],"size":[4,4,4]}]})"}) {
    const auto shown = view_test::collect(
        {level, std::string(R"({"type":"query","id":"way","level":"back",)") + goal});
    ASSERT_TRUE(shown) << shown.error().text();
    const QueryEntry& query = shown->queries[0];
    EXPECT_EQ(alongOf(extentOf(shown->levels[0], query), &query).z, 1) << goal;
  }
}

TEST(Drawing, SaysHowLongALongCourseIs) {
  const auto shown =
      view_test::collect({R"({"type":"level","name":"long","parts":[{"size":[1500,1,4]},)"
                          R"({"position":[1000,0,0],"size":[1500,1,4]}]})"});
  ASSERT_TRUE(shown) << shown.error().text();
  const std::string svg = drawingOf(shown->levels[0], nullptr, {Side::above});
  EXPECT_NE(svg.find(", 2500 studs across"), std::string::npos) << svg.substr(svg.size() - 200);
  EXPECT_EQ(lengthText(0.56666f), "0.567");
  EXPECT_EQ(lengthText(99.96f), "100");
}

TEST(Drawing, OfATowerIsNoHigherThanWide) {
  const auto tower =
      view_test::collect({R"({"type":"level","name":"tower","parts":[{"size":[10,400,10]}]})"});
  ASSERT_TRUE(tower) << tower.error().text();
  for (const Side side : {Side::best, Side::lateral}) {
    const std::string svg = drawingOf(tower->levels[0], nullptr, {side, false, 600});
    EXPECT_NE(svg.find("viewBox=\"0 0 600 630\""), std::string::npos) << svg.substr(0, 120);
  }
}

// A camera on a large floor sees the floor, although all of its corners are outside the drawing.
TEST(Drawing, APartThatFillsThePageIsDrawn) {
  const auto plain = view_test::collect(
      {R"({"type":"level","name":"plain","spawns":[{}],"parts":[{"position":[0,-1,0],"size":[2000,2,2000]}]})",
       R"({"type":"query","id":"near","level":"plain","goal":{"position":[9,2,0],"size":[4,4,4]}})"});
  ASSERT_TRUE(plain) << plain.error().text();
  EXPECT_NE(drawingOf(plain->levels[0], &plain->queries[0], {}).find("class=\"part\""),
            std::string::npos);
}

TEST(Drawing, HasFiniteNumbersForALevelWithoutParts) {
  const auto bare = view_test::collect({R"({"type":"level","name":"bare"})"});
  ASSERT_TRUE(bare) << bare.error().text();
  const std::string svg = drawingOf(bare->levels[0], nullptr, {});
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
}

}  // namespace
}  // namespace obby::view
