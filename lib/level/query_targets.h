// Compiles the targets of a query: boxes, and parts to touch or to stand on.
#pragma once

#include <string>
#include <vector>

#include "level/collider_runs.h"
#include "level/query_view.h"
#include "level/record_values.h"

namespace obby::level {

// Returns an error at `path` if the region names a part whose box is not filled in. Names are not
// looked up here.
Status checkLookedUp(schema::Region::Reader record, const std::string& path);

// Compiles targets, and looks up parts to touch among the level's colliders.
class QueryTargets {
 public:
  // `parts` is the number of the level's parts. `touched` receives the colliders of parts to touch.
  // All arguments must outlive this object.
  QueryTargets(const LevelView& level, size_t parts, std::vector<uint32_t>& touched)
      : level_(level), parts_(parts), runs_(level), touched_(touched) {}

  // If `arrive` is STAND, the player must stand on a solid part. Otherwise the player must enter
  // the part's box. Errors are at `path`.
  Result<TargetView> compile(schema::Region::Reader record, const std::string& path,
                             schema::Arrive arrive);
  Result<std::vector<TargetView>> compile(capnp::List<schema::Region>::Reader list,
                                          const char* name, schema::Arrive arrive);

 private:
  Result<TargetView> boxOrPart(schema::Region::Reader record, const std::string& path);
  bool isSolid(uint32_t part);
  void leaveFoot(uint32_t part, geom::Region& region);
  void listTouched(uint32_t part, TargetView& target);

  const LevelView& level_;
  size_t parts_;
  ColliderRuns runs_;
  std::vector<uint32_t> listed_;  // (parts), index into touched_, or kNone; may be empty
  std::vector<uint32_t>& touched_;
};

}  // namespace obby::level
