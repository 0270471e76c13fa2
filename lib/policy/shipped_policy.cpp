#include "policy/shipped_policy.h"

#include "base/check.h"

namespace obby::policy {

extern const unsigned char kShippedPolicy[];  // generated from policies/default.obp
extern const size_t kShippedPolicySize;

namespace {

PolicyFile read() {
  const std::string_view bytes(reinterpret_cast<const char*>(kShippedPolicy), kShippedPolicySize);
  auto file = readPolicy(bytes, "the built-in policy");
  OBBY_CHECK_EQ(bool(file), true);  // a test has read the file
  return *std::move(file);
}

}  // namespace

const PolicyFile& shippedPolicy() {
  static const PolicyFile file = read();
  return file;
}

}  // namespace obby::policy
