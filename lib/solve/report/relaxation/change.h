// One way to make a query easier: which knob, on what, and how far it can be turned. Amounts are
// counted in notches, the resolution to which the least amount is looked for.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "io/record.h"
#include "solve/verify/posed_query.h"

namespace obby::solve {

// As many notches as take away what the knob limits.
constexpr uint32_t kOff = 0xffffffffu;

struct Change {
  schema::Knob knob = schema::Knob::JUMPS;
  int32_t part = -1;            // that it is about
  int32_t avoid = -1;           // of the query's avoid list
  std::string field;            // of the query record; empty: the level is changed
  double notch = 0;             // in the knob's unit
  double scale = 1;             // of the knob's unit, against which the amount is small or large
  std::vector<uint32_t> first;  // notches to try first, in this order; the least that works counts

  // Turns the knob of the records. The level is null where `field` is not empty.
  std::function<void(schema::Level::Builder, schema::Query::Builder, uint32_t notches)> apply;
  // Notches that are enough for this playthrough, at least 1; empty: not known.
  std::function<uint32_t(const Playthrough&)> enough;
  // For people, without a full stop.
  std::function<std::string(uint32_t notches)> text;

  double amount(uint32_t notches) const { return notches == kOff ? 0 : notches * notch; }
  // Small changes first. What takes a limit away altogether is as large as a quarter of the scale.
  double size(uint32_t notches) const { return notches == kOff ? 0.25 : amount(notches) / scale; }
};

// A query, or its level, with one change made to it.
class RelaxedQuery {
 public:
  // Nothing: the change makes no sense there, such as a part to touch that touches no more.
  static std::optional<RelaxedQuery> make(const PosedQuery& base, const Change& change,
                                          uint32_t notches);

  // Valid while this object lives and is not moved, and what `base` was made of lives.
  PosedQuery posed() const;

 private:
  RelaxedQuery(const PosedQuery& base, schema::Query::Reader record);

  PosedQuery base_;
  std::optional<io::RecordBuilder> levelRecord_;  // only if the level is changed
  std::optional<level::Level> level_;
  io::RecordBuilder queryRecord_;
  std::optional<level::Query> query_;
};

}  // namespace obby::solve
