// The hulls of CSGPHS 8, which are compressed: a zstd frame with plain hulls and with hulls whose
// triangles are coded by the Edgebreaker method. Only the corners are read: a convex hull needs no
// more.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "math/vec.h"

namespace obby::importer {

// `frame` is the zstd frame, from byte 12 of the blob. Fails on damage, and if the frame holds far
// more than its size lets expect.
Result<std::string> unpackHulls(std::string_view frame);

// Corners of each hull, from what the frame holds. Fails on damage.
Result<std::vector<std::vector<Vec3>>> decodePackedHulls(std::string_view unpacked);

}  // namespace obby::importer
