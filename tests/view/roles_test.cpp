// Tests the roles of parts for the player.
#include "view/roles.h"

#include <gmock/gmock.h>

#include "course.h"

namespace obby::view_test {
namespace {

TEST(Roles, TheMostSevereRoleWinsAndTheStartIsUnderTheSpawn) {
  const io::Record level = recordOf(kLevel);
  EXPECT_THAT(view::rolesOf(level.reader().getLevel()),
              ::testing::ElementsAre(view::Role::start, view::Role::kill, view::Role::moving,
                                     view::Role::moving, view::Role::plain));
}

// A part that falls when touched is away for a while, so it has the role of vanishing parts. A part
// that nothing can touch keeps its role.
TEST(Roles, HealingPartsDoNotKillAndFallingPartsVanish) {
  const io::Record level = recordOf(
      R"({"type":"level","name":"L","parts":[{"kill":{"damage":20}},{"kill":{"damage":-60}},)"
      R"({"solid":false,"kill":{"damage":-60}},{"fall":{}},{"touch":false,"fall":{}}]})");
  EXPECT_THAT(view::rolesOf(level.reader().getLevel()),
              ::testing::ElementsAre(view::Role::kill, view::Role::plain, view::Role::ghost,
                                     view::Role::vanish, view::Role::plain));
}

}  // namespace
}  // namespace obby::view_test
