// CUDA entry points of the kernels of a resident search.
#include "sim/cuda/launch.h"
#include "solve/search/cuda/cuda.h"
#include "solve/search/resident/kernels.h"
#include "solve/search/resident/steps.h"

namespace obby::solve::cuda {
using sim::cuda::entry;

const void* residentEntry(ResidentStep step) {
  using A = ResidentArguments;
  switch (step) {
    case ResidentStep::weigh: return entry<A, weighCells>();
    case ResidentStep::countRanks: return entry<A, countRanks>();
    case ResidentStep::sumRanks: return entry<A, sumRanks>();
    case ResidentStep::markBest: return entry<A, markBest>();
    case ResidentStep::choose: return entry<A, chooseStart>();
    case ResidentStep::explore: return entry<A, exploreFrom<false>>();
    case ResidentStep::exploreDynamic: return entry<A, exploreFrom<true>>();
    case ResidentStep::takePlayed: return entry<A, takePlayed>();
    case ResidentStep::claim: return entry<A, claimCells>();
    case ResidentStep::settle: return entry<A, settleClaims>();
    case ResidentStep::count: return entry<A, countFinds>();
    case ResidentStep::sumFinds: return entry<A, sumFinds>();
    case ResidentStep::place: return entry<A, placeFinds>();
    case ResidentStep::sum: return entry<SumArguments, sumOne>();
    case ResidentStep::rehash: break;
  }
  return entry<RehashArguments, rehash>();
}

}  // namespace obby::solve::cuda
