#include "base/chunked_vector.h"

#include <gtest/gtest.h>

namespace obby {
namespace {

constexpr size_t kChunk = ChunkedVector<int>::kChunk;

ChunkedVector<int> counting(size_t size) {
  ChunkedVector<int> v;
  for (size_t i = 0; i < size; ++i) v.push_back(int(i));
  return v;
}

TEST(ChunkedVector, KeepsAppendedElementsAcrossChunks) {
  const size_t size = 3 * kChunk + 7;
  const ChunkedVector<int> v = counting(size);
  ASSERT_EQ(v.size(), size);
  for (size_t i = 0; i < size; ++i) ASSERT_EQ(v[i], int(i));
}

TEST(ChunkedVector, ChunksAreAllElementsInOrder) {
  const ChunkedVector<int> v = counting(2 * kChunk + 5);
  ASSERT_EQ(v.chunkCount(), 3u);
  EXPECT_EQ(v.chunk(0).size(), kChunk);
  EXPECT_EQ(v.chunk(2).size(), 5u);
  int next = 0;
  for (size_t c = 0; c < v.chunkCount(); ++c) {
    for (const int i : v.chunk(c)) ASSERT_EQ(i, next++);
  }
  EXPECT_EQ(next, int(v.size()));
  EXPECT_EQ(v.at(kChunk - 1) + 1, v.chunk(0).data() + kChunk);
  EXPECT_EQ(counting(0).chunkCount(), 0u);
  EXPECT_EQ(counting(kChunk).chunkCount(), 1u);
}

TEST(ChunkedVector, ElementsBeyondTheFirstChunkDoNotMove) {
  ChunkedVector<int> v = counting(kChunk + 1);
  const int* const first = v.at(0);
  const int* const last = v.at(kChunk);
  for (size_t i = 0; i < 5 * kChunk; ++i) v.push_back(0);
  EXPECT_EQ(v.at(0), first);
  EXPECT_EQ(v.at(kChunk), last);
}

TEST(ChunkedVector, ResizeAppendsCopies) {
  ChunkedVector<int> v = counting(3);
  v.resize(kChunk + 2, 9);
  ASSERT_EQ(v.size(), kChunk + 2);
  EXPECT_EQ(v[2], 2);
  for (size_t i = 3; i < v.size(); ++i) ASSERT_EQ(v[i], 9);
  v.resize(v.size());
  EXPECT_EQ(v.size(), kChunk + 2);
}

TEST(ChunkedVector, AppendsItsOwnElements) {
  ChunkedVector<int> v = counting(1);
  v[0] = 5;
  while (v.size() < 3000) v.push_back(v[0]);
  for (size_t i = 0; i < v.size(); ++i) ASSERT_EQ(v[i], 5);
}

TEST(ChunkedVector, EqualsBySizeAndElements) {
  EXPECT_TRUE(counting(kChunk + 3) == counting(kChunk + 3));
  EXPECT_FALSE(counting(kChunk + 3) == counting(kChunk + 2));
  ChunkedVector<int> other = counting(kChunk + 3);
  other[kChunk] = -1;
  EXPECT_FALSE(other == counting(kChunk + 3));
}

TEST(ChunkedVector, HoldsElementsOfACacheLine) {
  struct alignas(64) Line {
    int value;
  };
  ChunkedVector<Line> v;
  for (int i = 0; i < 1000; ++i) v.push_back({i});
  for (int i = 0; i < 1000; ++i) {
    ASSERT_EQ(v[size_t(i)].value, i);
    ASSERT_EQ(reinterpret_cast<uintptr_t>(v.at(size_t(i))) % 64, 0u);
  }
}

}  // namespace
}  // namespace obby
