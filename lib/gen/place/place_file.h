// Levels as a place file in XML (rbxlx) that Studio opens and plays: each level is a Model, set
// apart from the others; what a part does is done by a script in it, as makers of obbies do.
// obby-import reads the same roles back (docs/generator.md says what is lost).
#pragma once

#include <cstdint>
#include <string>

#include "base/result.h"
#include "gen/generator.h"
#include "io/place_xml.h"
#include "io/read_file.h"

namespace obby::gen {

class PlaceFile {
 public:
  // The world gets the generator's physics. `mostBytes`: of the file, from 4096 on; more than the
  // default nobody reads, obby-import among them.
  explicit PlaceFile(const Generator& generator, uint64_t mostBytes = io::kMostFileBytes);
  PlaceFile(const PlaceFile&) = delete;
  PlaceFile& operator=(const PlaceFile&) = delete;

  // Error: there is no room left for it, in the file or in the world; both stay as they were. Some
  // ten thousand levels fit.
  Status add(const Generated& level);
  // The file's bytes. Call it once, after the last level.
  std::string finish();

 private:
  Error full(const std::string& within) const;
  void writePart(const PartSketch& part, const std::vector<PartSketch>& all, Vec3 shift);
  void writeProperties(const PartSketch& part, Vec3 shift);
  void writeCarrier(const PartSketch& part, Vec3 shift);
  void writeScript(const char* name, const std::string& source);

  const Params params_;
  const uint64_t mostBytes_;
  std::string levels_;
  io::PlaceXml xml_{levels_};
  float next_ = 0;    // studs along X from which on nothing is built yet
  float lowest_ = 0;  // studs, of all parts
  uint64_t added_ = 0;
};

}  // namespace obby::gen
