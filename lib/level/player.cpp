#include "level/player.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/listed.h"
#include "level/bodies.h"

namespace obby::level {

namespace {

constexpr FrameRate kFrameRates[] = {{30, 8}, {60, 4}, {120, 2}, {144, 2}, {240, 1}};

const FrameRate* findRate(uint32_t framesPerSecond) {
  const auto row = std::ranges::find_if(
      kFrameRates, [&](const FrameRate& r) { return r.framesPerSecond == framesPerSecond; });
  return row == std::end(kFrameRates) ? nullptr : row;
}

Status check(const Player& player, const std::string& body, const std::string& rate) {
  if (!player.body.empty() && findBody(player.body) == nullptr) {
    return Error{
        {},
        {},
        body,
        fmt::format("unknown body '{}'", player.body),
        fmt::format("give {}, or {} for the body that the level sets", bodyNames(), kPlaceBody)};
  }
  if (player.frameRate == 0 || findRate(player.frameRate) != nullptr) return {};
  return Error{
      {}, {}, rate, fmt::format("expected {}, found {}", frameRateNames(), player.frameRate), {}};
}

}  // namespace

std::span<const FrameRate> frameRates() { return kFrameRates; }

std::string frameRateNames() {
  std::vector<std::string> names;
  for (const FrameRate& rate : kFrameRates) {
    names.push_back(fmt::format("{}", rate.framesPerSecond));
  }
  return listed(names, "or");
}

bool namesPlayers(schema::Query::Reader query) {
  return query.getBodies().size() > 0 || query.getFrameRates().size() > 0;
}

Result<std::vector<Player>> playersOf(schema::Query::Reader query) {
  std::vector<std::string> names;
  for (const auto body : query.getBodies()) {
    names.push_back(body == kPlaceBody ? std::string() : std::string(body.cStr()));
    const std::string path = fmt::format("bodies[{}]", names.size() - 1);
    OBBY_RETURN_IF_ERROR(check({names.back(), 0}, path, {}));
  }
  if (names.empty()) names.emplace_back();
  std::vector<uint16_t> rates;
  for (const uint16_t rate : query.getFrameRates()) {
    const std::string path = fmt::format("frameRates[{}]", rates.size());
    if (findRate(rate) == nullptr)
      return Error{{}, {}, path, fmt::format("expected {}, found {}", frameRateNames(), rate), {}};
    rates.push_back(rate);
  }
  if (rates.empty()) rates.push_back(0);
  std::vector<Player> players;
  for (const std::string& name : names) {
    for (const uint16_t rate : rates) {
      const Player player{name, rate};
      if (std::ranges::find(players, player) == players.end()) players.push_back(player);
    }
  }
  return players;
}

Result<Player> playerOf(schema::Trajectory::Reader trajectory) {
  const Player player{trajectory.getBody().cStr(), trajectory.getFrameRate()};
  OBBY_RETURN_IF_ERROR(check(player, "body", "frameRate"));
  return player;
}

Status setPlayer(const Player& player, schema::Level::Builder level) {
  OBBY_RETURN_IF_ERROR(check(player, "body", "frameRate"));
  if (player.isLevels()) return {};
  auto physics = level.getPhysics();
  if (!player.body.empty()) setBody(*findBody(player.body), physics);
  if (player.frameRate != 0) {
    physics.setControlRate(player.frameRate);
    physics.setSubsteps(findRate(player.frameRate)->substeps);
  }
  return {};
}

void setRate(uint16_t from, uint16_t to, schema::Query::Builder query) {
  query.disownBodies();
  query.disownFrameRates();
  query.setSameKeys(false);
  if (from == to || !query.hasStart()) return;
  auto start = query.getStart();
  start.setTick(tickAtRate(start.getTick(), from, to));
}

uint32_t tickAtRate(uint32_t tick, uint32_t from, uint32_t to) {
  return uint32_t((uint64_t(tick) * to + from / 2) / from);
}

uint32_t nextTickAtRate(uint32_t tick, uint32_t from, uint32_t to) {
  return uint32_t((uint64_t(tick) * to + from - 1) / from);
}

}  // namespace obby::level
