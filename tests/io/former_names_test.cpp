// Former names of fields and enumerants, which $formerly states.
#include <capnp/message.h>
#include <gtest/gtest.h>

#include "io/json_decode.h"
#include "io/renamed.capnp.h"

namespace obby::io {
namespace {

// Decodes one JSON object into a body. `good` is false on an error.
struct DecodedBody {
  explicit DecodedBody(const std::string& json) {
    const auto tree = JsonTree::parse(json);
    if (!tree) return;
    JsonDecoder decoder(*tree, &misspelt);
    const auto schema = capnp::Schema::from<renamed::Body>();
    good = decoder.fill(planOf(schema), message.initRoot<capnp::DynamicStruct>(schema),
                        tree->root(), Path{});
    error = decoder.error.text();
  }

  renamed::Body::Reader body() { return message.getRoot<renamed::Body>(); }

  capnp::MallocMessageBuilder message;
  std::vector<Error> misspelt;
  std::string error;
  bool good = false;
};

TEST(FormerNames, AFieldIsReadByItsPresentAndItsFormerName) {
  for (const char* json : {R"({"mass":3})", R"({"weight":3})"}) {
    DecodedBody decoded(json);
    ASSERT_TRUE(decoded.good) << json << decoded.error;
    EXPECT_EQ(decoded.body().getMass(), 3) << json;
    EXPECT_TRUE(decoded.misspelt.empty()) << json;
  }
}

TEST(FormerNames, TheyWorkInsideLists) {
  DecodedBody decoded(R"({"children":[{"weight":1},{"mass":2}]})");
  ASSERT_TRUE(decoded.good) << decoded.error;
  ASSERT_EQ(decoded.body().getOthers().size(), 2u);
  EXPECT_EQ(decoded.body().getOthers()[0].getMass(), 1);
  EXPECT_EQ(decoded.body().getOthers()[1].getMass(), 2);
}

TEST(FormerNames, BothNamesOfAFieldAreGivenTwice) {
  EXPECT_EQ(DecodedBody(R"({"mass":3,"weight":3})").error, "weight: the field is given twice");
}

TEST(FormerNames, AnEnumerantIsReadByItsPresentAndItsFormerName) {
  for (const char* json : {R"({"kind":"sliding"})", R"({"kind":"slippery"})"}) {
    DecodedBody decoded(json);
    ASSERT_TRUE(decoded.good) << json << decoded.error;
    EXPECT_EQ(decoded.body().getKind(), renamed::Kind::SLIDING) << json;
  }
}

TEST(FormerNames, ErrorsAndSuggestionsNameThePresentNames) {
  EXPECT_EQ(DecodedBody(R"({"kind":"slipperi"})").error,
            "kind: expected one of plain, sliding, found text \"slipperi\"");
  DecodedBody decoded(R"({"weigt":3})");
  ASSERT_TRUE(decoded.good) << decoded.error;
  EXPECT_TRUE(decoded.misspelt.empty());
}

}  // namespace
}  // namespace obby::io
