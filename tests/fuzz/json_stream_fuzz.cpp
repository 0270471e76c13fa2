// Streams of JSON lines.
#include <cstddef>
#include <cstdint>

#include "stream_properties.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  obby::fuzz::checkStream(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
