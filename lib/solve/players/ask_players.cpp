#include "solve/players/ask_players.h"

#include <fmt/format.h>

#include <algorithm>

#include "level/bodies.h"
#include "level/player.h"

namespace obby::solve {

namespace {

constexpr const char* kEach = "each";

// Splits lists at commas and drops repeats: "r6,r15" is two words.
std::vector<std::string> words(const std::vector<std::string>& lists) {
  std::vector<std::string> result;
  for (const std::string& list : lists) {
    for (size_t at = 0; at <= list.size();) {
      const size_t end = std::min(list.find(',', at), list.size());
      const std::string word = list.substr(at, end - at);
      if (std::ranges::find(result, word) == result.end()) result.push_back(word);
      at = end + 1;
    }
  }
  return result;
}

bool isRate(const std::string& word) {
  return std::ranges::any_of(level::frameRates(), [&](const level::FrameRate& r) {
    return word == fmt::format("{}", r.framesPerSecond);
  });
}

bool isBody(const std::string& word) {
  return word == level::kPlaceBody || level::findBody(word) != nullptr;
}

Error unknown(const char* option, const char* what, const std::string& word,
              const std::string& known) {
  return Error{{},
               {},
               option,
               fmt::format("unknown {} '{}'", what, word),
               fmt::format("give {}, or each", known)};
}

std::vector<std::string> bodiesOf(schema::Level::Reader level, const AskedPlayers& asked) {
  if (std::ranges::find(asked.bodies, kEach) == asked.bodies.end()) return asked.bodies;
  std::vector<std::string> result;
  for (const auto body : level.getBodies()) result.emplace_back(body.cStr());
  if (result.size() == 1) return {level::kPlaceBody};
  if (result.empty()) {
    for (const level::Body& body : level::bodies()) result.emplace_back(body.name);
  }
  return result;
}

std::vector<uint16_t> ratesOf(const AskedPlayers& asked) {
  const bool each = std::ranges::find(asked.frameRates, kEach) != asked.frameRates.end();
  std::vector<uint16_t> result;
  for (const level::FrameRate& rate : level::frameRates()) {
    const std::string word = fmt::format("{}", rate.framesPerSecond);
    const bool named = std::ranges::find(asked.frameRates, word) != asked.frameRates.end();
    if (each || named) result.push_back(rate.framesPerSecond);
  }
  return result;
}

}  // namespace

Result<AskedPlayers> askedPlayers(const std::vector<std::string>& bodies,
                                  const std::vector<std::string>& frameRates, bool sameKeys) {
  AskedPlayers asked{words(bodies), words(frameRates), sameKeys};
  for (const std::string& word : asked.bodies) {
    if (word == kEach || isBody(word)) continue;
    return unknown("--body", "body", word,
                   fmt::format("{}, {}", level::bodyNames(), level::kPlaceBody));
  }
  for (const std::string& word : asked.frameRates) {
    if (word == kEach || isRate(word)) continue;
    return unknown("--frame-rate", "frame rate", word, level::frameRateNames());
  }
  return asked;
}

io::Record withPlayers(schema::Level::Reader level, const AskedPlayers& asked,
                       const io::Record& query) {
  if (asked.empty()) return query;
  io::RecordBuilder copy(query.reader());
  auto to = copy.root().getQuery();
  if (!asked.bodies.empty()) {
    const std::vector<std::string> names = bodiesOf(level, asked);
    auto list = to.initBodies(uint32_t(names.size()));
    for (uint32_t i = 0; i < list.size(); ++i) list.set(i, names[i]);
  }
  if (!asked.frameRates.empty()) {
    const std::vector<uint16_t> rates = ratesOf(asked);
    auto list = to.initFrameRates(uint32_t(rates.size()));
    for (uint32_t i = 0; i < list.size(); ++i) list.set(i, rates[i]);
  }
  if (asked.sameKeys) to.setSameKeys(true);
  return io::Record(std::move(copy));
}

}  // namespace obby::solve
