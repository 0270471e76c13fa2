// Selectors for a place of the level on the command line, by part or by numbers:
//   part:12              index in the level's list of parts
//   #Checkpoint          tag
//   Workspace/S1/Lava    path, or its end after a slash ("S1/Lava"), or the part's name
//   9F3C...              GUID
//   0,5,-20,4,4,4        a box: centre and size in studs
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "level/part_index.h"
#include "math/vec.h"
#include "schema/obby.capnp.h"

namespace obby::level {

// Returns the parts that the selector names, at least one, in the level's order. A name is read in
// the first of these ways that fits any part: GUID, whole path, name, end of the path. It is an
// error if no part fits; the hint lists similar names. For many selectors make the index once.
Result<std::vector<uint32_t>> matchParts(PartIndex& parts, const std::string& selector);
Result<std::vector<uint32_t>> matchParts(schema::Level::Reader level, const std::string& selector);

// Returns the one part that the selector names. Several are an error; the hint lists up to five.
Result<uint32_t> matchPart(PartIndex& parts, const std::string& selector);
Result<uint32_t> matchPart(schema::Level::Reader level, const std::string& selector);

// Returns the shortest selector that names this part and no other: its name, the end of its path,
// the whole path, or else "part:12".
std::string selectorOf(PartIndex& parts, uint32_t part);

// A box in space, before it becomes a Region record.
struct PlainRegion {
  std::string name;
  Vec3 position;  // centre, studs
  Quat rotation;
  Vec3 size;  // full extents, studs
};

// Sets position, rotation and size of a region record.
void fillBox(schema::Region::Builder record, const PlainRegion& box);

// Returns nothing if the text is not six numbers. Numbers that make no box are an error.
Result<std::optional<PlainRegion>> boxFromText(const std::string& text);

// Returns the region of a player who touches or stands on the part. It is the part's box, extended
// by half a stud upward and one stud sideways.
PlainRegion regionAround(schema::Part::Reader part);

// Returns a region for a player who stands on the middle of the part's top.
PlainRegion regionOnTop(schema::Part::Reader part);

}  // namespace obby::level
