// Towers to climb by the truss on them.
#include "gen/styles/all.h"

namespace obby::gen {

void buildTruss(Sketch& s) {
  constexpr float kDeep = 6, kTruss = 2;
  const uint32_t towers = s.mixCount(1, 2);
  for (uint32_t i = 0; i < towers; ++i) {
    const float width = s.mix(10, 6), foot = s.mix(9, 6);
    const float up = 2 * float(int32_t((s.highLedge(4, 24) + 1) / 2));  // trusses come in twos
    s.floor("Foot", foot, width);
    s.part("Tower", {0, up / 2 - 0.5f, kDeep / 2}, {width, up + 1, kDeep}).colored(colors::kWall);
    const float aside = s.mixEitherSign(0, width / 2 - 2);
    if (!s.broken("truss")) {
      s.part("Truss", {aside, up / 2, -kTruss / 2}, {kTruss, up, kTruss})
          .shaped(schema::Shape::TRUSS)
          .colored(colors::kSteel);
    }
    s.advance(kDeep, up);
    s.expectWait(up * 0.1f);
  }
}

}  // namespace obby::gen
