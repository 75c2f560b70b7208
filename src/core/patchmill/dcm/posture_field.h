// Posture over the removal volume. Kobayashi & Shirase 2014, section 3.3, Eq. (5): the angle theta
// about x and phi about y are given by the normal of the product surface in surface voxels, limited
// to
// +-70 degrees, zero in exterior voxels, and diffused in three dimensions; here solved to the
// steady state (laplace_solver.h).
//
// The paper gives no order of the two rotations. They are read as the angles of the axis'
// projections: t is parallel to (tan phi, -tan theta, 1). The limit is applied so that the
// direction of the tilt seen from above is kept: (tan phi, tan theta) is scaled down until the
// larger angle is at the limit; limiting each angle by itself would turn the tool by up to 45
// degrees about z, and for a normal that points down (nz < 0) the sign of a vanishing component
// would decide between -70 and +70 degrees.
//
// Option: the unit vector itself is diffused, component by component, and normalised when it is
// read.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/dcm/feed_field.h"
#include "patchmill/mesh/triangle_bvh.h"
#include "patchmill/voxel/laplace_solver.h"

#include <vector>

namespace patchmill::dcm {

enum class PostureForm {
  Angles,     ///< theta and phi (the paper)
  UnitVector  ///< the three components of the axis
};

/// How a posture field is made.
struct PostureOptions {
  PostureForm form = PostureForm::Angles;
  ExteriorRule exterior = ExteriorRule::Held;
  Angle limit = Angle::degrees(70);  ///< of theta and of phi, 0.1 .. 89 degrees
  Angle crease =
      Angle::degrees(30);  ///< normals are smoothed over edges flatter than this, 0 .. 180
  voxel::LaplaceOptions solver;
};

/// Tool axes over a voxel grid.
struct PostureField {
  PostureForm form = PostureForm::Angles;
  /// theta, phi [rad]; or the components of the axis. 0 where there is no removal.
  std::vector<std::vector<float>> value;
  voxel::LaplaceOutcome outcome;
};

/// The two angles of a tool axis.
struct PostureAngles {
  Angle theta, phi;
};

/// Angles of the projections of `n` (need not be unit), limited as described above. A vector
/// straight up or straight down has both angles zero. `limit` in (0, 90) degrees.
PostureAngles posture_angles(const Vec3& n, Angle limit);

/// Unit axis, from tip to holder, with these angles. |theta|, |phi| < 90 degrees.
Vec3 posture_axis(const PostureAngles& angles);

/// Unit normal of the part for every surface voxel (zero elsewhere): at the point of the mesh
/// nearest to the voxel's centre, interpolated between the corners (corner_normals).
std::vector<Vec3> surface_normals(const voxel::VoxelGrid& grid, const mesh::TriangleMesh& part,
                                  const mesh::TriangleBvh& bvh, Angle crease);

/// The steady posture. `part` is closed, `bvh` over it. If `progress` asks for a stop, or the solver does not
/// converge, `outcome` says so and the axes are the last ones. Errors: InputError for an option out of range.
PostureField steady_posture(const voxel::VoxelGrid& grid, const mesh::TriangleMesh& part,
                            const mesh::TriangleBvh& bvh, const PostureOptions& options = {},
                            const Progress& progress = {});

}  // namespace patchmill::dcm
