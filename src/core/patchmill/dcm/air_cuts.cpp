// Emptying voxels along a path; see air_cuts.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/dcm/air_cuts.h"

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/stop.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <limits>

namespace patchmill::dcm {
namespace {

constexpr int kSub = 4;

bool to_remove(voxel::VoxelKind kind) {
  return kind == voxel::VoxelKind::Removal || kind == voxel::VoxelKind::Surface ||
         kind == voxel::VoxelKind::Exterior;
}

// The places of a move, a quarter of a voxel apart, and at which of them the tool was in air.
struct Scan {
  int steps = 1;
  std::vector<char> air;  // per step, steps of them
};

}  // namespace

// The cutter: all points within its corner of a core, a cylinder or a cone that begins at the centre (tool.h). A cone
// cuts no higher than its edges go, if it is known how far that is.
struct RemainingStock::Swath {
  Vec3 centre, axis;
  double corner, core;  // r, and the core's radius at the centre
  double cosine, sine;  // of the taper
  double top;           // of a cone's edges, above the centre

  Swath(const Vec3& at, const Vec3& along, const Tool& tool)
      : centre(at),
        axis(along),
        corner(tool.corner()),
        core(tool.radius - tool.corner()),
        cosine(std::cos(tool.taper.radians())),
        sine(std::sin(tool.taper.radians())),
        top(sine > 0.0 && tool.shaft.cutting_length > 0.0
                ? tool.shaft.cutting_length - tool.corner()
                : std::numeric_limits<double>::infinity()) {}

