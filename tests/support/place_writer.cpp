// Collects the instances; the formats are written in place_binary.cpp and place_xml.cpp.
#include "support/place_writer.h"

#include "support/place_binary.h"
#include "support/place_xml.h"

namespace obby::test {

namespace {

struct AttributeBytes {
  std::string& out;

  void floats(std::initializer_list<float> values) {
    for (const float v : values) appendFloat(out, v);
  }
  void operator()(std::monostate) { out += '\x7f'; }  // no known kind
  void operator()(bool v) { out += std::string("\x03", 1) + static_cast<char>(v); }
  void operator()(int64_t v) {
    out += '\x04';
    append(out, static_cast<uint32_t>(v));
  }
  void operator()(double v) {
    out += '\x06';
    appendDouble(out, v);
  }
  void operator()(const std::string& v) {
    out += '\x02';
    appendString(out, v);
  }
  void operator()(const EnumItem& v) {
    out += '\x15';
    appendString(out, v.type);
    append(out, v.value);
  }
  void operator()(Vec3 v) {
    out += '\x11';
    floats({v.x, v.y, v.z});
  }
  void operator()(const CFrame& v) {
    out += '\x14';
    floats({v.position.x, v.position.y, v.position.z});
    appendRotation(out, v.rotation);
  }
  void operator()(ColorRgb v) {
    out += '\x0f';
    floats({static_cast<float>(v.r) / 255, static_cast<float>(v.g) / 255,
            static_cast<float>(v.b) / 255});
  }
  void operator()(UDim v) {
    out += '\x09';
    floats({v.scale});
    append(out, static_cast<uint32_t>(v.offset));
  }
  void operator()(Ref) { (*this)(std::monostate{}); }
  void operator()(const PhysicalProperties&) { (*this)(std::monostate{}); }
  void operator()(const SharedBlob&) { (*this)(std::monostate{}); }
  void operator()(NumberRange) { (*this)(std::monostate{}); }
};

}  // namespace

std::string encodeAttributes(const std::map<std::string, Value>& attributes) {
  std::string out;
  append(out, static_cast<uint32_t>(attributes.size()));
  for (const auto& [name, value] : attributes) {
    appendString(out, name);
    std::visit(AttributeBytes{out}, value);
  }
  return out;
}

PlaceWriter::Id PlaceWriter::add(std::string className, std::string name, Id parent) {
  entries_.push_back({std::move(className), parent, {}, {}, {}});
  if (!name.empty()) entries_.back().properties["Name"] = text(std::move(name));
  return static_cast<Id>(entries_.size() - 1);
}

PlaceWriter& PlaceWriter::set(Id id, std::string property, FileValue value) {
  entries_.at(id).properties[std::move(property)] = std::move(value);
  return *this;
}

PlaceWriter& PlaceWriter::tag(Id id, std::string tag) {
  entries_.at(id).tags.push_back(std::move(tag));
  return *this;
}

PlaceWriter& PlaceWriter::attribute(Id id, std::string name, Value value) {
  entries_.at(id).attributes[std::move(name)] = std::move(value);
  return *this;
}

std::vector<PlaceWriter::Entry> PlaceWriter::completed() const {
  std::vector<Entry> out = entries_;
  for (Entry& entry : out) {
    std::string tags;
    for (const std::string& tag : entry.tags)
      tags += (tags.empty() ? "" : std::string(1, '\0')) + tag;
    if (!tags.empty()) entry.properties["Tags"] = blob(tags);
    if (!entry.attributes.empty()) {
      entry.properties["AttributesSerialize"] = blob(encodeAttributes(entry.attributes));
    }
  }
  return out;
}

std::string PlaceWriter::binary(Packing packing) const { return binaryPlace(completed(), packing); }
std::string PlaceWriter::xml() const { return xmlPlace(completed()); }

}  // namespace obby::test
