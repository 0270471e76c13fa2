// Requests that get no answer.
#include <gtest/gtest.h>

#include "engine/place.h"

namespace obby::test {
namespace {

engine::Observation asking(bool enabled, const std::string& text) {
  Place place;
  const InstanceId http = place.add("HttpService", "HttpService", kNoInstance);
  if (enabled) place.set(http, "HttpEnabled", true);
  place.script("local http = game:GetService('HttpService')\n" + text, place.scripts);
  engine::Stage stage(place.document, {});
  stage.start();
  stage.run(10);
  return stage.observation();
}

TEST(Http, RequestsThatAreNotEnabledAreRefusedAsInTheGame) {
  const engine::Observation seen = asking(false, "http:GetAsync('https://example.com')");
  ASSERT_EQ(seen.problems.size(), 1u);
  EXPECT_EQ(seen.problems[0].failure, engine::Failure::refused) << seen.problems[0].text;
}

TEST(Http, EnabledRequestsGetAnEmptyResponse) {
  const engine::Observation seen =
      asking(true,
             "assert(http:GetAsync('https://example.com') == '')\n"
             "assert(not http:RequestAsync({Url = 'https://example.com'}).Success)\nerror('done')");
  ASSERT_EQ(seen.problems.size(), 1u);
  EXPECT_NE(seen.problems[0].text.find("done"), std::string::npos) << seen.problems[0].text;
  EXPECT_EQ(seen.problems[0].failure, engine::Failure::limited);
}

}  // namespace
}  // namespace obby::test
