// Where on the ball a dimple is cut. A flute makes the dimple when its azimuth about the tool axis
// is that of the contact point, which is the direction of -n seen along the axis (Xu & Sasahara
// 2016, section 3.1, Fig. 4).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/angle.h"
#include "patchmill/patch/dimple.h"

namespace patchmill::sync {

/// Angle between the surface normal and the tool axis, both unit vectors: 0 .. pi. Accurate at 0.
Angle tilt(const Vec3& normal, const Vec3& axis);

/// alpha = atan2(-n'_y, -n'_x), n' the unit normal in the spindle housing's frame (e_z = tool
/// axis). For a fixed vertical tool that frame is the work frame. Undefined where n is parallel to
/// the axis: leave such dimples out first (mark_tool_tip).
Angle contact_azimuth(const Vec3& normal_in_housing);

/// What becomes of a dimple whose normal has this tilt to the tool axis: Cut, ToolTip below `least_tilt`, or Undercut
/// from 90 degrees on.
patch::DimpleState state_of_tilt(Angle tilt, Angle least_tilt);

/// Sets state ToolTip on every Cut dimple whose normal is nearer to the axis than `least_tilt` (Matsuda 2008,
/// section 2.1: incline the tool, avoid machining with the tip), and Undercut where the face looks away from the
/// tool: a tilt of 90 degrees and more, where only the upper half of the ball could touch. Errors: InputError
/// naming MinimumTilt if `least_tilt` is not in 1e-6 .. 89 degrees (0 would accept n || t), or ToolAxis if
/// `axis`, which need not be unit, is zero or not finite.
void mark_tool_tip(patch::Dimples& dimples, const Vec3& axis, Angle least_tilt);

}  // namespace patchmill::sync
