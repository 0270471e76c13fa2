// A relaxation of a query: its kind, what it changes, and how far. Amounts are counted in notches,
// the resolution of the search for the smallest amount.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "io/record.h"
#include "solve/verify/posed_query.h"

namespace obby::solve {

// The number of notches that stands for removing the limit altogether.
constexpr uint32_t kOff = 0xffffffffu;

struct Change {
  schema::RelaxationKind kind = schema::RelaxationKind::JUMPS;
  int32_t part = -1;            // the part that changes; -1: none
  int32_t avoid = -1;           // index in the query's avoid list; -1: none
  std::string field;            // field of the query record; empty: the level is changed
  double notch = 0;             // size of a notch, in the relaxation's unit
  double scale = 1;             // typical amount, in the relaxation's unit, to compare kinds
  std::vector<uint32_t> first;  // notches to try first, in this order, until one works

  // Applies the change to the records. The level is null if `field` is not empty.
  std::function<void(schema::Level::Builder, schema::Query::Builder, uint32_t notches)> apply;
  // Returns the number of notches that suffices for this trajectory, at least 1. Empty if unknown.
  std::function<uint32_t(const Trajectory&)> enough;
  // Describes the change for people, without a full stop.
  std::function<std::string(uint32_t notches)> text;

  double amount(uint32_t notches) const { return notches == kOff ? 0 : notches * notch; }
  // Ranks changes, small ones first. Removing a limit counts as a quarter of the scale.
  double size(uint32_t notches) const { return notches == kOff ? 0.25 : amount(notches) / scale; }
};

// A query, or its level, with one change made to it.
class RelaxedQuery {
 public:
  // Returns nothing if the changed query is invalid, for example if its goal can no longer be
  // touched.
  static std::optional<RelaxedQuery> make(const PosedQuery& base, const Change& change,
                                          uint32_t notches);

  // The result is valid while all that `base` refers to lives, and this object lives and is not
  // moved.
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
