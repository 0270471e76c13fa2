// Members of classes: the published API, and the signals of tags.
#include <gtest/gtest.h>

#include "engine/place.h"

namespace obby::test {
namespace {

TEST(Classes, HavePropertiesThatScriptsMayOnlyRead) {
  EXPECT_EQ(resultOf("local result = workspace.FallenPartsDestroyHeight\n"), "-500");
  EXPECT_EQ(resultOf("local result = Instance.new('MeshPart').MeshId == ''\n"), "true");
}

TEST(Classes, ATagAnnouncesItsFirstAndItsLastInstance) {
  EXPECT_EQ(
      resultOf("local tags, result = game:GetService('CollectionService'), ''\n"
               "tags.TagAdded:Connect(function(tag) result ..= ' +' .. tag end)\n"
               "tags.TagRemoved:Connect(function(tag) result ..= ' -' .. tag end)\n"
               "tags:GetInstanceAddedSignal('Kill'):Connect(function() result ..= ' part' end)\n"
               "local part, other = Instance.new('Part'), Instance.new('Part', workspace)\n"
               "part:AddTag('Kill')\n"
               "part.Parent = workspace\n"
               "other:AddTag('Kill')\n"
               "part:Destroy()\n"
               "other:RemoveTag('Kill')\n"),
      " part +Kill part -Kill");
}

}  // namespace
}  // namespace obby::test
