#include "calibrate/search.h"

#include "calibrate/cma_es.h"

namespace obby::calibrate {

namespace {

constexpr double kWide = 0.25;             // deviation of a first generation in pass 0, in shares
constexpr double kNarrow[] = {0.1, 0.03};  // the same in later passes, which start from a result
constexpr double kResting = 1e-5;          // deviation at which a search has converged
constexpr uint32_t kLooks = 10;            // generations between checks of the tolerance
constexpr double kUnfit = 1e300;           // loss of points that were not evaluated

// The searches of one pass, one after another.
class Searcher {
 public:
  Searcher(const Objective& objective, Found& found, const FitSettings& settings, const Work& work)
      : objective_(objective),
        found_(found),
        settings_(settings),
        work_(work),
        best_(found.in(objective)),
        loss_(objective.loss(best_)) {}

  const std::vector<double>& best() const { return best_; }

  // Runs one search. Earlier searches ran `before` of `all` generations. Returns true once the
  // result is within the tolerance.
  bool descend(CmaEs method, size_t before, size_t all) {
    for (uint32_t g = 0; g < settings_.generations; ++g) {
      if (method.spread() < kResting || loss_ < kNoLoss) break;
      const std::vector<double> losses = lossesOf(method.ask());
      if (work_.stopped()) break;
      method.tell(losses);
      work_.account().found(loss_);
      work_.account().step(before + g + 1, all);
      if ((g + 1) % kLooks != 0) continue;
      found_.take(objective_, best_);
      if (within(found_, objective_.takes(), settings_)) return true;
    }
    return false;
  }

 private:
  std::vector<double> lossesOf(const std::vector<std::vector<double>>& points) {
    std::vector<double> losses(points.size(), kUnfit);
    work_.run(int(points.size()), [&](int i) {
      losses[size_t(i)] = objective_.loss(points[size_t(i)]);
      work_.account().count(1);
    });
    for (size_t i = 0; i < points.size(); ++i) {
      if (!(losses[i] < loss_)) continue;
      loss_ = losses[i];
      best_ = points[i];
    }
    return losses;
  }

  const Objective& objective_;
  Found& found_;
  const FitSettings& settings_;
  const Work& work_;
  std::vector<double> best_;
  double loss_;
};

}  // namespace

void search(const Objective& objective, Found& found, int pass, const FitSettings& settings,
            const Work& work, Stretch stretch) {
  work.account().enter("searching", stretch);
  Searcher searcher(objective, found, settings, work);
  const uint32_t restarts = pass == 0 ? settings.restarts : 1;
  for (uint32_t r = 0; r < restarts && !work.stopped(); ++r) {
    std::vector<double> mean = searcher.best();
    const uint64_t stream = 2 * (r + uint64_t(pass) * settings.restarts);
    Random random(settings.seed, stream);
    if (r > 0)
      for (double& share : mean) share = 0.2 + 0.6 * double(random.unit());
    CmaEs method(mean, pass == 0 ? kWide : kNarrow[pass % 2], settings.population, settings.seed,
                 stream + 1);
    const size_t generations = settings.generations;
    if (searcher.descend(std::move(method), r * generations, restarts * generations)) break;
  }
  found.take(objective, searcher.best());
}

bool within(const Found& found, std::span<const Take> all, const FitSettings& settings) {
  if (settings.tolerance <= 0) return false;
  const auto takes = settings.heldOut.empty() ? all : settings.heldOut;
  double sum = 0;
  for (const Take& take : takes) {
    const auto path = pathOf(take, found.params(), found.delay);
    if (!path) return false;
    sum += missOf(*path).mean;
    if (sum > settings.tolerance * double(takes.size())) return false;
  }
  return true;
}

}  // namespace obby::calibrate
