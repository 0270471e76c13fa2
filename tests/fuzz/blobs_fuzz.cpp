// The blobs inside properties: attributes, tags, collision data, base64.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "import/format/attributes.h"
#include "import/format/base64.h"
#include "import/format/csg_physics.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace obby::importer;
  const std::string_view blob(reinterpret_cast<const char*>(data), size);
  (void)decodeAttributes(blob);
  (void)decodeCollision(blob);
  if (decodeTags(blob).size() > size) __builtin_trap();
  const auto bytes = decodeBase64(blob);
  if (bytes && bytes->size() > size) __builtin_trap();
  return 0;
}
