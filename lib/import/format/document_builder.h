// What every file format shares: it collects instances in any order, names and types their
// properties alike, and at the end puts them into a Document with parents before children. Formats
// only say what the file holds.
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

// How a property of a class is kept.
struct PropertyPlan {
  PropertySpelling spelling;
  const Value* standard = nullptr;  // the class default; null if there is none
  bool dropStandard = false;        // a value that equals the default is left out
};

class DocumentBuilder {
 public:
  // `inputBytes` is the size of the file: it bounds how much memory the document may take.
  explicit DocumentBuilder(size_t inputBytes);

  // Ids count from 0 in order of the calls. Refs use these ids, too; finish() translates them.
  InstanceId add(std::string className);
  size_t size() const { return document_.instances.size(); }
  const std::string& classOf(InstanceId id) const { return document_.instances[id].className; }

  // `name` as in the file. The reference lasts as long as the builder.
  const PropertyPlan& planOf(const std::string& className, std::string_view name);
  // `name` as in the file. Returns false once the document has outgrown its memory (see
  // overBudget).
  bool set(InstanceId id, std::string_view name, Value value);
  void setAttribute(InstanceId id, std::string name, Value value);
  // Another class from here on; properties that are set keep their names.
  void become(InstanceId id, std::string className);
  // Takes over all instances of a document that is complete; its roots have no parent yet.
  std::vector<InstanceId> graft(Document&& document);
  // More input was read.
  void allow(size_t inputBytes);
  // The order of the calls is the order of the children. kNoInstance: a root. At most one call an
  // instance.
  void setParent(InstanceId child, InstanceId parent);
  void warn(std::string warning);

  bool overBudget() const { return used_ > budget_; }
  // For the message.
  Error budgetError() const;

  // Fails if instances are their own ancestors or nested too deep. `binary` and the roots decide
  // Document::format.
  Result<Document> finish(std::string file, bool binary);

 private:
  void setAttributes(InstanceId id, std::string_view blob);
  void warnOfAttributes();
  Status checkDepth(const std::vector<InstanceId>& order) const;

  Document document_;
  std::unordered_map<std::string, PropertyPlan> plans_;  // by class and name
  // Until the names of the instances are known: files have them after the attributes.
  std::vector<std::pair<InstanceId, std::string>> attributeWarnings_;
  size_t droppedWarnings_ = 0, cutNames_ = 0;
  size_t used_ = 0, budget_;
};

}  // namespace obby::importer