  // Is p in the tool, or no further than `more` from it (or a little further)?
  bool holds(const Vec3& p, double more) const {
    const Vec3 d = p - centre;
    const double up = d.dot(axis), r = corner + more;
    if (core == 0.0 && sine == 0.0)  // a ball: without a root
      return (d - std::max(0.0, up) * axis).squaredNorm() <= r * r;
    if (up > top + more) return false;
    const double beside = (d - up * axis).norm() - core;
    if (up >= 0.0 && beside <= 0.0) return true;  // in the core, whichever of its faces is next
    if (up * cosine + beside * sine > 0.0) return beside * cosine - up * sine <= r;
    const double across = std::max(0.0, beside);
    return up * up + across * across <= r * r;
  }
};

RemainingStock::RemainingStock(const voxel::VoxelGrid& grid)
    : grid_(grid), left_(grid.table.size()), emptied_(grid.table.size(), 0) {}

RemainingStock::Samples RemainingStock::whole(std::size_t brick) const {
  Samples samples;
  for (int i = 0; i < voxel::kBrickCells; ++i)
    samples[i] = to_remove(grid_.kind[brick * voxel::kBrickCells + i]) ? ~std::uint64_t{0} : 0;
  return samples;
}

bool RemainingStock::cut(const Vec3& centre, const Vec3& axis, const Tool& cutter,
                         std::vector<Vec3>* taken) {
  const voxel::GridFrame& frame = grid_.frame;
  const Swath tool(centre, axis, cutter);
  // up to where the cylinder leaves the grid's box
  const Vec3 size = frame.pitch * frame.cells.cast<double>();
  const double height = size.norm() + (centre - frame.origin - 0.5 * size).norm();
  const Vec3 end = centre + height * axis;
  const double reach = cutter.radius + height * std::tan(cutter.taper.radians());
  voxel::Cell lo, hi;  // cells, hi not among them
  for (int k = 0; k < 3; ++k) {
    const double a = (std::min(centre[k], end[k]) - reach - frame.origin[k]) / frame.pitch;
    const double b = (std::max(centre[k], end[k]) + reach - frame.origin[k]) / frame.pitch;
    lo[k] = static_cast<int>(std::clamp(std::floor(a), 0.0, double(frame.cells[k])));
    hi[k] = static_cast<int>(std::clamp(std::floor(b) + 1.0, 0.0, double(frame.cells[k])));
  }
  const double half_diagonal = 0.5 * std::sqrt(3.0) * voxel::kBrickSide * frame.pitch;
  bool found = false;
  voxel::Cell p;
  for (p.z() = lo.z() / voxel::kBrickSide; p.z() * voxel::kBrickSide < hi.z(); ++p.z())
    for (p.y() = lo.y() / voxel::kBrickSide; p.y() * voxel::kBrickSide < hi.y(); ++p.y())
      for (p.x() = lo.x() / voxel::kBrickSide; p.x() * voxel::kBrickSide < hi.x(); ++p.x()) {
        const std::int32_t brick = grid_.table.find(p);
        if (brick == voxel::kNoBrick || emptied_[brick]) continue;
        const Vec3 middle = frame.origin + frame.pitch * voxel::kBrickSide *
                                               (p.cast<double>() + Vec3::Constant(0.5));
        if (tool.holds(middle, half_diagonal)) found |= cut_brick(brick, lo, hi, tool, taken);
      }
  return found;
}

bool RemainingStock::cut_brick(std::size_t brick, const voxel::Cell& lo, const voxel::Cell& hi,
                               const Swath& tool, std::vector<Vec3>* taken) {
  const voxel::GridFrame& frame = grid_.frame;
  const double half_diagonal = 0.5 * std::sqrt(3.0) * frame.pitch;
  if (!left_[brick]) left_[brick] = std::make_unique<Samples>(whole(brick));
  Samples& left = *left_[brick];
  const voxel::Cell first = voxel::first_cell(grid_.table, brick);
  bool found = false;
  for (int i = 0; i < voxel::kBrickCells; ++i) {
    const voxel::Cell c = first + voxel::Cell(i % 8, i / 8 % 8, i / 64);
    if (left[i] == 0 || (c.array() < lo.array()).any() || (c.array() >= hi.array()).any()) continue;
    if (!tool.holds(frame.centre(c), half_diagonal)) continue;
    const Vec3 low = frame.origin + frame.pitch * c.cast<double>();
    for (int bit = 0; bit < 64; ++bit) {
      if (!(left[i] >> bit & 1)) continue;
      const Vec3 sub(bit % kSub + 0.5, bit / kSub % kSub + 0.5, bit / (kSub * kSub) + 0.5);
      const Vec3 sample = low + frame.pitch / kSub * sub;
      if (!tool.holds(sample, 0.0)) continue;
      if (taken) taken->push_back(sample);
      left[i] &= ~(std::uint64_t{1} << bit);
      found = true;
    }
  }
  if (std::all_of(left.begin(), left.end(), [](std::uint64_t s) { return s == 0; })) {
    left_[brick].reset();
    emptied_[brick] = 1;
  }
  return found;
}

double RemainingStock::volume() const {
  double samples = 0.0;
  for (std::size_t brick = 0; brick < left_.size(); ++brick) {
    if (emptied_[brick]) continue;
    const Samples left = left_[brick] ? *left_[brick] : whole(brick);
    for (const std::uint64_t bits : left) samples += double(std::bitset<64>(bits).count());
  }
  return samples * sample_volume();
}

double RemainingStock::sample_volume() const {
  return std::pow(grid_.frame.pitch / kSub, 3);
}

std::size_t RemainingStock::opened() const {
  return static_cast<std::size_t>(
      std::count_if(left_.begin(), left_.end(), [](const auto& b) { return b != nullptr; }));
}

namespace {

Scan scan(const ToolPose& from, const ToolPose& to, const Tool& tool, double step,
          RemainingStock& stock) {
  const Vec3 a = centre_of(from, tool), b = centre_of(to, tool);
  Scan out;
  out.steps = std::max(1, static_cast<int>(std::ceil((b - a).norm() / step)));
  for (int i = 0; i < out.steps; ++i) {
    stop_point();
    const double t = (i + 1.0) / out.steps;
    const Vec3 axis = (from.axis + t * (to.axis - from.axis)).normalized();
    out.air.push_back(stock.cut(a + t * (b - a), axis, tool) ? 0 : 1);
  }
  return out;
}

// Steps just before a cut, and stretches that are too short, are not hurried over.
void keep_slow(std::vector<char>& air, int before, int shortest) {
  const int n = static_cast<int>(air.size());
  for (int i = n - 1, ahead = before; i >= 0; --i) {
    ahead = air[i] ? ahead + 1 : 0;
    if (air[i] && ahead <= before) air[i] = 2;
  }
  for (char& state : air) state = state == 1 ? 1 : 0;
  for (int i = 0; i < n;) {
    int j = i;
    while (j < n && air[j] == air[i]) ++j;
    if (air[i] && j - i < shortest) std::fill(air.begin() + i, air.begin() + j, 0);
    i = j;
  }
}

void check(const ToolPath& path, const AirCutOptions& options) {
  require_positive("feed in air", options.feed, "mm/s");
  require_positive("tool radius", path.tool.radius, "mm");
  require_valid(path.tool);
  require_positive("spindle speed", path.spindle.speed, "1/s");
  require_in_range("shortest air cut", options.shortest, 0.0, 1e6, "mm");
  for (const Move& move : path.moves)
    if (move.dimple != kNoDimple)
      throw InputError("base operation", "a texture path",
                       "leave its feed alone: a texture's feed is its timing.");
}

}  // namespace

ToolPath hurry_in_air(const ToolPath& path, const voxel::VoxelGrid& grid,
                      const AirCutOptions& options, std::vector<std::int64_t>* source) {
  check(path, options);
  const double step = 0.25 * grid.frame.pitch;
  const double shortest = options.shortest > 0.0 ? options.shortest : grid.frame.pitch;
  RemainingStock stock(grid);
  ToolPath out = path;
  out.moves.clear();
  if (source) source->clear();
  // all steps of the path in a row, so that air is seen across the ends of moves
  std::vector<char> air;
  std::vector<int> steps;
  ToolPose from = path.start;
  for (const Move& move : path.moves) {
    Scan scanned = scan(from, move.end, path.tool, step, stock);
    if (move.kind == MoveKind::Rapid) scanned.air.assign(scanned.air.size(), 0);
    steps.push_back(scanned.steps);
    air.insert(air.end(), scanned.air.begin(), scanned.air.end());
    from = move.end;
  }
  keep_slow(air, 2, static_cast<int>(std::ceil(shortest / step)));
  from = path.start;
  std::size_t at = 0;
  for (std::size_t m = 0; m < path.moves.size(); ++m) {
    const Move& move = path.moves[m];
    const Vec3 a = centre_of(from, path.tool), b = centre_of(move.end, path.tool);
    for (int i = 0; i < steps[m];) {
      int j = i;
      while (j < steps[m] && air[at + j] == air[at + i]) ++j;
      const double t = double(j) / steps[m], share = double(j - i) / steps[m];
      Move piece = move;
      if (j < steps[m])
        piece.end = pose_of_ball(a + t * (b - a),
                                 (from.axis + t * (move.end.axis - from.axis)).normalized(),
                                 path.tool.corner());
      piece.turns = share * move.turns;
      if (air[at + i])
        piece.turns =
            std::min(piece.turns, path.spindle.speed * share * (b - a).norm() / options.feed);
      out.moves.push_back(piece);
      if (source) source->push_back(static_cast<std::int64_t>(m));
      i = j;
    }
    at += steps[m];
    from = move.end;
  }
  return out;
}

}  // namespace patchmill::dcm
