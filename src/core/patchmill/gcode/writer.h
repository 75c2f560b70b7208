// The state of program_writer.h's writer from block to block. Words are writer_words.cpp's affair, moves
// writer_moves.cpp's; program_writer.cpp goes through the operations.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/gcode/path_block.h"
#include "patchmill/gcode/program_text.h"

namespace patchmill::gcode {

/// Writes the paths of a job's operations as one program.
class Writer {
 public:
  /// The style must outlive it.
  explicit Writer(const ProgramStyle& style);
  /// The program of these texts of paths, one for each operation. Errors: InputError as program_writer.h says.
  std::string write(const std::vector<std::string>& texts);

 private:
  // program_writer.cpp
  void begin_operation(const std::string& text, bool own);
  void one_line(std::string_view text, long number);
  void one_block(PathBlock& block);
  void one_code(const PathBlock& block, const BlockCode& code);
  void finish();
  // writer_words.cpp
  void require_words(const PathBlock& block);
  LetterSet letters_of(const PathBlock& block, const BlockCode& code) const;
  [[noreturn]] void refuse_offset(int tenths) const;
  bool known(const PathBlock& block, const BlockCode& code) const;
  void lone_words(const PathBlock& block);
  void machine_word(const PathBlock& block, int tenths);
  void preparatory(const PathBlock& block, int tenths);
  void state_word(const PathBlock& block, int tenths);
  void start_spindle(int sense);
  void call_tool(const std::string& speed);
  void tool_change(const PathBlock& block);
  void tcp(bool on);
  void switch_tcp(bool on);
  void length();
  void feed_mode(bool inverse);
  void distance(bool relative);
  void path_mode(const std::string& word);
  void dwell(double seconds);
  // writer_moves.cpp
  void move(const PathBlock& block, int tenths);
  void place(const PathBlock& block, MoveBlock& m, Vec3& way, bool& turned);
  void put(MoveBlock m, const Vec3& way);
  LeadWord lead(double pitch, const Vec3& way, bool turned) const;
  void first_rapid(const MoveBlock& m);
  void down(MoveBlock m);
  void approach(MoveBlock m);
  void arc(const PathBlock& block, bool clockwise);
  void arc_as_lines(const Arc& arc, double feed, bool inverse);
  void cycle(const PathBlock& block, int code);
  void cycle_as_moves(const DrillingCycle& cycle, double x, double y);
  void reference(const PathBlock& block, int tenths);
  void first_move(const PathBlock& block);
  void upright(const PathBlock& block);
  void retract();
  Vec3 place_of(const PathBlock& block) const;
  void stand_at(const Vec3& point);

  const ProgramStyle& style_;
  const Control& control_;
  ProgramText out_;
  LetterSet move_letters_[2] = {0, 0};  ///< of G0 and G1, once they were asked for
  std::array<double, kAxisCount> at_{};
  std::array<bool, kAxisCount> known_{};
  double feed_ = 0.0, speed_ = 0.0, steady_ = 0.0;
  int tool_ = 1, selected_ = 0;
  ArcPlane plane_ = ArcPlane::XY;
  bool tcp_ = false, tcp_used_ = false, pending_tcp_ = false, inverse_ = false;
  bool called_ = true, fresh_ = false, across_ = false, pending_tool_ = false,
       pending_length_ = false;
  bool other_length_ = false;  ///< none, or that of another tool, is in force by a path's own word
  bool relative_ = false, to_initial_ = true, in_cycle_ = false, machine_next_ = false;
  double initial_ = 0.0;          ///< height before a run of cycles [mm]
  const std::string first_mode_;  ///< the preamble's path mode
  std::string path_mode_;         ///< in force; "": that of the preamble
  std::string wanted_mode_;       ///< that an operation finds; "": that of the preamble
  bool mode_said_ = false;        ///< the operation has said its own
  bool was_own_ = false;
  bool retracted_ = false;         ///< and nothing has moved since
  bool other_operation_ = false;   ///< its first move has not come yet
  std::optional<MoveBlock> held_;  ///< rapid of a new tool to a height, from nobody knows where
};

}  // namespace patchmill::gcode
