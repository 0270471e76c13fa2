// The page data of a growing report, as pieces of JSON. Each has the revision of its last change,
// so that a page receives only changes. It belongs to one thread.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "io/json_writer.h"
#include "view/budget.h"
#include "view/growing_report.h"
#include "view/page.h"

namespace obby::view {

class LiveData {
 public:
  explicit LiveData(PageOptions options) : options_(std::move(options)) {}

  // Copies the changes. Beyond the page's size limit, trajectories and motion are thinned as in a
  // file, and the affected pieces are sent again.
  void take(const Report& report, StreamState state);

  // Returns the revision, which increases with every change. It is 0 while the data is empty.
  uint64_t revision() const { return revision_; }
  // Returns all changes after `revision` as JSON (docs/page-data.md). An unknown revision belongs
  // to another server process; a page that has one receives everything.
  std::string since(uint64_t revision) const;

 private:
  struct Piece {
    uint64_t revision = 0;
    std::string json;
  };
  struct LevelPiece : Piece {
    PageSizes sizes;
    uint32_t ticks = 0, stride = 0;  // ticks and stride of the level's motion; stride 0: outdated
  };
  struct QueryPieces {
    Piece facts;
    uint64_t changed = 0;                               // last revision of any piece of the query
    std::map<uint64_t, Piece> paths;                    // trajectories by serial
    std::vector<std::pair<uint64_t, uint64_t>> ranges;  // first and last serials, ascending
    uint32_t attemptStride = 1;
  };

  void thin(const Report& report);
  bool put(Piece& piece, std::string json) const;
  void takeLevels(const Report& report);
  void takeQuery(const QueryEntry& entry, QueryPieces& out);
  void writeQuery(io::JsonWriter& json, size_t index, uint64_t revision) const;

  PageOptions options_;
  uint64_t revision_ = 0;
  uint64_t next_ = 1;  // revision of the changes being copied
  Budget budget_;      // thinning never decreases, so that sent pieces stay valid
  Piece head_;
  std::vector<LevelPiece> levels_;
  std::vector<QueryPieces> queries_;
};

}  // namespace obby::view
