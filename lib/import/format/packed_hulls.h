// Decodes the hulls of CSGPHS 8. They are in a zstd frame of plain hulls and of hulls whose
// triangles the Edgebreaker method codes. Only the corners are read: a convex hull needs no more.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "math/vec.h"

namespace obby::importer {

// Decompresses `frame`, the zstd frame from byte 12 of the blob. Fails if the frame is damaged, or
// if its content is implausibly large for its size.
Result<std::string> unpackHulls(std::string_view frame);

// Returns the corners of each hull in a decompressed frame. Fails if the frame is damaged.
Result<std::vector<std::vector<Vec3>>> decodePackedHulls(std::string_view unpacked);

}  // namespace obby::importer
