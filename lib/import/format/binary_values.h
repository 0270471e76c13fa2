// Reads the property columns of the binary format: one value for each instance of a class, stored
// kind by kind.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "engine/document.h"
#include "import/format/byte_reader.h"

namespace obby::importer {

// The tables that columns refer to.
struct ColumnContext {
  std::vector<std::shared_ptr<const std::string>> sharedStrings;
  std::unordered_map<int32_t, InstanceId> instances;  // instances by referent

  Ref resolve(int32_t referent) const;
};

// Returns true if readColumn knows the kind.
bool isKnownKind(uint8_t kind);

// Reads `count` values of `kind` into `out`. Returns the error, or "". The size of the input bounds
// the memory.
std::string readColumn(uint8_t kind, size_t count, ByteReader& reader, const ColumnContext& context,
                       std::vector<Value>& out);

}  // namespace obby::importer
