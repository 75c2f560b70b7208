// The innermost loop of the cutter-mark simulator. One tooth pass, one row of cells: for each cell,
// find the moment at which the flute's edge is over it while tool and spindle move, and lower the
// cell to the edge if it is deeper than what is there.
//
// With delta the angle that the spindle has turned since the middle of the pass, the ball centre c,
// the tool axis t and the housing directions are functions of delta. The line through the cell's
// base point p along its normal n meets the ball from below at d(delta) = x - c, |d| = R. The edge
// is there when
//     r(delta) = delta - atan2(d.b, d.a) - k (d.t - z0) = 0,
// a(delta) the direction of the flute in the middle of the pass, b = s t x a the way it turns, k
// the lag of a helical edge per height. Newton's method on r; r' is exact, so it converges
// quadratically.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

namespace patchmill::marks {

/// Cells are treated in chunks of this many.
constexpr int kLanes = 16;

/// A change of velocity (and of the rate at which the housing turns) at `at`: counted from the
/// middle of the pass outwards, forward for at > 0, backward else.
struct PassKink {
  float at = 0.0f;  ///< delta [rad]
  float velocity[3] = {}, a[3] = {}, b[3] = {}, t[3] = {};
};

/// One tooth pass. Vectors are relative to the ball centre in the middle of the pass; in the frame
/// (x axis, y axis, normal) of the plane for mill_flat, in the work frame for mill_curved.
struct PassFrame {
  float radius = 0.0f;                    ///< of the edge, runout included [mm]
  float centre_height = 0.0f;             ///< of the ball centre over the plane, mill_flat only
  float velocity[3] = {};                 ///< of the ball centre [mm/rad]
  float a[3] = {}, b[3] = {}, t[3] = {};  ///< see above; unit at delta = 0
  float a_rate[3] = {}, b_rate[3] = {}, t_rate[3] = {};  ///< [1/rad]
  bool turning = false;                                  ///< whether any of the rates is not zero
  float helix_rate = 0.0f;                               ///< k = tan(helix) / R [rad/mm]
  float helix_height = 0.0f;                             ///< z0 [mm]
  float guess = 0.0f,
        guess_gradient[3] = {};   ///< first delta at base point p - c: guess + gradient . p
  float low = 0.0f, high = 0.0f;  ///< the pass is low <= delta < high
  float search_step = 0.1f;       ///< of delta when looking for all crossings [rad]
  std::vector<PassKink> kinks;
};

/// Base of a row of cells on a curved surface, structure of arrays; positions as in PassFrame but
/// for a shift, normals unit.
struct CurvedRow {
  const float *x, *y, *z, *nx, *ny, *nz;
};

/// Instruction sets that the kernel is compiled for; all give the same bits.
enum class InstructionSet { Any, V3, V4 };

/// The best one that this processor has.
InstructionSet best_instruction_set();

/// Kernels for an instruction set, or for the best that the processor has below it.
///
/// mill lowers height[0 .. kLanes * chunks), finding one moment per cell and pass by Newton's
/// method. That is the only one but for cells so near to the tool axis that the feed carries them
/// round it as fast as the spindle turns. These are looked at again by search, which finds all
/// their moments, and leaves the other cells as they are; best after all passes have been milled,
/// since it is slow and does not look at cells that are already deeper than the pass can reach.
struct FluteKernel {
  /// Cells at (x + i step, y) over the plane.
  void (*flat)(bool search, const PassFrame& pass, float x, float y, float step, int chunks,
               float* height);
  /// Base points row + shift with their own normals. NaN bases stay as they are.
  void (*curved)(bool search, const PassFrame& pass, const CurvedRow& row, const float shift[3],
                 int chunks, float* height);
};
FluteKernel flute_kernel(InstructionSet set);

}  // namespace patchmill::marks
