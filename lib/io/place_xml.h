// Writes the XML of a place or model file: nested items, with one element for each property. The
// items are between kXmlBegin and kXmlEnd. pugixml writes the elements.
#pragma once

#include <cstdint>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "math/vec.h"

namespace obby::io {

inline constexpr const char* kXmlBegin = "<roblox version=\"4\">\n";
inline constexpr const char* kXmlEnd = "</roblox>\n";

class PlaceXml {
 public:
  explicit PlaceXml(std::string& out) : out_(out) {}

  // Begins an item and writes its name. Its properties follow, until endProperties(). Referents
  // count up.
  void begin(const char* className, std::string_view name);
  void endProperties() { out_ += "</Properties>\n"; }
  void end() { out_ += "</Item>\n"; }

  void flag(const char* name, bool value);
  void number(const char* name, float value);
  void token(const char* name, uint32_t value);
  void vector(const char* name, Vec3 value);
  void frame(const char* name, Vec3 position, const Mat3& rotation);
  void color(const char* name, uint32_t rgb);
  void source(std::string_view script);
  void tags(std::string_view tags);  // one tag
  void reference(const char* name, uint32_t referent);
  void physical(float density, float friction, float frictionWeight);

  uint32_t lastReferent() const { return referents_; }

 private:
  // Begins the element of a property.
  pugi::xml_node property(const char* type, const char* name);
  // Writes the element that property() began.
  void write();
  void write(const char* type, const char* name, const std::string& text);

  std::string& out_;
  pugi::xml_document element_;
  uint32_t referents_ = 0;
};

}  // namespace obby::io
