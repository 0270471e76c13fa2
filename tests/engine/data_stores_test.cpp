// Data stores of an empty, unpublished place.
#include <gtest/gtest.h>

#include "engine/place.h"

namespace obby::test {
namespace {

std::string stored(const std::string& text) {
  return resultOf("local store = game:GetService('DataStoreService'):GetDataStore('Stages')\n" +
                  text);
}

TEST(DataStores, AreEmptyAtFirst) {
  EXPECT_EQ(stored("local result = store:GetAsync('player')"), "nil");
}

TEST(DataStores, KeepStoredValues) {
  EXPECT_EQ(stored("store:SetAsync('player', 3)\nlocal result = store:GetAsync('player')"), "3");
  EXPECT_EQ(stored("store:IncrementAsync('n', 2)\nlocal result = store:IncrementAsync('n')"), "3");
  EXPECT_EQ(
      stored("local result = store:UpdateAsync('n', function(old) return (old or 0) + 5 end)"),
      "5");
  EXPECT_EQ(stored("store:SetAsync('n', 1)\nlocal result = store:RemoveAsync('n')"), "1");
  EXPECT_EQ(stored("store:SetAsync('n', 1)\nstore:RemoveAsync('n')\n"
                   "local result = store:GetAsync('n')"),
            "nil");
}

TEST(DataStores, StoresOfOneNameAreShared) {
  EXPECT_EQ(stored("store:SetAsync('n', 1)\nlocal other = game:GetService('DataStoreService')\n"
                   "local result = other:GetDataStore('Stages'):GetAsync('n')"),
            "1");
  EXPECT_EQ(stored("store:OnUpdate('n', function() end)\nlocal result = "
                   "#game:GetService('DataStoreService'):GetOrderedDataStore('Wins')"
                   ":GetSortedAsync(false, 10):GetCurrentPage()"),
            "0");
}

}  // namespace
}  // namespace obby::test
