// What scripts have changed of parts, against the file.
#pragma once

#include <array>
#include <map>

#include "import/roles/role.h"

namespace obby::importer {

enum class Aspect : size_t { solid, touch, anchored, transparency, size, pose };

// The line of a script that changes something.
struct Cause {
  const ScriptReading* reading = nullptr;
  int line = 0;

  std::string reason(const Tree& tree) const { return scriptReason(tree, *reading, line); }
};

class PartChanges {
 public:
  // Call it before an aspect is set; the last cause becomes the evidence.
  void expect(const PartDraft& part, Aspect aspect, const Cause& cause);

  // For all parts that were to change: the evidence of what is other than in the file by now, hulls
  // as large as the part, and `rest` of one that is elsewhere. Call it once, at the end.
  void settle(RoleContext& context) const;

 private:
  static constexpr size_t kAspects = 6;
  struct InFile {
    bool solid = true, touch = true, anchored = true;
    float transparency = 0;
    Vec3 size;
    Pose pose;
    std::array<Cause, kAspects> causes;
  };
  static void settle(const Tree& tree, PartDraft& part, const InFile& was);

  std::map<InstanceId, InFile> known_;
};

}  // namespace obby::importer
