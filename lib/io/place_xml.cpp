#include "io/place_xml.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/text.h"

namespace obby::io {

namespace {

std::string escaped(std::string_view text) {
  std::string out;
  for (size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (const size_t bytes = notInXml(text.substr(i)); bytes > 0) {
      out += ' ';
      i += bytes - 1;
    } else if (c == '&' || c == '<' || c == '>') {
      out += "&#" + std::to_string(int(c)) + ";";
    } else {
      out += c;
    }
  }
  return out;
}

std::string base64(std::string_view bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t group = 0;
    const size_t there = std::min<size_t>(3, bytes.size() - i);
    for (size_t k = 0; k < 3; ++k) {
      group = group << 8 | (k < there ? uint8_t(bytes[i + k]) : 0u);
    }
    for (size_t k = 0; k < 4; ++k) {
      out += k <= there ? kDigits[(group >> (18 - 6 * k)) & 63] : '=';
    }
  }
  return out;
}

}  // namespace

void PlaceXml::begin(const char* className, std::string_view name) {
  out_ += fmt::format("<Item class=\"{}\" referent=\"RBX{}\">\n<Properties>\n", className,
                      ++referents_);
  out_ += fmt::format("<string name=\"Name\">{}</string>\n", escaped(name));
}

void PlaceXml::flag(const char* name, bool value) {
  out_ += fmt::format("<bool name=\"{}\">{}</bool>\n", name, value);
}

void PlaceXml::number(const char* name, float value) {
  out_ += fmt::format("<float name=\"{}\">{}</float>\n", name, value);
}

void PlaceXml::token(const char* name, uint32_t value) {
  out_ += fmt::format("<token name=\"{}\">{}</token>\n", name, value);
}

void PlaceXml::vector(const char* name, Vec3 v) {
  out_ += fmt::format("<Vector3 name=\"{}\"><X>{}</X><Y>{}</Y><Z>{}</Z></Vector3>\n", name, v.x,
                      v.y, v.z);
}

void PlaceXml::frame(const char* name, Vec3 p, const Mat3& r) {
  out_ +=
      fmt::format("<CoordinateFrame name=\"{}\"><X>{}</X><Y>{}</Y><Z>{}</Z>", name, p.x, p.y, p.z);
  const Vec3 columns[3] = {r.x, r.y, r.z};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      out_ += fmt::format("<R{0}{1}>{2}</R{0}{1}>", row, column, component(columns[column], row));
    }
  }
  out_ += "</CoordinateFrame>\n";
}

void PlaceXml::color(const char* name, uint32_t rgb) {
  out_ += fmt::format("<Color3uint8 name=\"{}\">{}</Color3uint8>\n", name, 0xff000000u | rgb);
}

void PlaceXml::source(std::string_view script) {
  // The end of a CDATA section in the script is split, with each half in its own section.
  out_ += "<ProtectedString name=\"Source\"><![CDATA[";
  for (size_t end; (end = script.find("]]>")) != std::string_view::npos;) {
    out_ += script.substr(0, end + 2);
    out_ += "]]><![CDATA[";
    script.remove_prefix(end + 2);
  }
  out_ += script;
  out_ += "]]></ProtectedString>\n";
}

void PlaceXml::tags(std::string_view tag) {
  out_ += fmt::format("<BinaryString name=\"Tags\">{}</BinaryString>\n", base64(tag));
}

void PlaceXml::reference(const char* name, uint32_t referent) {
  out_ += fmt::format("<Ref name=\"{}\">RBX{}</Ref>\n", name, referent);
}

void PlaceXml::physical(float density, float friction, float frictionWeight) {
  out_ += fmt::format(
      "<PhysicalProperties name=\"CustomPhysicalProperties\"><CustomPhysics>true</CustomPhysics>"
      "<Density>{}</Density><Friction>{}</Friction><Elasticity>0.5</Elasticity>"
      "<FrictionWeight>{}</FrictionWeight><ElasticityWeight>1</ElasticityWeight>"
      "</PhysicalProperties>\n",
      density, friction, frictionWeight);
}

}  // namespace obby::io
