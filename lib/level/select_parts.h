// Naming a place of the level on the command line: by part or by numbers.
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

// Parts that the selector names, in the level's order: at least one. Of the ways to read a name,
// the first that fits any part counts: GUID, whole path, name, end of the path. Error: no part
// fits; parts with a similar name are the hint. For many selectors make the index once.
Result<std::vector<uint32_t>> matchParts(PartIndex& parts, const std::string& selector);
Result<std::vector<uint32_t>> matchParts(schema::Level::Reader level, const std::string& selector);

// The one part that the selector names. Error: several; up to five of them are the hint.
Result<uint32_t> matchPart(PartIndex& parts, const std::string& selector);
Result<uint32_t> matchPart(schema::Level::Reader level, const std::string& selector);

// The shortest selector that names this part and no other: its name, the end of its path or the
// whole path; where those fit other parts, too, "part:12".
std::string selectorOf(PartIndex& parts, uint32_t part);

// A box in space, before it becomes a Region record.
struct PlainRegion {
  std::string name;
  Vec3 position;  // of its centre, studs
  Quat rotation;
  Vec3 size;  // full extents, studs
};

// Position, rotation and size of a region record.
void fillBox(schema::Region::Builder record, const PlainRegion& box);

// Nothing if the text is not six numbers. Error: numbers that are no box.
Result<std::optional<PlainRegion>> boxFromText(const std::string& text);

// Where a player who touches or stands on the part is: its box, half a stud up and one stud
// sideways more.
PlainRegion regionAround(schema::Part::Reader part);

// Standing room on the middle of the part's top.
PlainRegion regionOnTop(schema::Part::Reader part);

}  // namespace obby::level
