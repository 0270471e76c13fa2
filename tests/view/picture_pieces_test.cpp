// A picture is drawn in pieces, so memory does not grow with its size. Long trajectories do not
// need extra memory either.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "view/course.h"
#include "view/extent.h"
#include "view/picture/picture.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define OBBY_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define OBBY_SANITIZED
#endif
#endif

namespace obby::view {
namespace {

// Returns this process's peak memory, in KiB.
long peak() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return used.ru_maxrss;
}

TEST(Picture, IsTheSameInAnyNumberOfPieces) {
  const Report shown = view_test::solvedReport();
  const auto drawn = [&](size_t atOnce) {
    return pictureOf(shown.levels[0], &shown.queries[0], {160, 90, true, atOnce}).pixels;
  };
  const std::vector<Rgb> whole = drawn(size_t(1) << 22);
  ASSERT_EQ(whole.size(), 160u * 90);
  for (const size_t atOnce : {size_t(1), size_t(320 * 2 * 7), size_t(320 * 2 * 89)})
    EXPECT_TRUE(drawn(atOnce) == whole) << atOnce;
}

TEST(Picture, ALargeOneTakesLittleMemory) {
#ifdef OBBY_SANITIZED
  GTEST_SKIP() << "sanitizers keep freed memory and add more";
#endif
  const Report shown = view_test::solvedReport();
  const auto peakOf = [&](int width, int height) {
    EXPECT_EQ(pictureOf(shown.levels[0], &shown.queries[0], {width, height}).width, width);
    return peak();
  };
  const long before = peakOf(32, 32);
  EXPECT_LT(peakOf(4096, 1024) - before, 350 << 10) << "all of its samples would take 600 MB";
}

TEST(Extent, TakesNoExtraMemoryForALongTrajectory) {
  Report shown = view_test::solvedReport();
  QueryEntry& query = shown.queries[0];
  query.paths[0].playback.feet.assign(4'000'000, Vec3{0, 0, -5});
  query.paths[0].playback.feet.back() = {0, 0, -500};
  const long before = peak();
  EXPECT_EQ(extentOf(shown.levels[0], query).lo.z, -506);
  EXPECT_LT(peak() - before, 20 << 10) << "a box for each of them would take 96 MB";
}

}  // namespace
}  // namespace obby::view
