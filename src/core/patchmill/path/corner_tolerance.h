// CornerTolerance: how far a machine may round the corner at the end of a move, in three bytes.
// Controls read it with six decimals (G64 P); so it is kept in whole steps of the finest that can be posted, and a Move
// fills one line of the cache, no more.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>

namespace patchmill {

constexpr double kFinestRounding = 1e-6;  ///< G64 P with six decimals [mm]
constexpr double kMachineTolerance =
    std::numeric_limits<double>::quiet_NaN();  ///< as the machine is set

/// A tolerance [mm]: 0, the machine stops at the corner; NaN, it is as the machine is set; else the step of
/// kFinestRounding next to what was given, but never 0, which would be a stop nobody asked for. Beyond 16.77 mm it is
/// that: PathTolerance is 10 mm at most. Read and written like the number that it is.
class CornerTolerance {
 public:
  constexpr CornerTolerance() = default;
  CornerTolerance(double mm) : CornerTolerance(steps_of(mm)) {}
  /// The least step that is not below `mm` (less 1e-12 mm): a tolerance that is needed.
  static CornerTolerance at_least(double mm);
  /// To the bit the decimal number that is posted.
  operator double() const {
    const std::uint32_t steps = bytes_[0] | bytes_[1] << 8 | bytes_[2] << 16;
    if (steps == kAsSet) return kMachineTolerance;
    return steps / kStepsInMm;
  }

 private:
  static constexpr double kStepsInMm = 1e6;
  static constexpr std::uint32_t kAsSet = 0xffffff, kMost = kAsSet - 1;

  explicit CornerTolerance(std::uint32_t steps);
  static std::uint32_t steps_of(double mm);

  std::array<std::uint8_t, 3> bytes_{0xff, 0xff, 0xff};
};

}  // namespace patchmill
