// The engine's frame.
#pragma once

namespace obby::importer {

// Seconds: scripts go on, and poses that they set are seen, no more often.
constexpr double kFrame = 1.0 / 60;

}  // namespace obby::importer
