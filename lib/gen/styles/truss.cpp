// Towers to climb on a truss.
#include "gen/styles/all.h"

namespace obby::gen {

namespace {

constexpr Parameter kParameters[] = {
    {"towers", "", 1, 2, 1, 6, "number of towers"},
    {"width", "studs", 10, 6, 4, 30, "width of a tower"},
    {"foot", "studs", 9, 6, 4, 30, "length of the floor before a tower"},
    {"height", "studs", 4, 24, 4, 80, "how far a tower is above the highest jump; even numbers"},
};
const auto& [kTowers, kWidth, kFoot, kHeight] = kParameters;

void build(Sketch& s) {
  constexpr float kDeep = 6, kTruss = 2;
  const uint32_t towers = s.mixCount(kTowers);
  for (uint32_t i = 0; i < towers; ++i) {
    const float width = s.mix(kWidth), foot = s.mix(kFoot);
    const float up = 2 * float(int32_t((s.highLedge(kHeight) + 1) / 2));  // multiple of 2 studs
    s.floor("Foot", foot, width);
    s.part("Tower", {0, up / 2 - 0.5f, kDeep / 2}, {width, up + 1, kDeep}).colored(colors::kWall);
    const float aside = s.mixEitherSign(0, width / 2 - 2);
    if (!s.broken("truss")) {
      s.part("Truss", {aside, up / 2, -kTruss / 2}, {kTruss, up, kTruss})
          .shaped(schema::Shape::TRUSS)
          .colored(colors::kSteel);
    }
    s.via({aside, 0, -kTruss});
    s.via({aside, up, -kTruss});
    s.advance(kDeep, up);
    s.expectWait(up * 0.1f);
  }
}

}  // namespace

constinit const Style kTrussStyle{.name = "truss",
                                  .description = "towers to climb on a truss",
                                  .build = build,
                                  .parameters = kParameters};

}  // namespace obby::gen
