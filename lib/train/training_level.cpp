#include "train/training_level.h"

#include <capnp/message.h>
#include <fmt/format.h>

#include <algorithm>

#include "base/hash.h"
#include "level/record_values.h"

namespace obby::train {

namespace {

constexpr uint32_t kMaxPlaces = 4096;  // max places of a route, all of which rewards scan

Result<std::vector<Vec3>> routeOf(schema::Query::Reader query) {
  const auto record = query.getRoute();
  if (record.size() == 1 || record.size() > kMaxPlaces) {
    return level::pathError(
        "route", fmt::format("expected 2 to {} places, found {}", kMaxPlaces, record.size()),
        "leave out 'route' if no route is known");
  }
  std::vector<Vec3> route;
  for (const auto place : record) {
    OBBY_ASSIGN(const Vec3 at, level::position(place, fmt::format("route[{}]", route.size())));
    route.push_back(at);
  }
  return route;
}

Status checkDifficulty(float said) {
  if (said == -1 || (said >= 0 && said <= 1)) return {};
  return level::pathError("difficulty",
                          "expected a number from 0 (trivial) to 1 (jumps at the limit)",
                          "leave out 'difficulty' if it is not known");
}

Guide guideOf(std::vector<Vec3> route, const level::Query& query) {
  const level::QueryView q = query.view();
  std::vector<Vec3> waypoints;
  for (uint32_t i = 0; i < q.waypointCount; ++i)
    waypoints.push_back(q.waypoints[i].target.region.pose.position);
  if (route.size() < 2) {
    route = {query.start().feet};
    route.insert(route.end(), waypoints.begin(), waypoints.end());
    route.push_back(q.goal.region.pose.position);
  }
  return Guide(std::move(route), waypoints);
}

uint64_t hashOf(const level::Level& level, schema::Query::Reader query) {
  const auto words = capnp::canonicalize(query);
  return hashBytes(words.asBytes().begin(), words.asBytes().size(), level.hash());
}

}  // namespace

TrainingLevel::TrainingLevel(level::Level level, level::Query query, std::vector<Vec3> route,
                             uint64_t hash)
    : level_(std::move(level)),
      query_(std::move(query)),
      hash_(hash),
      surroundings_(level_.view(), policy::kSight),
      queryView_(query_.view()),
      around_(surroundings_.view()),
      scene_{level_.view(), queryView_, around_},
      start_(sim::makeWorld(level_.view(), query_.start())),
      startBodies_(sim::startBodies(level_.view())),
      guide_(guideOf(std::move(route), query_)) {}

Result<std::shared_ptr<const TrainingLevel>> TrainingLevel::make(schema::Level::Reader level,
                                                                 schema::Query::Reader query) {
  OBBY_ASSIGN(level::Level compiled, level::Level::compile(level));
  OBBY_ASSIGN(level::Query asked, level::Query::compile(query, compiled));
  OBBY_ASSIGN(std::vector<Vec3> route, routeOf(query));
  OBBY_RETURN_IF_ERROR(checkDifficulty(query.getDifficulty()));
  const uint64_t hash = hashOf(compiled, query);
  return std::shared_ptr<const TrainingLevel>(
      new TrainingLevel(std::move(compiled), std::move(asked), std::move(route), hash));
}

TrainingView TrainingLevel::view(float patience) const {
  return {scene_.level, scene_.query,        scene_.surroundings,        guide_.view(),
          start_,       startBodies_.data(), maxTicksOf(*this, patience)};
}

uint32_t maxTicksOf(const TrainingLevel& level, float patience) {
  const Params& params = level.scene().level.params;
  const float walk = level.guide().studs() / std::max(params.walkSpeed, 1.0f);
  return ticksFromSeconds(params, patience * walk + 10);
}

}  // namespace obby::train
