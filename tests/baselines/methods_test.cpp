// Methods that learn pass the tests of every method. On the harder queries they take minutes, so
// search_test.cpp tests them on smaller ones.
#include "baselines/methods.h"

#include "solve/method_suite.h"

namespace obby::solve {
namespace {

INSTANTIATE_TEST_SUITE_P(Baselines, MethodTest, testing::ValuesIn(baselines::methods()), nameOf);

TEST(BaselineMethods, FollowThoseOfTheProduct) {
  const auto all = baselines::allMethods();
  ASSERT_EQ(all.size(), methods().size() + baselines::methods().size());
  EXPECT_STREQ(all.front()->name, methods().front().name);
  for (const Method* m : all) EXPECT_EQ(baselines::findMethod(m->name), m) << m->name;
  EXPECT_EQ(baselines::findMethod("none"), nullptr);
}

}  // namespace
}  // namespace obby::solve
