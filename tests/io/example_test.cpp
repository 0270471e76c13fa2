// The examples in error messages are valid input.
#include "io/example.h"

#include <gtest/gtest.h>

#include <set>

#include "io/json_codec.h"
#include "io/json_decode.h"

namespace obby::io {
namespace {

// Collects the plans of an object and of all objects in it.
void collect(const StructPlan& plan, std::set<const StructPlan*>& out) {
  if (!out.insert(&plan).second) return;
  for (const FieldPlan& field : plan.fields) {
    const TypePlan& type = field.type.element.empty() ? field.type : field.type.element[0];
    if (type.record != nullptr) collect(*type.record, out);
  }
}

TEST(Example, EveryObjectsExampleCanBeReadBack) {
  std::set<const StructPlan*> plans;
  collect(recordPlan(), plans);
  size_t objects = 0;
  for (const StructPlan* plan : plans) {
    if (plan->tuple || plan == &recordPlan()) continue;
    const std::string example = exampleOf(*plan);
    SCOPED_TRACE(example);
    const auto tree = JsonTree::parse(example);
    ASSERT_TRUE(tree);
    std::vector<Error> misspelt;
    JsonDecoder decoder(*tree, &misspelt);
    capnp::MallocMessageBuilder message;
    auto target = message.initRoot<capnp::DynamicStruct>(plan->schema);
    EXPECT_TRUE(decoder.fill(*plan, target, tree->root(), Path{})) << decoder.error.text();
    EXPECT_TRUE(misspelt.empty());
    objects++;
  }
  EXPECT_GT(objects, 40u);
}

TEST(Example, HasTheFirstFieldUnlessTheSchemaSaysOtherwise) {
  const StructPlan& part =
      *recordPlan().find("level")->type.record->find("parts")->type.element[0].record;
  const auto of = [&](const char* field) { return exampleOf(*part.find(field)->type.record); };
  EXPECT_EQ(of("kill"), R"({"damage":100})");
  EXPECT_EQ(of("vanish"), R"({"trigger":"touch"})");
  EXPECT_EQ(of("oneWay"), R"({"direction":[0,1,0]})");
  EXPECT_EQ(of("checkpoint"), R"({"stage":1})");
  EXPECT_EQ(of("boost"), R"({"walkSpeed":2})");
  EXPECT_EQ(of("motion"), R"({"keys":[{"time":0}]})");
  EXPECT_EQ(of("seat"), "{}");
}

}  // namespace
}  // namespace obby::io
