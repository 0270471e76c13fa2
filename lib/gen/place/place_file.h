// Levels as a place file in XML (rbxlx) that Studio opens and plays: each level is a Model, set
// apart from the others; what a part does is done by a script in it, as makers of obbies do.
// obby-import reads the same roles back (docs/generator.md says what is lost).
#pragma once

#include <string>

#include "gen/generator.h"
#include "io/place_xml.h"

namespace obby::gen {

class PlaceFile {
 public:
  // The world gets the generator's physics.
  explicit PlaceFile(const Generator& generator);
  PlaceFile(const PlaceFile&) = delete;
  PlaceFile& operator=(const PlaceFile&) = delete;

  void add(const Generated& level);
  // The file's bytes. Call it once, after the last level.
  std::string finish();

 private:
  void writePart(const PartSketch& part, const std::vector<PartSketch>& all, Vec3 shift);
  void writeProperties(const PartSketch& part, Vec3 shift);
  void writeCarrier(const PartSketch& part, Vec3 shift);
  void writeScript(const char* name, const std::string& source);

  const Params params_;
  std::string levels_;
  io::PlaceXml xml_{levels_};
  float next_ = 0;    // studs along X from which on nothing is built yet
  float lowest_ = 0;  // studs, of all parts
  bool first_ = true;
};

}  // namespace obby::gen
