// Policy files are read as written, and damaged ones are refused.
#include "policy/policy_file.h"

#include <capnp/message.h>
#include <capnp/serialize.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

#include "schema/policy.capnp.h"

namespace obby::policy {
namespace {

PolicyFile sample() {
  PolicyFile file;
  Random random(1, 1);
  for (float& v : file.network.numbers()) v = random.unit() - 0.5f;
  file.training = {"obby-train -o x.obp", "0.1.0", 7, 123456789012ull, 61.5, 0.7f, 0.55f, "y"};
  file.values = {3.5f, 2.25f};
  return file;
}

TEST(PolicyFileTest, IsReadAsWritten) {
  const PolicyFile file = sample();
  const std::string bytes = writePolicy(file);
  const auto read = readPolicy(bytes, "x.obp");
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->network.numbers(), file.network.numbers());
  EXPECT_EQ(read->training.command, file.training.command);
  EXPECT_EQ(read->training.decisions, file.training.decisions);
  EXPECT_EQ(read->training.hardest, file.training.hardest);
  EXPECT_EQ(read->training.start, "y");
  EXPECT_EQ(read->values.mean, 3.5f);
  EXPECT_EQ(read->values.deviation, 2.25f);
  EXPECT_EQ(writePolicy(*read), bytes);
  EXPECT_LT(bytes.size(), 2u << 20);
}

TEST(PolicyFileTest, RefusesEveryTruncationAndOtherFiles) {
  const std::string bytes = writePolicy(sample());
  for (size_t size = 0; size < bytes.size(); size += 997) {
    const auto read = readPolicy(std::string_view(bytes).substr(0, size), "x.obp");
    ASSERT_FALSE(read) << size;
    EXPECT_NE(read.error().text().find("x.obp"), std::string::npos);
  }
  EXPECT_FALSE(readPolicy("{\"type\":\"header\"}       ", "x"));
  EXPECT_FALSE(readPolicy(std::string(4096, '\0'), "x"));
  EXPECT_FALSE(readPolicy(std::string(4096, '\xff'), "x"));
}

TEST(PolicyFileTest, RefusesDamage) {
  const std::string bytes = writePolicy(sample());
  int refused = 0, tried = 0;
  for (size_t at = 8; at < bytes.size(); at += 1009, ++tried) {
    std::string damaged = bytes;
    damaged[at] = char(damaged[at] ^ 0x10);
    refused += !readPolicy(damaged, "x");
  }
  EXPECT_GT(refused, tried * 9 / 10) << "all except texts and padding, which are not hashed";
}

// Returns the file after a change.
std::string changed(const std::function<void(schema::PolicyFile::Builder)>& change) {
  const std::string bytes = writePolicy(sample());
  auto words = kj::heapArray<capnp::word>(bytes.size() / sizeof(capnp::word));
  std::memcpy(words.asBytes().begin(), bytes.data(), bytes.size());
  capnp::FlatArrayMessageReader reader(words);
  capnp::MallocMessageBuilder message(1 << 16);
  message.setRoot(reader.getRoot<schema::PolicyFile>());
  change(message.getRoot<schema::PolicyFile>());
  const auto out = capnp::messageToFlatArray(message);
  return {reinterpret_cast<const char*>(out.begin()), out.asBytes().size()};
}

std::string refusal(const std::string& bytes) {
  const auto read = readPolicy(bytes, "x.obp");
  return read ? "" : read.error().text();
}

TEST(PolicyFileTest, RefusesOtherVersionsByName) {
  EXPECT_EQ(refusal(changed([](auto) {})), "");
  const auto expect = [](const std::string& said, const char* what) {
    EXPECT_NE(said.find(what), std::string::npos) << said;
    EXPECT_NE(said.find("train a new one with this version's obby-train"), std::string::npos)
        << said;
  };
  expect(refusal(changed([](auto f) { f.setVersion(7); })), "its layout version is 7, expected 1");
  expect(refusal(changed([](auto f) { f.setObservationVersion(99); })),
         "trained on observations of version 99, expected version ");
  expect(refusal(changed([](auto f) { f.setMoves(18); })), "it has 18 moves, expected 34");
  expect(refusal(changed([](auto f) { f.getLayers()[1].setOutputs(128); })), "layers[1]");
  expect(refusal(changed([](auto f) { f.getLayers()[0].initWeights(3); })), "weights of layers[0]");
  EXPECT_EQ(
      refusal(changed([](auto f) { f.setHash(f.getHash() ^ 1); })),
      "x.obp: the policy file is damaged: its hash does not match (restore a copy, or train a "
      "new policy)");
  expect(refusal(changed([](auto f) { f.getTraining().setSolved(NAN); })),
         "about its training are finite");
  expect(refusal(changed([](auto f) { f.setValueMean(INFINITY); })),
         "'valueMean' or 'valueDeviation' is not");
  expect(refusal(changed([](auto f) { f.setValueDeviation(NAN); })),
         "'valueMean' or 'valueDeviation' is not");
  expect(refusal(changed([](auto f) { f.setValueDeviation(-1); })),
         "'valueMean' or 'valueDeviation' is not");
}

TEST(PolicyFileTest, RefusesTextAfterTheMessage) {
  const std::string said = refusal(writePolicy(sample()) + std::string(8, '\0'));
  EXPECT_NE(said.find("it has extra bytes at its end"), std::string::npos) << said;
}

TEST(PolicyFileTest, RefusesNumbersThatAreNotFinite) {
  PolicyFile file = sample();
  file.network.numbers()[1000] = std::numeric_limits<float>::quiet_NaN();
  const auto read = readPolicy(writePolicy(file), "x");
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().text().find("are finite"), std::string::npos);
}

}  // namespace
}  // namespace obby::policy
