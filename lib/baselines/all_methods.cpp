#include "baselines/methods.h"
#include "solve/methods.h"

namespace obby::baselines {

std::vector<const solve::Method*> allMethods() {
  std::vector<const solve::Method*> all;
  for (const auto* table : {&solve::methods(), &methods()}) {
    for (const solve::Method& m : *table) all.push_back(&m);
  }
  return all;
}

const solve::Method* findMethod(const std::string& name) {
  for (const solve::Method* m : allMethods()) {
    if (name == m->name) return m;
  }
  return nullptr;
}

}  // namespace obby::baselines
