// Perlin's noise with his own permutation ("Improving Noise", 2002), as in math.noise. Private to
// lib/engine.
#pragma once

namespace obby::engine {

float perlin(float x, float y, float z);

}  // namespace obby::engine
