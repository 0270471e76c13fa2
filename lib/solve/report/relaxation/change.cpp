#include "solve/report/relaxation/change.h"

namespace obby::solve {

RelaxedQuery::RelaxedQuery(const PosedQuery& base, schema::Query::Reader record) : base_(base) {
  queryRecord_.root().setQuery(record);
}

std::optional<RelaxedQuery> RelaxedQuery::make(const PosedQuery& base, const Change& change,
                                               uint32_t notches) {
  RelaxedQuery r(base, base.queryRecord);
  schema::Level::Builder level = nullptr;
  if (change.field.empty()) {
    r.levelRecord_.emplace();
    r.levelRecord_->root().setLevel(base.levelRecord);
    level = r.levelRecord_->root().getLevel();
  }
  change.apply(level, r.queryRecord_.root().getQuery(), notches);
  if (r.levelRecord_) {
    auto compiled = level::Level::compile(r.levelRecord_->reader().getLevel());
    if (!compiled) return std::nullopt;
    r.level_ = *std::move(compiled);
  }
  auto query =
      level::Query::compile(r.queryRecord_.reader().getQuery(), r.level_ ? *r.level_ : base.level);
  if (!query) return std::nullopt;
  r.query_ = *std::move(query);
  return r;
}

PosedQuery RelaxedQuery::posed() const {
  return {level_ ? *level_ : base_.level,
          levelRecord_ ? levelRecord_->reader().getLevel() : base_.levelRecord, *query_,
          queryRecord_.reader().getQuery(), base_.policy};
}

}  // namespace obby::solve
