// Measures the value of training on episodes that begin at restart states. Compares restarts in no
// level, only in levels not yet solved from the start, and in all levels.
#include "common/learning.h"

namespace {

using namespace obby;

bench::LearningRow shares(const char* name, float unsolved, float solved) {
  return {name, [=](train::TrainerSettings& settings) {
            settings.envGroup.restarts = {unsolved, solved};
          }};
}

}  // namespace

int main(int argc, char** argv) {
  return bench::learningBench(
      argc, argv, "restarts",
      {shares("none", 0, 0), shares("all30", 0.3f, 0.3f), shares("all60", 0.6f, 0.6f),
       shares("unsolved30", 0.3f, 0), shares("unsolved60", 0.6f, 0),
       shares("mostlyUnsolved", 0.6f, 0.15f)});
}
