// Converts colours between three numbers from 0 to 1 and one packed number.
#pragma once

#include <cstdint>

#include "engine/document.h"

namespace obby {

// Clamps components to 0..1; NaN counts as 0.
inline ColorRgb colorFromUnit(float r, float g, float b) {
  const auto byte = [](float v) {
    return v > 0 ? static_cast<uint8_t>((v < 1 ? v : 1.0f) * 255.0f + 0.5f) : uint8_t{0};
  };
  return {byte(r), byte(g), byte(b)};
}

// Unpacks 0xRRGGBB and ignores a top byte (0xFF, alpha).
inline ColorRgb colorFromPacked(uint32_t packed) {
  return {static_cast<uint8_t>(packed >> 16), static_cast<uint8_t>(packed >> 8),
          static_cast<uint8_t>(packed)};
}

// Packs a colour as 0x00RRGGBB.
inline uint32_t packedFrom(ColorRgb color) {
  return uint32_t{color.r} << 16 | uint32_t{color.g} << 8 | uint32_t{color.b};
}

}  // namespace obby
