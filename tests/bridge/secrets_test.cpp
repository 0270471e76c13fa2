// Codes and tokens.
#include "bridge/secrets.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "io/scratch_folder.h"
#include "loopback/secrets.h"

namespace obby::bridge {
namespace {

using loopback::kTokenBytes;
using loopback::randomHex;

TEST(Pairing, code_is_good_once) {
  Pairing pairing(100);
  EXPECT_EQ(pairing.shown().size(), kCodeLetters + 1);
  EXPECT_TRUE(pairing.answer(pairing.shown(), 101));
  EXPECT_STREQ(pairing.closed(101), "the code has already been used");
  EXPECT_FALSE(pairing.answer(pairing.shown(), 101));
}

TEST(Pairing, code_may_be_typed_carelessly) {
  Pairing pairing(0);
  std::string typed = " " + pairing.shown();
  for (char& c : typed)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  EXPECT_TRUE(pairing.answer(typed, 1));
}

TEST(Pairing, after_a_few_tries_even_the_right_code_is_refused) {
  Pairing pairing(0);
  for (int i = 0; i < Pairing::kTries; i++) EXPECT_FALSE(pairing.answer("0000-0000", 1));
  EXPECT_FALSE(pairing.answer(pairing.shown(), 1));
  EXPECT_STREQ(pairing.closed(1), "too many wrong codes were tried");
}

TEST(Pairing, code_expires) {
  Pairing pairing(1000);
  EXPECT_STREQ(pairing.closed(1000 + Pairing::kSeconds), "");
  EXPECT_FALSE(pairing.answer(pairing.shown(), 1001 + Pairing::kSeconds));
}

TEST(Tokens, survive_in_a_file_that_only_the_user_reads) {
  const test::ScratchFolder folder;
  const std::string path = folder / "tokens";
  auto tokens = Tokens::open(path, 16);
  ASSERT_TRUE(tokens);
  EXPECT_TRUE(tokens->empty());
  const auto first = tokens->add(), second = tokens->add();
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->size(), 2 * kTokenBytes);
  struct stat about {};
  ASSERT_EQ(stat(path.c_str(), &about), 0);
  EXPECT_EQ(about.st_mode & 0777, 0600u);
  const auto again = Tokens::open(path, 16);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->clientOf(*first), 0);
  EXPECT_EQ(again->clientOf(*second), 1);
  EXPECT_EQ(again->clientOf(randomHex(kTokenBytes)), -1);
  EXPECT_EQ(again->clientOf(""), -1);
  EXPECT_EQ(folder.entries(), 1u);  // no temporary file is left
}

TEST(Tokens, the_oldest_is_dropped_and_the_others_keep_their_clients) {
  const test::ScratchFolder folder;
  auto tokens = Tokens::open(folder / "tokens", 2);
  ASSERT_TRUE(tokens);
  const auto a = tokens->add(), b = tokens->add(), c = tokens->add();
  ASSERT_TRUE(a && b && c);
  EXPECT_EQ(tokens->clientOf(*a), -1);
  EXPECT_EQ(tokens->clientOf(*b), 1);
  EXPECT_EQ(tokens->clientOf(*c), 2);
}

TEST(Tokens, two_bridges_with_one_file_lose_no_token) {
  const test::ScratchFolder folder;
  auto one = Tokens::open(folder / "tokens", 16), other = Tokens::open(folder / "tokens", 16);
  ASSERT_TRUE(one && other);
  const auto a = one->add(), b = other->add(), c = one->add();
  ASSERT_TRUE(a && b && c);
  const auto all = Tokens::open(folder / "tokens", 16);
  ASSERT_TRUE(all);
  for (const auto& token : {*a, *b, *c}) EXPECT_GE(all->clientOf(token), 0);
  EXPECT_EQ(one->clientOf(*a), 0);
  EXPECT_NE(one->clientOf(*b), one->clientOf(*c));
}

TEST(Tokens, files_that_others_can_read_or_with_other_content_are_refused) {
  const test::ScratchFolder folder;
  const std::string path = folder / "tokens";
  std::ofstream(path) << "hello\n";
  ASSERT_EQ(chmod(path.c_str(), 0600), 0);
  EXPECT_FALSE(Tokens::open(path, 16));
  std::ofstream(path) << randomHex(kTokenBytes) << "\n";
  EXPECT_TRUE(Tokens::open(path, 16));
  ASSERT_EQ(chmod(path.c_str(), 0640), 0);
  const auto open = Tokens::open(path, 16);
  ASSERT_FALSE(open);
  EXPECT_NE(open.error().text().find("other users can read"), std::string::npos);
}

}  // namespace
}  // namespace obby::bridge
