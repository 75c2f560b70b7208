// All moves of a path, blocks of them side by side; see clearance.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/collision/clearance.h"

#include "patchmill/collision/move_check.h"
#include "patchmill/geometry/error.h"
#include "patchmill/geometry/shared_progress.h"
#include "patchmill/geometry/stop.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace patchmill::collision {
namespace {

void require_valid(const ToolPath& path, const std::vector<ToolSection>& sections,
                   const ClearanceOptions& options) {
  require_positive("BallRadius", path.tool.radius, "mm");
  require_valid(path.tool);
  require_in_range("Tolerance", options.tolerance, 0.0, 1e6, "mm");
  require_in_range("Clearance", options.clearance, 0.0, 1e6, "mm");
  require_in_range("Resolution", options.resolution, 1e-6, 1e6, "mm");
  for (const ToolSection& section : sections) require_valid(section);
}

// Moves of a path one after another. `looked_at` is called after each, and says whether to go on.
template <class LookedAt>
void check_moves(const ToolPath& path, const std::vector<ToolSection>& sections,
                 const PartShape& part, const ClearanceOptions& options, std::size_t from,
                 std::size_t to, ClearanceReport& report, LookedAt&& looked_at) {
  MoveCheck checker(path.tool, part, options, report);
  for (std::size_t i = from; i < to && report.findings.size() < options.most_findings; ++i) {
    const Swing swing(i > 0 ? path.moves[i - 1].end : path.start, path.moves[i].end);
    const auto number = static_cast<std::int64_t>(i);
    if (options.cutting) checker.end(number, swing);
    for (const ToolSection& piece : sections)
      if (options.cutting || !cuts(piece.part)) checker.section(number, swing, piece);
    if (!looked_at()) return;
  }
}

/// How deep the section of a tool part is at a finding's place on its move, exactly where the part's shape knows.
void sharpen(const ToolPath& path, const std::vector<ToolSection>& sections, const PartShape& part,
             const ClearanceOptions& options, ClearanceFinding& found) {
  const auto move = static_cast<std::size_t>(found.move);
  const Swing swing(move > 0 ? path.moves[move - 1].end : path.start, path.moves[move].end);
  const bool cuts = found.part == ToolPart::Flute;
  const double limit = cuts ? -options.tolerance : options.clearance;
  for (const ToolSection& section : sections) {
    if (section.part != found.part) continue;
    const SectionDistance now = part.section(section, swing.at(found.share), limit);
    if (!(limit - now.distance > found.depth)) continue;
    found.depth = limit - now.distance;
    found.place = now.place;
  }
}

/// A whole move is searched to a tenth of a depth; what is said first is the deepest of each tool part, which is
/// looked at again.
void sharpen_deepest(const ToolPath& path, const std::vector<ToolSection>& sections,
                     const PartShape& part, const ClearanceOptions& options,
                     std::vector<ClearanceFinding>& findings) {
  if (!part.section) return;
  for (const ToolPart each : {ToolPart::Flute, ToolPart::Shank, ToolPart::Holder}) {
    ClearanceFinding* deepest = nullptr;
    for (ClearanceFinding& one : findings)
      if (one.part == each && (!deepest || one.depth > deepest->depth)) deepest = &one;
    if (deepest) sharpen(path, sections, part, options, *deepest);
  }
}

}  // namespace

ClearanceReport check_clearance(const ToolPath& path, const PartShape& part,
                                const ClearanceOptions& options, const Progress& progress) {
  return check_sections(path, path.tool.sections(), part, options, progress);
}

ClearanceReport check_sections(const ToolPath& path, const std::vector<ToolSection>& sections,
                               const PartShape& part, const ClearanceOptions& options,
                               const Progress& progress) {
  require_valid(path, sections, options);
  ClearanceReport report;
  if (!part.distance) report.reason = "There is no shape of the part to measure distances from.";
  if (options.first_move > 0 && options.first_move >= path.moves.size())
    report.reason = "No move of the path was looked at.";
  if (!report.reason.empty()) return report;
  constexpr std::size_t kBlock = 64, kRound = 16;  // moves checked by one thread, blocks in a round
  const std::size_t count = path.moves.size();
  SharedProgress shared(progress, count - std::min(count, options.first_move));
  bool stopped = false;
  for (std::size_t begin = options.first_move; begin < count && !stopped;
       begin += kBlock * kRound) {
    std::array<ClearanceReport, kRound> blocks;
    patchmill::parallel_for(std::size_t{0}, kRound, [&](std::size_t k) {
      const std::size_t from = begin + k * kBlock;
      check_moves(path, sections, part, options, from, std::min(from + kBlock, count), blocks[k],
                  [&] { return shared.one_done(); });
    });
    for (const ClearanceReport& block : blocks) {
      report.findings.insert(report.findings.end(), block.findings.begin(), block.findings.end());
      report.unknown_moves += block.unknown_moves;
      if (report.reason.empty()) report.reason = block.reason;
    }
    stopped = report.findings.size() >= options.most_findings || shared.stopped();
  }
  if (report.findings.size() > options.most_findings) report.findings.resize(options.most_findings);
  sharpen_deepest(path, sections, part, options, report.findings);
  if (!report.findings.empty())
    report.outcome = ClearanceOutcome::Violated;
  else if (!stopped && report.unknown_moves == 0)
    report.outcome = ClearanceOutcome::Clear;
  if (stopped && report.reason.empty()) report.reason = "The check was stopped before its end.";
  return report;
}

}  // namespace patchmill::collision
