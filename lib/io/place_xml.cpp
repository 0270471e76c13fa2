#include "io/place_xml.h"

#include <fmt/format.h>

#include "io/base64.h"
#include "io/text.h"

namespace obby::io {

namespace {

// Appends what pugixml prints.
struct Appended : pugi::xml_writer {
  explicit Appended(std::string& to) : out(to) {}
  void write(const void* data, size_t size) override {
    out.append(static_cast<const char*>(data), size);
  }
  std::string& out;
};

// Returns the text with a space for each character that XML cannot hold.
std::string withinXml(std::string_view text) {
  std::string out;
  for (size_t i = 0; i < text.size(); ++i) {
    const size_t bytes = notInXml(text.substr(i));
    out += bytes > 0 ? ' ' : text[i];
    if (bytes > 0) i += bytes - 1;
  }
  return out;
}

void add(pugi::xml_node to, const char* name, float value) {
  to.append_child(name).text().set(fmt::to_string(value).c_str());
}

void add(pugi::xml_node to, Vec3 v) {
  add(to, "X", v.x);
  add(to, "Y", v.y);
  add(to, "Z", v.z);
}

}  // namespace

pugi::xml_node PlaceXml::property(const char* type, const char* name) {
  element_.remove_children();
  pugi::xml_node element = element_.append_child(type);
  element.append_attribute("name").set_value(name);
  return element;
}

void PlaceXml::write() {
  Appended to(out_);
  element_.first_child().print(to, "", pugi::format_raw);
  out_ += '\n';
}

void PlaceXml::write(const char* type, const char* name, const std::string& text) {
  property(type, name).text().set(text.c_str());
  write();
}

void PlaceXml::begin(const char* className, std::string_view name) {
  out_ += fmt::format("<Item class=\"{}\" referent=\"RBX{}\">\n<Properties>\n", className,
                      ++referents_);
  write("string", "Name", withinXml(name));
}

void PlaceXml::flag(const char* name, bool value) { write("bool", name, fmt::to_string(value)); }

void PlaceXml::number(const char* name, float value) {
  write("float", name, fmt::to_string(value));
}

void PlaceXml::token(const char* name, uint32_t value) {
  write("token", name, fmt::to_string(value));
}

void PlaceXml::vector(const char* name, Vec3 v) {
  add(property("Vector3", name), v);
  write();
}

void PlaceXml::frame(const char* name, Vec3 p, const Mat3& r) {
  const pugi::xml_node element = property("CoordinateFrame", name);
  add(element, p);
  const Vec3 columns[3] = {r.x, r.y, r.z};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      add(element, fmt::format("R{}{}", row, column).c_str(), component(columns[column], row));
  }
  write();
}

void PlaceXml::color(const char* name, uint32_t rgb) {
  write("Color3uint8", name, fmt::to_string(0xff000000u | rgb));
}

void PlaceXml::source(std::string_view script) {
  property("ProtectedString", "Source")
      .append_child(pugi::node_cdata)
      .set_value(std::string(script).c_str());
  write();
}

void PlaceXml::tags(std::string_view tag) { write("BinaryString", "Tags", encodeBase64(tag)); }

void PlaceXml::reference(const char* name, uint32_t referent) {
  write("Ref", name, fmt::format("RBX{}", referent));
}

void PlaceXml::physical(float density, float friction, float frictionWeight) {
  pugi::xml_node element = property("PhysicalProperties", "CustomPhysicalProperties");
  element.append_child("CustomPhysics").text().set(true);
  add(element, "Density", density);
  add(element, "Friction", friction);
  add(element, "Elasticity", 0.5f);
  add(element, "FrictionWeight", frictionWeight);
  add(element, "ElasticityWeight", 1);
  write();
}

}  // namespace obby::io
