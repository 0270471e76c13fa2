// Reads the chunks in order of their dependencies, whatever their order in the file: shared
// strings, instances, properties, parents.
#include "import/format/binary_format.h"

#include <algorithm>
#include <iterator>

#include "import/format/binary_values.h"
#include "import/format/byte_reader.h"
#include "import/format/chunk.h"
#include "import/format/columns.h"
#include "import/format/document_builder.h"
#include "io/text.h"

namespace obby::importer {
namespace {

constexpr std::string_view kBegin = "<roblox!";
constexpr std::string_view kSignature("<roblox!\x89\xff\r\n\x1a\n", 14);
constexpr size_t kHeaderSize = 32;

struct ClassGroup {
  std::string name;
  std::vector<InstanceId> members;  // instances in column order
};

class BinaryReader {
 public:
  explicit BinaryReader(std::string_view file) : file_(file), builder_(file.size()) {}

  Result<Document> read(const std::string& name) {
    OBBY_ASSIGN(const std::vector<Chunk> chunks, listChunks(file_, kHeaderSize));
    OBBY_RETURN_IF_ERROR(readAll(chunks, "SSTR", &BinaryReader::readSharedStrings));
    OBBY_RETURN_IF_ERROR(readAll(chunks, "INST", &BinaryReader::readInstances));
    OBBY_RETURN_IF_ERROR(readAll(chunks, "PROP", &BinaryReader::readProperty));
    OBBY_RETURN_IF_ERROR(readAll(chunks, "PRNT", &BinaryReader::readParents));
    if (placedCount_ < builder_.size()) {
      return chunkError(chunks.back(), io::plural(builder_.size() - placedCount_, "instance") +
                                           " without an entry in the PRNT chunk");
    }
    const Chunk* tree = nullptr;
    for (const Chunk& chunk : chunks) {
      warnOfUnknown(chunk);
      if (chunk.name == "PRNT") tree = &chunk;
    }
    Result<Document> document = builder_.finish(name, true);
    if (document || tree == nullptr) return document;
    return atChunk(*tree, std::move(document).error());
  }

 private:
  using ReadChunk = Status (BinaryReader::*)(const Chunk&, ByteReader&);

  Status readAll(const std::vector<Chunk>& chunks, std::string_view name, ReadChunk readChunk) {
    for (const Chunk& chunk : chunks) {
      if (chunk.name != name) continue;
      OBBY_ASSIGN(const ChunkData data, decompress(chunk, file_.size(), decompressed_));
      ByteReader reader(data.bytes);
      OBBY_RETURN_IF_ERROR((this->*readChunk)(chunk, reader));
    }
    return {};
  }

  Status readSharedStrings(const Chunk& chunk, ByteReader& reader) {
    reader.u32();  // version
    const uint32_t count = reader.u32();
    if (!reader.has(count, 16 + 4)) return tooShort(chunk, count, "shared strings");
    for (uint32_t i = 0; i < count; ++i) {
      reader.bytes(16);  // a hash that is not checked
      context_.sharedStrings.push_back(std::make_shared<const std::string>(reader.string()));
      if (!reader.ok()) return tooShort(chunk, count, "shared strings");
    }
    return {};
  }

  Status readInstances(const Chunk& chunk, ByteReader& reader) {
    const uint32_t classId = reader.u32();
    ClassGroup group;
    group.name = reader.string();
    reader.u8();  // marks services; unused
    const uint32_t count = reader.u32();
    const std::vector<int32_t> referents = readReferentColumn(reader, count);
    if (!reader.ok()) return tooShort(chunk, count, "instances");
    if (classes_.count(classId) != 0) {
      return chunkError(chunk, "class id " + std::to_string(classId) + " is declared twice");
    }
    for (const int32_t referent : referents) {
      const InstanceId id = builder_.add(group.name);
      if (builder_.overBudget()) return atChunk(chunk, builder_.budgetError());
      if (referent < 0 || !context_.instances.emplace(referent, id).second) {
        return chunkError(chunk, group.name + ": referent " + std::to_string(referent) +
                                     (referent < 0 ? " is negative" : " occurs twice"));
      }
      group.members.push_back(id);
    }
    classes_.emplace(classId, std::move(group));
    return {};
  }

