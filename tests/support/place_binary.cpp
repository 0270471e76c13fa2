// Groups the instances by class and writes a column for each property of the class.
#include "support/place_binary.h"

#include <lz4.h>
#include <zstd.h>

namespace obby::test {

namespace {

class BinaryPlace {
 public:
  BinaryPlace(const std::vector<PlaceWriter::Entry>& entries, Packing packing)
      : entries_(entries), packing_(packing) {
    for (size_t i = 0; i < entries.size(); ++i) {
      groups_[entries[i].className].push_back(static_cast<int32_t>(i));
    }
  }

  std::string write() {
    std::string instances, properties;
    uint32_t classId = 0;
    for (const auto& [className, members] : groups_) {
      instances += instanceChunk(classId, className, members, packing_);
      properties += propertiesOf(classId, members);
      ++classId;
    }
    std::string out = fileHeader(classId, static_cast<uint32_t>(entries_.size()));
    out += chunk("META", std::string(4, '\0'), packing_);
    if (!sharedStrings_.empty()) out += sharedChunk();
    std::vector<int32_t> children, parents;
    for (size_t i = 0; i < entries_.size(); ++i) {
      children.push_back(static_cast<int32_t>(i));
      const auto parent = entries_[i].parent;
      parents.push_back(parent == kNoInstance ? -1 : static_cast<int32_t>(parent));
    }
    return out + instances + properties + parentChunk(children, parents, packing_) + endChunk();
  }

 private:
  std::string propertiesOf(uint32_t classId, const std::vector<int32_t>& members) {
    std::map<std::string, FileValue> kinds;
    for (const int32_t i : members) {
      kinds.insert(entries_[i].properties.begin(), entries_[i].properties.end());
    }
    std::string out;
    for (const auto& [name, like] : kinds) {
      std::vector<FileValue> values;
      for (const int32_t i : members) {
        const auto own = entries_[i].properties.find(name);
        values.push_back(own == entries_[i].properties.end() ? emptyOf(like) : own->second);
      }
      out += propertyChunk(classId, name, static_cast<uint8_t>(like.kind),
                           columnOf(like.kind, values, sharedStrings_), packing_);
    }
    return out;
  }

  std::string sharedChunk() const {
    std::string data;
    append(data, 0);
    append(data, static_cast<uint32_t>(sharedStrings_.size()));
    for (const std::string& s : sharedStrings_) {
      data += std::string(16, '\0');
      appendString(data, s);
    }
    return chunk("SSTR", data, packing_);
  }

  const std::vector<PlaceWriter::Entry>& entries_;
  Packing packing_;
  std::map<std::string, std::vector<int32_t>> groups_;
  SharedStrings sharedStrings_;
};

}  // namespace

std::string fileHeader(uint32_t classes, uint32_t instances) {
  std::string out("<roblox!\x89\xff\r\n\x1a\n\0\0", 16);
  append(out, classes);
  append(out, instances);
  return out + std::string(8, '\0');
}

std::string chunk(const std::string& name, const std::string& data, Packing packing) {
  std::string body = data;
  if (packing == Packing::Lz4) {
    body.resize(static_cast<size_t>(LZ4_compressBound(static_cast<int>(data.size()))));
    body.resize(static_cast<size_t>(LZ4_compress_default(
        data.data(), body.data(), static_cast<int>(data.size()), static_cast<int>(body.size()))));
  } else if (packing == Packing::Zstd) {
    body.resize(ZSTD_compressBound(data.size()));
    body.resize(ZSTD_compress(body.data(), body.size(), data.data(), data.size(), 3));
  }
  std::string out = name;
  out.resize(4, '\0');
  append(out, packing == Packing::Stored ? 0 : static_cast<uint32_t>(body.size()));
  append(out, static_cast<uint32_t>(data.size()));
  append(out, 0);
  return out + body;
}

std::string instanceChunk(uint32_t classId, const std::string& className,
                          const std::vector<int32_t>& referents, Packing packing) {
  std::string data;
  append(data, classId);
  appendString(data, className);
  data += '\0';
  append(data, static_cast<uint32_t>(referents.size()));
  appendReferents(data, referents);
  return chunk("INST", data, packing);
}

std::string propertyChunk(uint32_t classId, const std::string& name, uint8_t kind,
                          const std::string& column, Packing packing) {
  std::string data;
  append(data, classId);
  appendString(data, name);
  data += static_cast<char>(kind);
  return chunk("PROP", data + column, packing);
}

std::string parentChunk(const std::vector<int32_t>& children, const std::vector<int32_t>& parents,
                        Packing packing) {
  std::string data(1, '\0');
  append(data, static_cast<uint32_t>(children.size()));
  appendReferents(data, children);
  appendReferents(data, parents);
  return chunk("PRNT", data, packing);
}

std::string endChunk() { return chunk("END", "</roblox>", Packing::Stored); }

std::string binaryPlace(const std::vector<PlaceWriter::Entry>& entries, Packing packing) {
  return BinaryPlace(entries, packing).write();
}

}  // namespace obby::test
