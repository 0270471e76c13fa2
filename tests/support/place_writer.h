// Builds a small place or model and writes it in each file format. Only tests use it, since the
// project itself writes no places.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "support/file_values.h"

namespace obby::test {

// How the chunks of a binary file are stored.
enum class Packing { Stored, Lz4, Zstd };

class PlaceWriter {
 public:
  using Id = InstanceId;

  // Adds an instance. Its parent must have been added before. An empty name omits the Name
  // property.
  Id add(std::string className, std::string name = {}, Id parent = kNoInstance);
  // Sets `property`, which is spelled as in files: "size", "Color3uint8", "shape".
  PlaceWriter& set(Id id, std::string property, FileValue value);
  PlaceWriter& tag(Id id, std::string tag);
  // Sets an attribute of one of these types: bool, int64_t (written as 32 bits), double,
  // std::string, EnumItem, Vec3, CFrame, ColorRgb, UDim.
  PlaceWriter& attribute(Id id, std::string name, Value value);

  std::string binary(Packing packing = Packing::Zstd) const;
  std::string xml() const;

  struct Entry {
    std::string className;
    Id parent;
    std::map<std::string, FileValue> properties;
    std::vector<std::string> tags;
    std::map<std::string, Value> attributes;
  };

 private:
  // Returns the entries with tags and attributes as properties.
  std::vector<Entry> completed() const;

  std::vector<Entry> entries_;
};

// Returns the blob of AttributesSerialize.
std::string encodeAttributes(const std::map<std::string, Value>& attributes);

}  // namespace obby::test
