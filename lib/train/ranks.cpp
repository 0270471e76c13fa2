#include "train/ranks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>

namespace obby::train {

namespace {

template <class T>
void addInOrder(Ranks& ranks, std::span<T> values) {
  if (ranks.count() == 1) return;
  std::vector<T> all(values.size() * ranks.count());
  ranks.exchange(values.data(), values.size_bytes(), all.data());
  for (size_t i = 0; i < values.size(); ++i) values[i] = all[i];
  for (size_t at = values.size(); at < all.size(); at += values.size())
    for (size_t i = 0; i < values.size(); ++i) values[i] += all[at + i];
}

}  // namespace

void Ranks::add(std::span<float> values) { addInOrder(*this, values); }
void Ranks::add(std::span<double> values) { addInOrder(*this, values); }

Status Ranks::agree(Status mine) {
  if (count() == 1) return mine;
  const char bad = mine ? 0 : 1;
  std::vector<char> anyBad(count());
  exchange(&bad, 1, anyBad.data());
  const auto found = std::find(anyBad.begin(), anyBad.end(), 1);
  if (found == anyBad.end()) return {};
  const auto which = size_t(found - anyBad.begin());
  std::array<char, 2048> text{};  // truncated, with a final 0
  const std::string said = mine ? std::string() : mine.error().text();
  std::memcpy(text.data(), said.data(), std::min(said.size(), text.size() - 1));
  std::vector<char> all(text.size() * count());
  exchange(text.data(), text.size(), all.data());
  if (which == number()) return mine;
  return Error{fmt::format("rank {}", which), {}, {}, all.data() + which * text.size(), {}};
}

void OneRank::exchange(const void* mine, size_t size, void* all) { std::memcpy(all, mine, size); }

}  // namespace obby::train
