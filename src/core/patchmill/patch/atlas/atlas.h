// Atlas: a set of faces as charts in the plane, next to one another so that a lattice in the plane runs on from
// chart to chart where it can. A face that bends too much for one chart is divided, at the middle of its longer
// direction, until all parts fit. Where charts do not follow from one another they go into windows of their
// own: planes that are counted apart.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/angle.h"
#include "patchmill/patch/atlas/chart.h"

namespace patchmill::patch {

/// A chart and where it lies in the plane of its window.
struct PlacedChart {
  Chart chart;
  int face = 0;    ///< number in the FaceSet
  int window = 0;  ///< 0: that of the chart that all begins with
  double cosine = 1.0, sine = 0.0;
  Vec2 shift = Vec2::Zero();

  /// From the chart's own plane to that of its window [mm].
  Vec2 to_plane(const Vec2& own) const {
    return Vec2(cosine * own.x() - sine * own.y(), sine * own.x() + cosine * own.y()) + shift;
  }
  /// The way back [mm].
  Vec2 to_own(const Vec2& plane) const {
    const Vec2 p = plane - shift;
    return {cosine * p.x() + sine * p.y(), cosine * p.y() - sine * p.x()};
  }
};

/// Where the lattice begins: a point of a face, or nothing for the middle of the largest chart.
struct AtlasStart {
  std::optional<std::pair<int, Vec2>> at;  ///< number of the face and parameters
  Angle rotation;  ///< of the lattice against the face's lines of constant v, seen from outside
};

/// Charts that cover a set of faces.
struct Atlas {
  std::vector<PlacedChart>
      charts;         ///< in the order in which they were joined; the start is in the first
  double area = 0.0;  ///< of all faces, inside their trimming [mm²]
  int windows = 1;
};

/// The start's place is the origin of window 0. `spacing` [mm] is that of the dimples; parts that are worth only
/// a few of them are not divided. Nothing if `progress` asks to stop.
/// Errors: InputError naming Base if no face has any area inside its trimming.
std::optional<Atlas> make_atlas(const FaceSet& set, double spacing, const AtlasStart& start,
                                const Progress& progress = {});

}  // namespace patchmill::patch
