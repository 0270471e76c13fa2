// Chooses the side from which a picture shows a query.
#pragma once

#include <optional>
#include <vector>

#include "view/picture/camera.h"
#include "view/picture/canvas.h"
#include "view/report.h"

namespace obby::view {

// The places that a picture must show.
struct Subject {
  std::vector<Vec3> frame;       // points to frame; not empty
  std::vector<Vec3> seen;        // points that must not be hidden; start and goal count more
  std::optional<Vec3> from, to;  // the query's start and its first goal
};

// `query` may be null: then the subject is the level.
Subject subjectOf(const LevelEntry& level, const QueryEntry* query);

// Returns the direction of the camera that hides least of the subject, fills the picture well, and
// reads from left to right. An orthographic camera sees everything before the subject.
// web/src/scene/view_choice.js does the same for the page.
Vec3 bestLook(const Subject& subject, const std::vector<Solid>& solids, int width, int height,
              bool perspective = true);

}  // namespace obby::view
