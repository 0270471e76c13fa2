#include "train/guide.h"

namespace obby::train {

Guide::Guide(std::vector<Vec3> places) : places_(std::move(places)), behind_(places_.size(), 0) {
  for (size_t i = places_.size() - 1; i-- > 0;) {
    behind_[i] = behind_[i + 1] + length(places_[i + 1] - places_[i]);
  }
}

}  // namespace obby::train
