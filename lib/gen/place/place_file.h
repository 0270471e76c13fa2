// Writes levels as an XML place file (rbxlx) for Studio. Each level is a separate Model. Scripts in
// the Model implement the parts' roles, as is usual in obbies. obby-import reads the same roles
// back (docs/generator.md says what is lost).
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
  // The place gets the generator's physics. `maxBytes`: max size of the file, at least 4096.
  // obby-import and other programs do not read files larger than the default.
  explicit PlaceFile(const Generator& generator, uint64_t maxBytes = io::kMaxFileBytes);
  PlaceFile(const PlaceFile&) = delete;
  PlaceFile& operator=(const PlaceFile&) = delete;

  // Adds a level. Error: the file or the world is full; both stay unchanged. About ten thousand
  // levels fit.
  Status add(const Generated& level);
  // Returns the file's bytes. Call it once, after the last level.
  std::string finish();

 private:
  Error full(const std::string& within) const;
  void writePart(const PartSketch& part, const std::vector<PartSketch>& all, Vec3 shift);
  void writeProperties(const PartSketch& part, Vec3 shift);
  void writeCarrier(const PartSketch& part, Vec3 shift);
  void writeScript(const char* name, const std::string& source);

  const Params params_;
  const uint64_t maxBytes_;
  std::string levels_;
  io::PlaceXml xml_{levels_};
  float next_ = 0;    // studs along X from which on the place is free
  float lowest_ = 0;  // studs, min over all parts
  uint64_t added_ = 0;
};

}  // namespace obby::gen
