#include "train/run/start_policy.h"

#include <fmt/format.h>

#include <utility>

#include "base/hash.h"
#include "io/read_file.h"
#include "policy/policy_file.h"

namespace obby::train {

Result<std::optional<StartPolicy>> readStartPolicy(const std::string& path, Ranks& ranks,
                                                   const std::atomic<bool>& stop) {
  if (path.empty()) return std::optional<StartPolicy>();
  OBBY_ASSIGN(std::string bytes, ranks.agree(ranks.first() ? io::readFile(path, &stop)
                                                           : Result<std::string>(std::string())));
  bytes = ranks.share(std::move(bytes));
  OBBY_ASSIGN(const policy::PolicyFile file, ranks.agree(policy::readPolicy(bytes, path)));
  auto start = startFrom(file);
  if (!start) start.error().input = path;
  OBBY_ASSIGN(Start begun, ranks.agree(std::move(start)));
  const uint64_t hash = hashBytes(bytes.data(), bytes.size());
  return std::optional(
      StartPolicy{std::move(begun), fmt::format("a policy of hash {:016x}", hash)});
}

}  // namespace obby::train
