// Looks up instances of a Document: children by name, paths, tags, settings.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/spelling.h"
#include "engine/document.h"

namespace obby::importer {

class Tree {
 public:
  // Keeps a reference: the document must outlive the tree.
  explicit Tree(const Document& document);

  const Document& document() const { return *document_; }
  const Instance& at(InstanceId id) const { return document_->instances[id]; }
  size_t size() const { return document_->instances.size(); }

  // Returns the root service of that class, or kNoInstance. A model file usually has none.
  InstanceId service(std::string_view className) const;
  // Returns the first root with that name, or kNoInstance.
  InstanceId rootNamed(std::string_view name) const;
  // Returns the roots of the world: Workspace, or all roots of a model file.
  std::vector<InstanceId> worldRoots() const;

  // Returns the first child with that name (case counts), or kNoInstance.
  InstanceId child(InstanceId parent, std::string_view name) const;
  InstanceId childOfClass(InstanceId parent, std::string_view className) const;
  bool isUnder(InstanceId id, InstanceId ancestor) const;  // true for itself
  bool isPart(InstanceId id) const;
  // Visits every instance below `root`, parents before children, in file order. If `visit` returns
  // false, the instance's children are skipped.
  void eachBelow(InstanceId root, const std::function<bool(InstanceId)>& visit) const;
  // Returns the part itself, or the parts below a model or folder.
  std::vector<InstanceId> partsOf(InstanceId id) const;
  const std::vector<InstanceId>& tagged(const std::string& tag) const;

  // Returns "Workspace/Stage 1/Lava". In a path of more than 1000 bytes, "..." replaces the middle.
  std::string path(InstanceId id) const;
  std::vector<uint32_t> indices(InstanceId id) const;  // sibling indices from the root

  // Returns the setting `name` of the instance: an attribute, else a value object below it or in
  // its Configuration. Names are compared without case. A text that holds a number counts as a
  // number.
  std::optional<double> number(InstanceId id, std::string_view name) const;
  std::optional<std::string> text(InstanceId id, std::string_view name) const;
  std::optional<bool> flag(InstanceId id, std::string_view name) const;

 private:
  const Value* setting(InstanceId id, std::string_view name) const;
  const Value* settingHere(InstanceId id, std::string_view name) const;

  const Document* document_;
  std::vector<uint32_t> siblingIndex_;
  std::unordered_map<std::string, std::vector<InstanceId>> byTag_;
  // The first service of each class, and the first root of each name.
  std::map<std::string, InstanceId, std::less<>> services_, roots_;
};

// Returns true if `text` contains `word`; both are lower case.
bool containsWord(std::string_view text, std::string_view word);
// Returns the first whole number in a text ("Checkpoint 12" has 12).
std::optional<int> firstNumber(std::string_view text);
// Returns the number if the whole text is one ("0.6", " 12 "), else nullopt.
std::optional<double> numberFrom(const Value& value);

}  // namespace obby::importer
