// Live digital copy milling: the path is made while the tool cuts. Kobayashi & Shirase 2014, section 2: path
// and conditions are given "successively during milling", so both may change at any time and the tool goes on
// from where it is.
//
// Scanning lines only. What is left of the stock is kept as its height over y, a step function: a line at y is
// cut one axial depth below the highest material since the line before it. So the axial depth may change in the
// middle of a line and the radial depth in the middle of a layer, and nothing is cut deeper at a time than the
// axial depth that holds then.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/copy/copy_milling.h"
#include "patchmill/dcm/apply_dcm.h"
#include "patchmill/dcm/materials.h"

#include <deque>
#include <map>
#include <vector>

namespace patchmill::copy {

/// What may be changed while the tool cuts.
struct LiveConditions {
  double radial_depth = 0.0;  ///< [mm], > 0
  double axial_depth = 0.0;   ///< [mm], > 0
  dcm::FeedLimits feed;       ///< V_Lo, V_Hi [mm/s]
};

/// Copy milling made in batches while the tool cuts.
class LiveSession {
 public:
  /// `part` and `grid` must live as long as the session. The mode of `options` must be Scanning; its depths
  /// are the first conditions. `factors` hold for all feed limits that are given. Errors: InputError as
  /// copy_mill, steady_feed and scale_feed, or naming the mode.
  LiveSession(const mesh::TriangleBvh& part, const voxel::VoxelGrid& grid,
              const CopyOptions& options, const dcm::FeedLimits& feed,
              const dcm::DcmOptions& dcm = {}, dcm::FeedFactors factors = {});

  /// The next moves: a path of at most `seconds` [s, > 0] of timed moves from where the last one ended;
  /// without moves once all is cut. No more than one base move is planned beyond it.
  ToolPath next(double seconds);

  /// Conditions from the next batch on: feed and axial depth at once, the radial depth from the next line on.
  /// Errors: InputError naming the condition that is out of range; then all stay as they were.
  void change(const LiveConditions& conditions);

  /// Those in force.
  const LiveConditions& conditions() const { return conditions_; }
  /// Whether all is cut.
  bool done() const { return done_; }
  double line() const { return y_; }       ///< y of the present line [mm]
  double level() const { return level_; }  ///< that the ball centre is cut down to in it [mm]

 private:
  struct Step {
    Vec3 centre;
    MoveKind kind;
  };
  bool plan_line();
  void plan_runs(const std::vector<Vec2>& profile, bool go_on);
  void replan_line();
  dcm::FeedField field_of(const dcm::FeedLimits& limits) const;
  double material(double y_from, double y_to) const;
  void set_material(double y_from, double y_to, double height);

  const mesh::TriangleBvh& part_;
  const voxel::VoxelGrid& grid_;
  CopyOptions options_;
  dcm::DcmOptions dcm_;
  dcm::FeedFactors factors_;
  double slowest_ = 1.0;  // least factor on the feed
  LiveConditions conditions_;
  dcm::FeedField feed_;
  std::map<double, double> height_;  // from this y on, up to the next key: of the ball centre [mm]
  std::vector<Vec2> profile_;        // of the present line, in the sense of cutting
  std::deque<Step> steps_;
  Vec3 at_;  // ball centre
  double y_ = 0.0, y_before_ = 0.0, above_ = 0.0, level_ = 0.0;
  bool first_in_layer_ = true, backwards_ = false, done_ = false;
};

}  // namespace patchmill::copy
