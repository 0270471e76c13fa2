// Groups parts that joints hold together. One anchored part anchors its whole group.
#pragma once

#include <unordered_map>
#include <vector>

#include "import/document/tree.h"

namespace obby::importer {

class Assemblies {
 public:
  // Reads every rigid joint of the document (Weld, Snap, ManualWeld, WeldConstraint, Glue, Motor,
  // Motor6D, RigidConstraint). A joint that is switched off or lacks a part joins nothing.
  explicit Assemblies(const Tree& tree);

  // Returns true if the part is anchored or a joint chain leads from it to an anchored part.
  bool anchored(InstanceId part) const;
  bool same(InstanceId a, InstanceId b) const { return find(a) == find(b); }
  // Returns every part joined with this one, itself included, in file order.
  std::vector<InstanceId> members(InstanceId part) const;

 private:
  InstanceId find(InstanceId id) const;
  void join(InstanceId a, InstanceId b);

  mutable std::vector<InstanceId> parent_;
  std::vector<char> anchored_;  // indexed by representative
  std::unordered_map<InstanceId, std::vector<InstanceId>> members_;
};

// The two parts that a joint or constraint connects (through attachments where it has them). An end
// that is missing is kNoInstance.
struct JointEnds {
  InstanceId first = kNoInstance, second = kNoInstance;
};
JointEnds jointEnds(const Tree& tree, InstanceId joint);

}  // namespace obby::importer
