// Orders checkpoints by the numbers that count, else by distance.
#include <algorithm>

#include "import/stages/course.h"
#include "import/stages/numbers.h"

namespace obby::importer {
namespace {

// Limits on the number of checkpoints for portals, for best insertion, and for ordering by
// distance. The work is quadratic.
constexpr size_t kMaxWithPortals = 500, kMaxInserted = 1000, kMaxByDistance = 10000;

struct Numbered {
  int number = kUnnumbered;
  int part = -1;
};
using Chain = std::vector<Numbered>;

class Order {
 public:
  explicit Order(Course& course) : course_(course) {
    const std::vector<int> numbers = numbersThatCount(course.level, course.checkpoints);
    for (size_t i = 0; i < numbers.size(); ++i)
      (numbers[i] == kUnnumbered ? unnumbered_ : chain_)
          .push_back({numbers[i], course.checkpoints[i]});
    std::stable_sort(chain_.begin(), chain_.end(),
                     [](const Numbered& a, const Numbered& b) { return a.number < b.number; });
  }

  std::vector<int> checkpoints() {
    settleStart();
    for (auto first = chain_.begin(); first != chain_.end();) {
      const auto end = std::find_if(
          first, chain_.end(), [&](const Numbered& one) { return one.number != first->number; });
      sortByDistance(chain_, first, end, "other checkpoints have the same number");
      first = end;
    }
    if (chain_.empty()) {
      chain_ = unnumbered_;
      sortByDistance(chain_, chain_.begin(), chain_.end(), kNoNumber);
    } else {
      insertUnnumbered();
    }
    std::vector<int> order;
    for (const Numbered& one : chain_) order.push_back(one.part);
    return order;
  }

 private:
  static constexpr const char* kNoNumber = "it has no number";

  void settleStart() {
    const Chain& best = chain_.empty() ? unnumbered_ : chain_;
    if (course_.start < 0 && !best.empty()) {
      course_.start = best.front().part;
      course_.prove(course_.start, "start", "first checkpoint, as there is no SpawnLocation", true);
    }
    const auto isStart = [&](const Numbered& one) { return one.part == course_.start; };
    std::erase_if(chain_, isStart);
    std::erase_if(unnumbered_, isStart);
  }

  void proveDistance(int part, const std::string& why) {
    course_.prove(part, "checkpoint", "ordered by distance: " + why, true);
  }

  // Sorts greedily: the nearest remaining checkpoint always comes next.
  void sortByDistance(Chain& chain, Chain::iterator first, Chain::iterator end,
                      const std::string& why) {
    if (end - first < 2 || chain.size() > kMaxByDistance) return;
    for (; first != end; ++first) {
      const int last = first == chain.begin() ? course_.start : (first - 1)->part;
      std::iter_swap(first, std::min_element(first, end, [&](const Numbered& a, const Numbered& b) {
                       return course_.distance(last, a.part) < course_.distance(last, b.part);
                     }));
      proveDistance(first->part, why);
    }
  }

  // Inserts each checkpoint where it causes the shortest detour.
  void insertUnnumbered() {
    const bool isMany = chain_.size() + unnumbered_.size() > kMaxInserted;
    for (const Numbered& one : unnumbered_) {
      chain_.insert(isMany ? chain_.end() : placeOf(one.part), one);
      proveDistance(one.part, kNoNumber);
    }
  }

  Chain::iterator placeOf(int part) {
    auto best = chain_.end();
    float min = course_.distance(chain_.back().part, part);
    int before = course_.start;
    for (auto at = chain_.begin(); at != chain_.end(); before = at->part, ++at) {
      const float detour = course_.distance(before, part) + course_.distance(part, at->part) -
                           course_.distance(before, at->part);
      if (detour >= min) continue;
      min = detour;
      best = at;
    }
    return best;
  }

  Course& course_;
  Chain chain_, unnumbered_;
};

// Moves the start out of a lobby, a spawn from which no portal leads to the course. Players leave a
// lobby by other means, such as a button on the screen.
void leaveLobby(Course& course) {
  auto& list = course.checkpoints;
  if (list.empty() || course.arrived || !course.isFar(course.distance(course.start, list.front())))
    return;
  course.start = list.front();
  list.erase(list.begin());
  course.prove(course.start, "start", "first checkpoint, as the SpawnLocation is far away", true);
}

}  // namespace

void orderCheckpoints(Course& course) {
  for (int i = 0; i < int(course.level.parts.size()); ++i)
    if (course.part(i).checkpoint) course.checkpoints.push_back(i);
  if (course.checkpoints.size() > kMaxWithPortals) course.portals.clear();
  course.checkpoints = Order(course).checkpoints();
  leaveLobby(course);
}

}  // namespace obby::importer
