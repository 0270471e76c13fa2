// What pages of a growing report are told: pieces of JSON, each with the revision in which it last
// changed, so that a page gets what is new to it and nothing twice. Belongs to one thread.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "view/budget.h"
#include "view/growing_report.h"
#include "view/json_text.h"
#include "view/page.h"

namespace obby::view {

class LiveData {
 public:
  explicit LiveData(PageOptions options) : options_(std::move(options)) {}

  // Takes what has changed. Beyond the page's size ways and motion are thinned out as in a file,
  // and what was sent before is sent anew, thinner.
  void take(const Report& report, StreamState state);

  // Rises with every change; 0: nothing is there.
  uint64_t revision() const { return revision_; }
  // Returns all changes since that revision as JSON (docs/page-data.md). An unknown revision belongs
  // to a page of an earlier run, and gets everything.
  std::string since(uint64_t revision) const;

 private:
  struct Piece {
    uint64_t revision = 0;
    std::string json;
  };
  struct LevelPiece : Piece {
    PageSizes sizes;
    uint32_t ticks = 0, stride = 0;  // of the motion in it; stride 0: it has other ticks
  };
  struct QueryPieces {
    Piece facts;
    uint64_t changed = 0;                               // last revision of anything in it
    std::map<uint64_t, Piece> paths;                    // by serial
    std::vector<std::pair<uint64_t, uint64_t>> ranges;  // first and last serials, ascending
    uint32_t attemptStride = 1;
  };

  void thin(const Report& report);
  bool put(Piece& piece, std::string json) const;
  void takeLevels(const Report& report);
  void takeQuery(const QueryEntry& entry, QueryPieces& out);
  void writeQuery(JsonText& json, size_t index, uint64_t revision) const;

  PageOptions options_;
  uint64_t revision_ = 0;
  uint64_t next_ = 1;  // that what is taken now will have
  Budget budget_;      // never less thinning than before: what is sent stays sent
  Piece head_;
  std::vector<LevelPiece> levels_;
  std::vector<QueryPieces> queries_;
};

}  // namespace obby::view
