// Reads XML places. The input is read as a whole place, and as the properties of a part.
#include <cstddef>
#include <cstdint>
#include <string>

#include "import/format/xml_filter.h"
#include "import/format/xml_format.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace obby::importer;
  const std::string input(reinterpret_cast<const char*>(data), size);
  const std::string framed = "<roblox version=\"4\"><Item class=\"Part\"><Properties>" + input +
                             "</Properties></Item></roblox>";
  (void)readXml(input, "fuzz");
  (void)readXml(framed, "fuzz");
  // Filtering is idempotent.
  const FilteredXml once = filterXml(input);
  if (filterXml(once.text).text != once.text) __builtin_trap();
  if (sourceOffset(input, once.text.size()) != input.size()) __builtin_trap();
  return 0;
}
