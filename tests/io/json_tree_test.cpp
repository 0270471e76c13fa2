#include "io/json_tree.h"

#include <gtest/gtest.h>

#include <string>

namespace obby::io {
namespace {

TEST(JsonTree, ChildrenAreTheElementsInOrder) {
  const auto tree = JsonTree::parse(R"({"a":[1,[2],3],"b":{},"c":"x"})");
  ASSERT_TRUE(tree);
  std::string names;
  for (const JsonTree::Node& member : tree->children(tree->root())) names += tree->name(member);
  EXPECT_EQ(names, "abc");
  std::string elements;
  for (const JsonTree::Node& each : tree->children(*tree->find(tree->root(), "a")))
    elements += tree->describe(each) + ", ";
  EXPECT_EQ(elements, "1, an array of 1, 3, ");
  for (const char* leaf : {"b", "c"})
    for (const JsonTree::Node& none : tree->children(*tree->find(tree->root(), leaf)))
      ADD_FAILURE() << tree->describe(none);
}

TEST(JsonTree, FindsTheFirstMemberOfAName) {
  const auto tree = JsonTree::parse(R"([{"a":1,"b":2,"a":3}])");
  ASSERT_TRUE(tree);
  EXPECT_EQ(tree->find(tree->root(), "a"), nullptr) << "an array";
  const JsonTree::Node& object = *tree->children(tree->root()).begin();
  ASSERT_NE(tree->find(object, "a"), nullptr);
  EXPECT_EQ(tree->find(object, "a")->value, 1u);
  EXPECT_EQ(tree->find(object, "c"), nullptr);
}

}  // namespace
}  // namespace obby::io
