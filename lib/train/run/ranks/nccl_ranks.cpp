// Exchanges gradients between GPUs by NCCL. Only this file uses NCCL. The result equals that of the
// exchange through the host: numbers are gathered here, and summed elsewhere in the order of the
// ranks.
#include <fmt/format.h>
#include <nccl.h>

#include <cstring>

#include "train/run/ranks/join_devices.h"

namespace obby::train {

namespace {

Status check(ncclResult_t code, const char* what) {
  if (code == ncclSuccess) return {};
  return makeError(fmt::format("NCCL: {}: {}", what, ncclGetErrorString(code)));
}

class NcclRanks : public DeviceRanks {
 public:
  ~NcclRanks() override {
    if (joined_ != nullptr) ncclCommDestroy(joined_);
  }

  Status join(Ranks& ranks) {
    ncclUniqueId id{};
    OBBY_RETURN_IF_ERROR(
        ranks.agree(ranks.first() ? check(ncclGetUniqueId(&id), "cannot create the group of ranks")
                                  : Status()));
    const std::string bytes = ranks.share(std::string(id.internal, sizeof id.internal));
    std::memcpy(id.internal, bytes.data(), sizeof id.internal);
    return ranks.agree(
        check(ncclCommInitRank(&joined_, int(ranks.count()), id, int(ranks.number())),
              "the ranks' GPUs cannot join the group"));
  }

  // Runs in the same stream as all kernels.
  Status gather(sim::Device&, const float* mine, size_t count, float* all) override {
    return check(ncclAllGather(mine, all, count, ncclFloat, joined_, nullptr),
                 "cannot exchange gradients");
  }

 private:
  ncclComm_t joined_ = nullptr;
};

}  // namespace

Result<std::unique_ptr<DeviceRanks>> joinDevices(Ranks& ranks) {
  if (ranks.count() == 1) return std::unique_ptr<DeviceRanks>();
  auto devices = std::make_unique<NcclRanks>();
  OBBY_RETURN_IF_ERROR(devices->join(ranks));
  return std::unique_ptr<DeviceRanks>(std::move(devices));
}

}  // namespace obby::train
