#include "solve/search/resident/steps.h"

#include "solve/search/cuda/cuda.h"
#include "solve/search/resident/kernels.h"

namespace obby::solve {

namespace {

template <class Arguments, void (*kFunction)(const Arguments&, uint32_t)>
sim::Kernel kernel(const char* name, ResidentStep step) {
  return sim::makeKernel<Arguments, kFunction>(name, cuda::residentEntry(step));
}

template <void (*kFunction)(const ResidentArguments&, uint32_t)>
sim::Kernel roundKernel(const char* name, ResidentStep step) {
  return kernel<ResidentArguments, kFunction>(name, step);
}

}  // namespace

const sim::Kernel& residentKernel(ResidentStep step) {
  using enum ResidentStep;
  static const sim::Kernel kernels[] = {
      // in the order of ResidentStep
      roundKernel<weighCells>("residentWeigh", weigh),
      roundKernel<solve::countRanks>("residentCountRanks", countRanks),
      roundKernel<solve::sumRanks>("residentSumRanks", sumRanks),
      roundKernel<solve::markBest>("residentMarkBest", markBest),
      roundKernel<chooseStart>("residentChoose", choose),
      roundKernel<exploreFrom<false>>("residentExplore", explore),
      roundKernel<exploreFrom<true>>("residentExploreLoose", exploreDynamic),
      roundKernel<solve::takePlayed>("residentTakePlayed", takePlayed),
      roundKernel<claimCells>("residentClaim", claim),
      roundKernel<settleClaims>("residentSettle", settle),
      roundKernel<countFinds>("residentCount", count),
      roundKernel<solve::sumFinds>("residentSumFinds", sumFinds),
      roundKernel<placeFinds>("residentPlace", place),
      kernel<SumArguments, sumOne>("residentSum", sum),
      kernel<RehashArguments, solve::rehash>("residentRehash", rehash)};
  return kernels[size_t(step)];
}

}  // namespace obby::solve
