// Digests equal the published ones of XXH3, so a hash is the same on every machine.
#include "base/hash.h"

#include <gtest/gtest.h>

#include <cstring>
#include <set>
#include <string>

namespace obby {
namespace {

uint64_t hashText(const std::string& text, uint64_t seed = 0) {
  return hashBytes(text.data(), text.size(), seed);
}

TEST(Hash, EqualsThePublishedDigests) {
  EXPECT_EQ(hashText(""), 0x2d06800538d394c2ull);
  EXPECT_EQ(hashText("a"), 0xe6c632b61e964e1full);
  EXPECT_EQ(hashText("abc"), 0x78af5f94892f3950ull);
}

TEST(Hash, DependsOnEveryByteTheLengthAndTheSeed) {
  const std::string text(300, 'x');
  std::set<uint64_t> seen{hashText(text)};
  for (size_t i = 0; i < text.size(); ++i) {
    std::string other = text;
    other[i] = 'y';
    EXPECT_TRUE(seen.insert(hashText(other)).second) << i;
    EXPECT_TRUE(seen.insert(hashText(text.substr(0, i))).second) << i;
  }
  for (uint64_t seed = 1; seed < 100; ++seed) {
    EXPECT_TRUE(seen.insert(hashText(text, seed)).second) << seed;
  }
}

TEST(Hash, ChainsKeepOrder) {
  EXPECT_NE(hashText("b", hashText("a")), hashText("a", hashText("b")));
}

TEST(Hash, DoesNotDependOnAlignment) {
  alignas(64) char buffer[128 + 8] = {};
  const std::string text(100, 'q');
  for (size_t shift = 0; shift < 8; ++shift) {
    std::memcpy(buffer + shift, text.data(), text.size());
    EXPECT_EQ(hashBytes(buffer + shift, text.size()), hashText(text));
  }
}

}  // namespace
}  // namespace obby
