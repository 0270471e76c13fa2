// Ranks of MPI. Only this file uses MPI. An error inside MPI ends all ranks with MPI's own message,
// its default.
#define OMPI_SKIP_MPICXX 1
#include <mpi.h>

#include <algorithm>

#include "train/run/ranks/alone.h"

namespace obby::train {

namespace {

constexpr size_t kMaxMessage = size_t(1) << 30;  // bytes; MPI counts in int
constexpr int kLength = 1, kPiece = 2;           // tags

class MpiRanks : public Ranks {
 public:
  MpiRanks() {
    int number = 0, count = 1;
    MPI_Comm_rank(MPI_COMM_WORLD, &number);
    MPI_Comm_size(MPI_COMM_WORLD, &count);
    number_ = uint32_t(number);
    count_ = uint32_t(count);
  }

  uint32_t number() const override { return number_; }
  uint32_t count() const override { return count_; }

  void exchange(const void* mine, size_t size, void* all) override {
    MPI_Allgather(mine, int(size), MPI_BYTE, all, int(size), MPI_BYTE, MPI_COMM_WORLD);
  }

  std::string share(std::string bytes) override {
    uint64_t size = bytes.size();
    MPI_Bcast(&size, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
    bytes.resize(size);
    for (size_t at = 0; at < size; at += kMaxMessage)
      MPI_Bcast(bytes.data() + at, int(std::min(kMaxMessage, size - at)), MPI_BYTE, 0,
                MPI_COMM_WORLD);
    return bytes;
  }

  std::vector<std::string> collect(std::string bytes) override {
    if (number_ != 0) {
      send(bytes);
      return {};
    }
    std::vector<std::string> all = {std::move(bytes)};
    for (uint32_t from = 1; from < count_; ++from) all.push_back(receive(int(from)));
    return all;
  }

 private:
  static void send(const std::string& bytes) {
    const uint64_t size = bytes.size();
    MPI_Send(&size, 1, MPI_UINT64_T, 0, kLength, MPI_COMM_WORLD);
    for (size_t at = 0; at < size; at += kMaxMessage)
      MPI_Send(bytes.data() + at, int(std::min(kMaxMessage, size - at)), MPI_BYTE, 0, kPiece,
               MPI_COMM_WORLD);
  }
  static std::string receive(int from) {
    uint64_t size = 0;
    MPI_Recv(&size, 1, MPI_UINT64_T, from, kLength, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    std::string bytes(size, '\0');
    for (size_t at = 0; at < size; at += kMaxMessage)
      MPI_Recv(bytes.data() + at, int(std::min(kMaxMessage, size - at)), MPI_BYTE, from, kPiece,
               MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return bytes;
  }

  uint32_t number_ = 0, count_ = 1;
};

class Joined : public JoinedRanks {
 public:
  ~Joined() override { MPI_Finalize(); }
  Ranks& ranks() override { return ranks_; }
  uint32_t neighbour() const override {
    MPI_Comm machine = MPI_COMM_NULL;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
    int number = 0;
    MPI_Comm_rank(machine, &number);
    MPI_Comm_free(&machine);
    return uint32_t(number);
  }
  void abandon(int code) override {
    if (ranks_.count() > 1) MPI_Abort(MPI_COMM_WORLD, code);
  }

 private:
  MpiRanks ranks_;
};

}  // namespace

Result<std::unique_ptr<JoinedRanks>> joinRanks(int* argc, char*** argv) {
  if (!launchedByMpi()) return std::unique_ptr<JoinedRanks>(std::make_unique<Alone>());
  int level = 0;
  // Only the thread that joined calls MPI.
  MPI_Init_thread(argc, argv, MPI_THREAD_FUNNELED, &level);
  if (level < MPI_THREAD_FUNNELED)
    return makeError("this MPI library does not support multithreaded programs");
  return std::unique_ptr<JoinedRanks>(std::make_unique<Joined>());
}

}  // namespace obby::train
