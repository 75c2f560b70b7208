// Tool axes for dimples. Matsuda 2008, section 2.1 asks to incline the tool, for the tip does not
// cut; Xu & Sasahara 2016 keep one fixed axis. Modes:
//     Fixed        one axis for all: three axes, or 3 + 2
//     Normal       t ~ n + tan(lead) f + tan(tilt) (n x f), f the feed or a fixed direction on the surface
//     MinimumLead  a fixed axis, but leaned away from the normal where it is nearer than the least lead
//     Field        axes given one by one, such as a posture field's (Kobayashi 2014), leaned away likewise
// No rule can both keep a fixed axis wherever that is far enough from the normal and be continuous
// where the normal passes it (there is no retraction of a disc on its rim): MinimumLead jumps there,
// by twice the least lead. Smoothing draws the axes of neighbours together within a tolerance.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/angle.h"
#include "patchmill/patch/dimple.h"

#include <vector>

namespace patchmill::sync {

enum class ToolAxisMode : std::uint8_t { Fixed, Normal, MinimumLead, Field };

/// How tool axes are chosen.
struct ToolAxisRule {
  ToolAxisMode mode = ToolAxisMode::Fixed;
  Vec3 axis = Vec3::UnitZ();  ///< Fixed, MinimumLead: from tip to holder, work frame; any length
  Angle lead, tilt;           ///< Normal: -80 .. 80 degrees
  Angle least_lead;  ///< MinimumLead, Field: least angle of axis and normal, 0 .. 80 degrees
  /// Normal: projected on the surface it is what `lead` leans towards; zero: the feed. Others:
  /// leaned towards where normal and axis are parallel; zero: X.
  Vec3 towards = Vec3::Zero();
  std::vector<Vec3> field;  ///< Field: any length, one for each dimple; read where it is to be cut
  Angle smoothing;          ///< an axis may be drawn towards its neighbours' by this; 0: none
  Angle widest = Angle::degrees(180.0);  ///< from the work's Z: axes further off are drawn back
};

/// One unit axis for each dimple, in their order; Z where a dimple is left out. Axes are smoothed
/// along each patch, in milling order. Errors: InputError naming ToolAxisMode, Lead, Tilt, MinimumLead,
/// AxisSmoothing, WidestTilt, FixedAxis (zero, not finite), LeanTowards (not finite) or PostureField (a wrong
/// number of axes, one that is zero or not finite).
std::vector<Vec3> tool_axes(const patch::Dimples& dimples, const ToolAxisRule& rule);

/// Axes that stay the same along each straight row of a patch, as spindle-locked paths need them: from the
/// mean of the row's as far towards the axis of the row before as none of its dimples is off by more than
/// half of `tolerance`, or than it is from the mean. So the machine turns less between rows, or not at all. A
/// row is cut in two where one of its axes would be further than `tolerance` from the mean. Errors: InputError
/// naming RowTolerance if it is not in 0 .. 45 degrees, or ToolAxis as require_axes.
std::vector<Vec3> axes_by_row(const patch::Dimples& dimples, const std::vector<Vec3>& axes,
                              Angle tolerance);

/// `axes`: one for each dimple, read where it is to be cut. Errors: InputError naming ToolAxis if their number is
/// another, or one that is read is zero or not finite.
void require_axes(const patch::Dimples& dimples, const std::vector<Vec3>& axes);

/// As mark_tool_tip of contact_azimuth.h with an axis for each dimple. Errors: also as require_axes.
void mark_tool_tip(patch::Dimples& dimples, const std::vector<Vec3>& axes, Angle least_tilt);

}  // namespace patchmill::sync
