// Builds a Document for every file format. It collects instances in any order and normalises their
// property names and types. At the end it puts them into a Document with parents before children.
// Format readers only report the content of the file.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/result.h"
#include "engine/document.h"
#include "import/format/property_names.h"

namespace obby::importer {

inline constexpr size_t kMaxInstanceDepth = 512;

// The storage of a property of a class.
struct PropertyPlan {
  PropertySpelling spelling;
  const Value* standard = nullptr;  // the class default; null if there is none
  bool dropStandard = false;        // leave out a value that equals the default
};

class DocumentBuilder {
 public:
  // `inputBytes` is the size of the file. It bounds the memory of the document.
  explicit DocumentBuilder(size_t inputBytes);

  // Adds an instance and returns its id. Ids count from 0 in order of the calls. Refs use these
  // ids, too; finish() translates them.
  InstanceId add(std::string className);
  size_t size() const { return document_.instances.size(); }
  const std::string& classOf(InstanceId id) const { return document_.instances[id].className; }

  // Returns the plan for a property, by its `name` in the file. The reference lasts as long as the
  // builder.
  const PropertyPlan& planOf(const std::string& className, std::string_view name);
  // Sets a property, by its `name` in the file. Returns false once the document has outgrown its
  // memory (see overBudget).
  bool set(InstanceId id, std::string_view name, Value value);
  void setAttribute(InstanceId id, std::string name, Value value);
  // Changes the class of an instance. Properties already set keep their names.
  void become(InstanceId id, std::string className);
  // Moves all instances of a complete document into this one. Returns its roots, which have no
  // parent yet.
  std::vector<InstanceId> graft(Document&& document);
  // Adds to the size of the input, and so to the memory budget.
  void allow(size_t inputBytes);
  // Sets the parent; kNoInstance makes a root. Children get the order of the calls. Call it at most
  // once for an instance.
  void setParent(InstanceId child, InstanceId parent);
  void warn(std::string warning);

  bool overBudget() const { return used_ > budget_; }
  // Returns the error of a document that is over budget.
  Error budgetError() const;

  // Finishes the document. Fails if instances are their own ancestors or nested too deep. `binary`
  // and the roots decide Document::format.
  Result<Document> finish(std::string file, bool binary);

 private:
  void setAttributes(InstanceId id, std::string_view blob);
  void warnOfAttributes();
  Status checkDepth(const std::vector<InstanceId>& order) const;

  Document document_;
  std::unordered_map<std::string, PropertyPlan> plans_;  // plans by class and name
  // Warnings kept until the names of the instances are known: files have names after attributes.
  std::vector<std::pair<InstanceId, std::string>> attributeWarnings_;
  size_t droppedWarnings_ = 0, cutNames_ = 0;
  size_t used_ = 0, budget_;
};

}  // namespace obby::importer
