// Writes the binary format, whole or chunk by chunk (for deliberately broken files).
#pragma once

#include <string>
#include <vector>

#include "support/place_columns.h"
#include "support/place_writer.h"

namespace obby::test {

std::string fileHeader(uint32_t classes, uint32_t instances);
std::string chunk(const std::string& name, const std::string& data, Packing packing);
std::string instanceChunk(uint32_t classId, const std::string& className,
                          const std::vector<int32_t>& referents, Packing packing = Packing::Stored);
// Returns a chunk of a property. `column` holds the values as the kind stores them.
std::string propertyChunk(uint32_t classId, const std::string& name, uint8_t kind,
                          const std::string& column, Packing packing = Packing::Stored);
std::string parentChunk(const std::vector<int32_t>& children, const std::vector<int32_t>& parents,
                        Packing packing = Packing::Stored);
std::string endChunk();

// Returns a binary place file. The referent of the instance with index i is i.
std::string binaryPlace(const std::vector<PlaceWriter::Entry>& entries, Packing packing);

}  // namespace obby::test
