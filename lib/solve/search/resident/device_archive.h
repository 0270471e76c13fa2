// Memory of the archive of a resident search. It doubles when it is full, and its contents do not
// depend on when it does.
#pragma once

#include "sim/device.h"
#include "solve/model/problem.h"
#include "solve/search/resident/archive_view.h"
#include "solve/search/resident/sum_tree.h"

namespace obby::solve {

class DeviceArchive {
 public:
  DeviceArchive(sim::Device& device, uint32_t bodyCount);

  // Makes the start of the problem the first cell, node 0.
  Status addStart(const Problem& problem, uint64_t key, float potential, uint32_t wait);

  // Grows to a capacity of at least `cells` cells.
  Status grow(uint32_t cells);
  // Sets the number of cells that the kernels have made.
  void setCellCount(uint32_t cells) { view_.cellCount = cells; }

  const ArchiveView& view() const { return view_; }
  // Return sum trees over the cells. The leaves of weights() are their weights; those of
  // bestCells() are 1 for cells in the beam.
  SumTree weights() const { return makeSumTree(sums_.as<uint64_t>(), view_.cellCount); }
  SumTree bestCells() const { return makeSumTree(bestSums_.as<uint64_t>(), view_.cellCount); }

 private:
  template <class T>
  Status widen(sim::Memory& memory, T*& table, size_t count);
  Status growTable(uint32_t slots);

  sim::Device* device_;
  ArchiveView view_{};
  uint32_t capacity_ = 0;  // cells
  sim::Memory slots_, worlds_, bodies_, ranks_, nodes_, seen_, sighted_, waits_, potentials_, sums_,
      bestSums_;
};

}  // namespace obby::solve
