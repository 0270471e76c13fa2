#include "calibrate/mass_centre.h"

namespace obby::calibrate {

Vec3 MassCentre::at(Turns yaw) const {
  const Vec3 front = directionOf(sinCos(yaw));
  return front * ahead + rightOf(front) * right;
}

}  // namespace obby::calibrate
