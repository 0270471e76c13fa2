// Reads the blobs inside properties: attributes, tags, collision data, terrain and base64. Also
// reads JSON with comments.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "import/format/attributes.h"
#include "import/format/csg_physics.h"
#include "import/format/packed_hulls.h"
#include "import/format/smooth_grid.h"
#include "import/parts/terrain_blocks.h"
#include "import/rojo/json_file.h"
#include "io/base64.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace obby::importer;
  const std::string_view blob(reinterpret_cast<const char*>(data), size);
  (void)decodeAttributes(blob);
  (void)decodeCollision(blob);
  // Few inputs are valid zstd frames, so the input is also read directly as the frame's content.
  if (const auto hulls = decodePackedHulls(blob)) {
    size_t corners = 0;
    for (const auto& hull : *hulls) corners += hull.size();
    if (corners > size) __builtin_trap();
  }
  if (const auto chunks = voxelChunks(blob)) {
    TerrainShape shape;
    for (const VoxelChunk& chunk : *chunks) addColumns({chunk}, 1000, shape);
    joinBlocks(shape.blocks);
  }
  if (const auto json = rojo::parseJson(blob)) (void)rojo::luauOf(rojo::Json(*json, json->root()));
  if (decodeTags(blob).size() > size) __builtin_trap();
  const auto bytes = obby::io::decodeBase64(blob);
  if (bytes && bytes->size() > size) __builtin_trap();
  return 0;
}