  Status readProperty(const Chunk& chunk, ByteReader& reader) {
    const uint32_t classId = reader.u32();
    const std::string name(reader.string());
    if (!reader.ok()) return chunkError(chunk, "the chunk ends before the property's name");
    const auto group = classes_.find(classId);
    if (group == classes_.end()) {
      return chunkError(chunk, "'" + name + "' belongs to class id " + std::to_string(classId) +
                                   ", which no INST chunk declares");
    }
    const ClassGroup& owner = group->second;
    const std::string path = owner.name + "." + name;
    const uint8_t kind = reader.u8();
    if (!reader.ok()) return chunkError(chunk, path + ": the column ends before its value type");
    if (!isKnownKind(kind)) {
      builder_.warn("byte " + std::to_string(chunk.offset) + ": PROP " + path +
                    " skipped: unknown value type " + std::to_string(kind));
      return {};
    }
    std::vector<Value> values;
    const std::string problem = readColumn(kind, owner.members.size(), reader, context_, values);
    if (!problem.empty()) return chunkError(chunk, path + ": " + problem);
    for (size_t i = 0; i < values.size(); ++i) {
      if (!builder_.set(owner.members[i], name, std::move(values[i]))) {
        return atChunk(chunk, builder_.budgetError());
      }
    }
    return {};
  }

  Status readParents(const Chunk& chunk, ByteReader& reader) {
    reader.u8();  // version
    const uint32_t count = reader.u32();
    const std::vector<int32_t> children = readReferentColumn(reader, count);
    const std::vector<int32_t> parents = readReferentColumn(reader, count);
    if (!reader.ok()) return tooShort(chunk, count, "parents");
    placed_.resize(builder_.size());
    for (size_t i = 0; i < children.size(); ++i) {
      const InstanceId child = context_.resolve(children[i]).target;
      const InstanceId parent = context_.resolve(parents[i]).target;
      if (child == kNoInstance || (parent == kNoInstance && parents[i] != -1)) {
        const int32_t unknown = child == kNoInstance ? children[i] : parents[i];
        return chunkError(chunk, "refers to the missing instance " + std::to_string(unknown));
      }
      if (placed_[child]) {
        return chunkError(chunk, "instance " + std::to_string(children[i]) + " has two parents");
      }
      placed_[child] = true;
      ++placedCount_;
      builder_.setParent(child, parent);
    }
    return {};
  }

  void warnOfUnknown(const Chunk& chunk) {
    static constexpr std::string_view kKnown[] = {"META", "SSTR", "INST", "PROP",
                                                  "PRNT", "END",  "SIGN"};
    if (std::find(std::begin(kKnown), std::end(kKnown), chunk.name) == std::end(kKnown)) {
      builder_.warn("byte " + std::to_string(chunk.offset) + ": unknown chunk '" + chunk.name +
                    "' skipped");
    }
  }

  static Error atChunk(const Chunk& chunk, Error error) {
    Error placed = chunkError(chunk, std::move(error.message));
    placed.hint = std::move(error.hint);
    return placed;
  }
  static Error tooShort(const Chunk& chunk, uint32_t count, const char* what) {
    return chunkError(chunk, "the chunk ends before its " + std::to_string(count) + " " + what);
  }

  std::string_view file_;
  DocumentBuilder builder_;
  ColumnContext context_;
  std::unordered_map<uint32_t, ClassGroup> classes_;
  std::vector<bool> placed_;  // instances that have their place in the tree
  size_t placedCount_ = 0;
  size_t decompressed_ = 0;  // bytes of all chunks so far
};

}  // namespace

bool looksLikeBinary(std::string_view bytes) { return bytes.substr(0, kBegin.size()) == kBegin; }

Result<Document> readBinary(std::string_view bytes, const std::string& file) {
  const auto fail = [&file](Error error) {
    error.input = file;
    return error;
  };
  if (bytes.size() < kHeaderSize || bytes.substr(0, kSignature.size()) != kSignature) {
    return fail(Error{{}, "byte 0", {}, "expected the 32-byte header of a binary place", {}});
  }
  ByteReader header(bytes.substr(kSignature.size()));
  if (const uint16_t version = header.u16(); version != 0) {
    return fail(Error{{},
                      "byte 14",
                      {},
                      "binary format version " + std::to_string(version) + " is not supported",
                      "only version 0 can be read"});
  }
  Result<Document> document = BinaryReader(bytes).read(file);
  if (!document) return fail(std::move(document).error());
  return document;
}

}  // namespace obby::importer
