// Reads binary places. Plain mutation rarely keeps the length of a chunk valid. Therefore an input
// is a list of chunks: a letter for the name, two bytes of length, the content. Inputs that begin
// with '<' are used unchanged.
#include <cstddef>
#include <cstdint>
#include <string>

#include "import/format/read_document.h"
#include "support/place_binary.h"

namespace {

using namespace obby::test;

std::string chunkName(uint8_t letter) {
  constexpr const char* kNames[] = {"INST", "PROP", "PRNT", "SSTR", "META", "SIGN"};
  return kNames[letter % 6];
}

std::string fileFrom(const std::string& input) {
  std::string file = fileHeader(1, 1);
  for (size_t at = 0; at + 3 <= input.size();) {
    const auto byte = [&](size_t i) { return static_cast<uint8_t>(input[at + i]); };
    const size_t length = byte(1) | size_t{byte(2)} << 8;
    const auto packing = static_cast<Packing>((byte(0) >> 4) % 3);
    file += chunk(chunkName(byte(0) & 15), input.substr(at + 3, length), packing);
    at += 3 + length;
  }
  return file + endChunk();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string input(reinterpret_cast<const char*>(data), size);
  const bool whole = input.substr(0, 1) == "<";
  const auto document = obby::importer::readDocument(whole ? input : fileFrom(input), "fuzz");
  if (document && document->instances.size() > (size_t{1} << 24)) __builtin_trap();
  return 0;
}
