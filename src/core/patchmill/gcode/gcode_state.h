// What the words of a G-code program mean, block by block: the modal state of a controller, and what one block
// adds to it. Where the moves go is gcode_reader.cpp's affair.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/gcode/gcode_motion.h"
#include "patchmill/gcode/gcode_reader.h"

#include <cmath>

namespace patchmill::gcode {

enum class FeedMode : std::uint8_t { PerMinute, InverseTime };
enum class MotionMode : std::uint8_t { None, Rapid, Feed, Synchronised, Clockwise, Counter, Cycle };

/// What is in force from block to block.
struct GcodeState {
  MotionMode motion = MotionMode::None;
  FeedMode mode = FeedMode::PerMinute;
  ArcPlane plane = ArcPlane::XY;
  double unit = 1.0;           ///< mm per programmed unit
  double feed = 0.0;           ///< as programmed, times unit in G94; 0: none has been given
  double speed = 0.0;          ///< S [rev/s]
  double running_speed = 0.0;  ///< of the spindle as it turns [rev/s]
  SpindleSense sense = SpindleSense::M3;
  int tool_number = 0, selected_tool = 0;  ///< T selects, M6 puts it in
  std::string offset;                      ///< work offset; "" while none was named
  Vec3 at = Vec3::Zero();                  ///< programmed point [mm]
  bool known[3] = {false, false, false};
  std::array<double, 3> angles{};  ///< A B C [degrees]
  bool tcp = false;
  bool relative = false;         ///< G91
  bool absolute_centre = false;  ///< I J K are the centre's place
  Vec3 pole = Vec3::Zero();      ///< centre that arcs without one take [mm]
  bool pole_known = false;
  DrillingCycle cycle;                               ///< heights in mm, as far as they were given
  bool cycle_bottom = false, cycle_retract = false;  ///< whether they were
  /// Whether X, Y and Z have all been given.
  bool known_position() const { return known[0] && known[1] && known[2]; }
};

/// What a block gives beside the state; NaN: it does not.
struct GcodeBlock {
  std::string_view text;
  long number = 0;
  double axis[3] = {kUnknownTurns, kUnknownTurns, kUnknownTurns};   ///< X Y Z, programmed units
  double angle[3] = {kUnknownTurns, kUnknownTurns, kUnknownTurns};  ///< A B C [degrees]
  double f = kUnknownTurns, p = kUnknownTurns, q = kUnknownTurns, r = kUnknownTurns,
         l = kUnknownTurns;
  double lead[3] = {kUnknownTurns, kUnknownTurns, kUnknownTurns};  ///< I J K
  bool dwell = false;
  bool machine = false;    ///< G53: its coordinates are the machine's
  bool reference = false;  ///< G28, G30: to the machine's reference
  bool offset = false;     ///< another work offset comes into force
  /// Whether it names any axis.
  bool moves() const {
    bool any = false;
    for (int i = 0; i < 3; ++i) any = any || !std::isnan(axis[i]) || !std::isnan(angle[i]);
    return any;
  }
};

/// Block `number` of a program: its words change `state`. Errors: InputError "G-code line n" for words that are
/// not read.
GcodeBlock read_block(std::string_view text, long number, const ReadOptions& options,
                      GcodeState& state);

/// Spindle turns that a move of the block takes: a way of `length` [mm] along `way` [mm] (not the same on an arc) and
/// through `turned`, the length of the way of the rotary axes [degrees]. Unknown for a rapid. Errors: InputError
/// "G-code line n" if feed or lead is missing.
double block_turns(const GcodeBlock& block, const GcodeState& state, const Control& control,
                   const Vec3& way, double length, double turned);

/// Throws InputError "G-code line n"; `why` is a whole sentence.
[[noreturn]] void refuse_block(const GcodeBlock& block, const std::string& why);

}  // namespace patchmill::gcode
