#include "import/records/place_names.h"

#include <algorithm>
#include <iterator>

#include "import/document/words.h"

namespace obby::importer {
namespace {

// Studio's default names, and usual names of the touched part of a model.
constexpr std::string_view kEmptyNames[] = {"part",
                                            "spawnlocation",
                                            "spawn",
                                            "touch",
                                            "hitbox",
                                            "trigger",
                                            "block",
                                            "brick",
                                            "meshpart",
                                            "union",
                                            "unionoperation",
                                            "wedge",
                                            "wedgepart",
                                            "cylinder",
                                            "model",
                                            "folder",
                                            "pad",
                                            "plate",
                                            "workspace",
                                            "touchpart",
                                            "smoothblockmodel",
                                            "base",
                                            "checkpoint",
                                            "truss",
                                            "trusspart",
                                            "basepart",
                                            "primary",
                                            "main"};

// Returns true if a reader can find the place by the name.
bool saysSomething(const std::string& name) {
  std::string joined;
  bool hasLetters = false;
  for (const std::string& word : wordsOf(name)) {
    joined += word;
    hasLetters = hasLetters || word.find_first_not_of("0123456789") != std::string::npos;
  }
  return hasLetters &&
         std::find(std::begin(kEmptyNames), std::end(kEmptyNames), joined) == std::end(kEmptyNames);
}

bool isNumber(const std::string& name) {
  return !name.empty() && name.size() <= 9 &&
         name.find_first_not_of("0123456789") == std::string::npos;
}

}  // namespace

PlaceNames::PlaceNames(const LevelDraft& level, const Tree& tree) : level_(level), tree_(tree) {
  const int start = level.spawns.empty() ? -1 : level.spawns[0].part;
  for (int i = 0; i < int(level.parts.size()); ++i) {
    const PartDraft& part = level.parts[size_t(i)];
    if (!part.checkpoint && !part.goal && i != start) continue;
    ++uses_[tree.at(part.id).name];
    const InstanceId parent = tree.at(part.id).parent;
    if (parent != kNoInstance) ++parents_[tree.at(parent).name];
  }
}

std::string PlaceNames::of(int index) const {
  const PartDraft& part = level_.parts[size_t(index)];
  const std::string& name = tree_.at(part.id).name;
  if (saysSomething(name) && uses_.at(name) == 1) return "'" + name + "'";
  if (!level_.spawns.empty() && index == level_.spawns[0].part) return "the start";
  const InstanceId parent = tree_.at(part.id).parent;
  if (parent != kNoInstance && tree_.at(parent).className != "Workspace") {
    const std::string& above = tree_.at(parent).name;
    const bool isShared = parents_.at(above) > 1;
    if (isNumber(above) && !isShared) return "checkpoint " + above;
    if (saysSomething(above) && !isShared) return "'" + above + "'";
  }
  if (part.checkpoint)
    return "checkpoint " + (isNumber(name) ? name : std::to_string(*part.checkpoint));
  return "the goal";
}

}  // namespace obby::importer
