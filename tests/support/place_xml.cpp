// Items are nested like the instances, with one element for each property.
#include "support/place_xml.h"

#include <cmath>
#include <cstdio>

namespace obby::test {

namespace {

std::string real(double v, int digits) {
  if (std::isnan(v)) return "NAN";
  if (std::isinf(v)) return v > 0 ? "INF" : "-INF";
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, v);
  return text;
}
std::string single(float v) { return real(static_cast<double>(v), 9); }

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const bool special = c == '&' || c == '<' || c == '>' || static_cast<unsigned char>(c) < ' ';
    out += special ? "&#" + std::to_string(static_cast<int>(c)) + ";" : std::string(1, c);
  }
  return out;
}

std::string tagged(const std::string& name, const std::string& inner) {
  return "<" + name + ">" + inner + "</" + name + ">";
}

std::string vectorText(Vec3 v) {
  return tagged("X", single(v.x)) + tagged("Y", single(v.y)) + tagged("Z", single(v.z));
}

std::string cframeText(const CFrame& f) {
  std::string out = vectorText(f.position);
  const Vec3 axes[3] = {f.rotation.x, f.rotation.y, f.rotation.z};
  for (int row = 0; row < 3; ++row) {
    for (int col = 0; col < 3; ++col) {
      const std::string name = "R" + std::to_string(row) + std::to_string(col);
      out += tagged(name, single(component(axes[col], row)));
    }
  }
  return out;
}

std::string physicalText(const PhysicalProperties& p, bool acoustics) {
  if (!p.custom) return tagged("CustomPhysics", "false");
  return tagged("CustomPhysics", "true") + tagged("Density", single(p.density)) +
         tagged("Friction", single(p.friction)) + tagged("Elasticity", single(p.elasticity)) +
         tagged("FrictionWeight", single(p.frictionWeight)) +
         tagged("ElasticityWeight", single(p.elasticityWeight)) +
         (acoustics ? tagged("AcousticAbsorption", "0.25") : "");
}

std::string colorText(ColorRgb c, bool packed) {
  if (packed) return std::to_string(0xff000000u | uint32_t{c.r} << 16 | uint32_t{c.g} << 8 | c.b);
  const auto part = [](uint8_t v) { return single(static_cast<float>(v) / 255); };
  return tagged("R", part(c.r)) + tagged("G", part(c.g)) + tagged("B", part(c.b));
}

std::string stringText(const FileValue& value) {
  const auto& text = std::get<std::string>(value.value);
  if (value.xmlElement == "BinaryString") return encodeBase64(text);
  if (value.xmlElement == "ProtectedString") return "<![CDATA[" + text + "]]>";
  if (value.xmlElement == "ContentId") return tagged("url", escaped(text));
  return escaped(text);
}

std::string contentOf(const FileValue& value, std::map<std::string, std::string>& sharedStrings) {
  const Value& v = value.value;
  switch (value.kind) {
    case FileKind::String:
    case FileKind::Bytecode: return stringText(value);
    case FileKind::UniqueId: return std::get<std::string>(v);
    case FileKind::Content: {
      const auto& uri = std::get<std::string>(v);
      return uri.empty() ? "<null></null>" : tagged("uri", escaped(uri));
    }
    case FileKind::SharedString: {
      const std::string& bytes = *std::get<SharedBlob>(v).bytes;
      return sharedStrings.emplace(bytes, "key" + std::to_string(sharedStrings.size()))
          .first->second;
    }
    case FileKind::Bool: return std::get<bool>(v) ? "true" : "false";
    case FileKind::Int32:
    case FileKind::Int64:
    case FileKind::SecurityCapabilities:
    case FileKind::BrickColor: return std::to_string(std::get<int64_t>(v));
    case FileKind::Float32: return real(std::get<double>(v), 9);
    case FileKind::Float64: return real(std::get<double>(v), 17);
    case FileKind::UDim:
      return tagged("S", single(std::get<UDim>(v).scale)) +
             tagged("O", std::to_string(std::get<UDim>(v).offset));
    case FileKind::NumberRange:
      return single(std::get<NumberRange>(v).min) + " " + single(std::get<NumberRange>(v).max) +
             " ";
    case FileKind::Color3: return colorText(std::get<ColorRgb>(v), false);
    case FileKind::Color3uint8: return colorText(std::get<ColorRgb>(v), true);
    case FileKind::Vector3: return vectorText(std::get<Vec3>(v));
    case FileKind::CFrame: return cframeText(std::get<CFrame>(v));
    case FileKind::OptionalCFrame:
      return v.index() == 0 ? "" : tagged("CFrame", cframeText(std::get<CFrame>(v)));
    case FileKind::Enum: return std::to_string(std::get<EnumItem>(v).value);
    case FileKind::Ref: {
      const InstanceId target = std::get<Ref>(v).target;
      return target == kNoInstance ? "null" : "RBX" + std::to_string(target);
    }
    case FileKind::PhysicalProperties:
      return physicalText(std::get<PhysicalProperties>(v), value.acoustics);
    default: return "<any>1 2 3</any>";  // kinds that a Document does not keep
  }
}

class XmlPlace {
 public:
  explicit XmlPlace(const std::vector<PlaceWriter::Entry>& entries) : entries_(entries) {}

  std::string write() {
    std::string out = "<roblox version=\"4\">\n<External>null</External>\n";
    out += itemsBelow(kNoInstance);
    if (!sharedStrings_.empty()) {
      out += "<SharedStrings>\n";
      for (const auto& [bytes, key] : sharedStrings_) {
        out += "<SharedString md5=\"" + key + "\">" + encodeBase64(bytes) + "</SharedString>\n";
      }
      out += "</SharedStrings>\n";
    }
    return out + "</roblox>\n";
  }

 private:
  std::string itemsBelow(InstanceId parent) {
    std::string out;
    for (size_t i = 0; i < entries_.size(); ++i) {
      const PlaceWriter::Entry& entry = entries_[i];
      if (entry.parent != parent) continue;
      out += "<Item class=\"" + entry.className + "\" referent=\"RBX" + std::to_string(i) +
             "\">\n<Properties>\n";
      for (const auto& [name, value] : entry.properties) {
        out += "<" + value.xmlElement + " name=\"" + name + "\">" +
               contentOf(value, sharedStrings_) + "</" + value.xmlElement + ">\n";
      }
      out += "</Properties>\n" + itemsBelow(static_cast<InstanceId>(i)) + "</Item>\n";
    }
    return out;
  }

  const std::vector<PlaceWriter::Entry>& entries_;
  std::map<std::string, std::string> sharedStrings_;  // bytes to key
};

}  // namespace

std::string encodeBase64(const std::string& bytes) {
  static constexpr char kDigits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t bits = 0;
    for (size_t k = 0; k < 3; ++k) {
      bits = (bits << 8) | (i + k < bytes.size() ? static_cast<uint8_t>(bytes[i + k]) : 0u);
    }
    const size_t digits = std::min<size_t>(bytes.size() - i, 3) + 1;
    for (size_t k = 0; k < 4; ++k) out += k < digits ? kDigits[(bits >> (18 - 6 * k)) & 63] : '=';
  }
  return out;
}

std::string xmlPlace(const std::vector<PlaceWriter::Entry>& entries) {
  return XmlPlace(entries).write();
}

}  // namespace obby::test
