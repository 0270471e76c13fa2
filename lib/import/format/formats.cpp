// The table of formats.
#include "import/format/formats.h"

#include "import/format/binary_format.h"
#include "import/format/xml_format.h"

namespace obby::importer {

std::span<const Format> formats() {
  static constexpr Format kFormats[] = {
      {"binary place or model (.rbxl, .rbxm)", looksLikeBinary, readBinary},
      {"XML place or model (.rbxlx, .rbxmx)", looksLikeXml, readXml},
  };
  return kFormats;
}

}  // namespace obby::importer
