// Finds the solid parts that a body may be pressed into, and the parts near a place (docs/proof.md,
// contacts).
#pragma once

#include <vector>

#include "solve/proof/box_index.h"
#include "solve/proof/part_motion.h"
#include "solve/proof/supports.h"

namespace obby::solve {

class Contacts {
 public:
  // `appear`: where players start, or teleporters lead.
  Contacts(const level::LevelView& level, const BodyLimits& limits,
           const std::vector<PartMotion>& motions, const std::vector<Vec3>& appear);

  Beside besideOf(uint32_t id) const { return beside_[id]; }

  // Calls found(id) once for every solid part whose box meets `box`.
  template <class Found>
  void find(const Box& box, Found&& found) const {
    index_.find(box, [&](uint32_t i) { found(solids_[i]); });
  }

 private:
  std::vector<Box> solidBoxes();
  bool isRough(uint32_t id) const;
  bool movesAlone(uint32_t id) const;
  bool isAxial(uint32_t id) const;
  bool holdsBetween(uint32_t a, uint32_t b) const;
  void spreadFrom(Box where, float push);
  void spreadDeep(const std::vector<Vec3>& appear);
  void findPinched();

  const level::LevelView& level_;
  const BodyLimits& limits_;
  const std::vector<PartMotion>& motions_;
  std::vector<Beside> beside_;    // (colliders)
  std::vector<Box> pressed_;      // (colliders): where a body may be in a deep one
  std::vector<uint32_t> solids_;  // of the boxes in the index
  BoxIndex index_;
  size_t work_ = 0;
};

}  // namespace obby::solve
