// Milling one tile; see tile.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/marks/tile.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace patchmill::marks {
namespace {

constexpr int kChunks = kTile / kLanes;  // per row

/// Where the row y meets the points within `reach` of the segment a b; empty if low > high.
struct Span {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void take(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

void add_disc(const Vec3& centre, double reach, double y, Span& span) {
  const double dy = y - centre.y();
  if (std::abs(dy) > reach) return;
  const double half = std::sqrt(reach * reach - dy * dy);
  span.take(centre.x() - half);
  span.take(centre.x() + half);
}

/// Adds the two sides of the capsule, which are tangent to both its discs.
void add_sides(const Vec3& a, const Vec3& b, double reach, double y, Span& span) {
  const double dx = b.x() - a.x(), dy = b.y() - a.y();
  const double length = std::hypot(dx, dy);
  if (std::abs(dy) < 1e-12 * (length + reach)) return;
  for (const double side : {-1.0, 1.0}) {
    const double sx = a.x() - side * reach * dy / length, sy = a.y() + side * reach * dx / length;
    const double share = (y - sy) / dy;
    if (share >= 0.0 && share <= 1.0) span.take(sx + share * dx);
  }
}

Span row_span(const PassWay& way, double reach, double y) {
  Span span;
  for (std::size_t k = 0; k < way.corners.size(); ++k) {
    add_disc(way.corners[k], reach, y, span);
    if (k > 0) add_sides(way.corners[k - 1], way.corners[k], reach, y, span);
  }
  return span;
}

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 ab = b - a;
  const double square = ab.squaredNorm();
  const double share = square > 0.0 ? std::clamp((p - a).dot(ab) / square, 0.0, 1.0) : 0.0;
  return (a + share * ab - p).norm();
}

double distance_to_way(const PassWay& way, const Vec3& p) {
  double least = (way.corners.front() - p).norm();
  for (std::size_t k = 1; k < way.corners.size(); ++k)
    least = std::min(least, distance_to_segment(p, way.corners[k - 1], way.corners[k]));
  return least;
}

}  // namespace

void Tile::begin(const SurfaceGrid& grid, int first_column, int first_row, double stock) {
  grid_ = &grid;
  first_column_ = first_column;
  first_row_ = first_row;
  columns_ = std::min(kTile, grid.columns - first_column);
  rows_ = std::min(kTile, grid.rows - first_row);
  stock_ = stock;
  height_.assign(static_cast<std::size_t>(kTile) * kTile, static_cast<float>(stock));
  if (grid.curved()) load_base();
}

void Tile::load_base() {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (auto& b : base_) b.assign(height_.size(), nan);
  origin_ = grid_->plane.at(grid_->plane_point(first_column_, first_row_));
  for (int j = 0; j < rows_; ++j)
    for (int i = 0; i < columns_; ++i) {
      const Vec3 p = base_point(*grid_, first_column_ + i, first_row_ + j);
      const Vec3 n = base_normal(*grid_, first_column_ + i, first_row_ + j);
      const auto cell = static_cast<std::size_t>(j * kTile + i);
      if (!std::isfinite(p.z())) {
        height_[cell] = nan;
        continue;
      }
      for (int k = 0; k < 3; ++k) {
        base_[k][cell] = static_cast<float>(p[k] - origin_[k]);
        base_[3 + k][cell] = static_cast<float>(n[k]);
      }
    }
  chunk_middle_.assign(static_cast<std::size_t>(kTile) * kChunks, Vec3f::Zero());
  chunk_radius_.assign(chunk_middle_.size(), -1.0f);
  for (std::size_t c = 0; c < chunk_middle_.size(); ++c) {
    Eigen::AlignedBox3f box;
    for (std::size_t cell = c * kLanes; cell < (c + 1) * kLanes; ++cell) {
      const Vec3f p(base_[0][cell], base_[1][cell], base_[2][cell]);
      const Vec3f n(base_[3][cell], base_[4][cell], base_[5][cell]);
      if (std::isfinite(p.z())) box.extend(p + static_cast<float>(stock_) * n);
    }
    if (box.isEmpty()) continue;
    chunk_middle_[c] = box.center();
    chunk_radius_[c] = 0.5f * box.diagonal().norm() + 1e-5f;
  }
}

std::int64_t Tile::mill(const ToothPass& pass, const ToolMotion& motion, const Cutter& cutter) {
  prepare(pass, motion, cutter, *grid_, frame_, way_);
  return grid_->curved() ? treat_curved(false, pass, Vec3::Zero(), frame_.radius)
                         : treat_flat(false, Vec3::Zero(), pass.reach);
}

void Tile::search(const ToothPass& pass, const ToolMotion& motion, const Cutter& cutter) {
  prepare(pass, motion, cutter, *grid_, frame_, way_);
  if (grid_->curved()) {
    treat_curved(true, pass, way_.tip, way_.near_tip + std::abs(stock_));
    return;
  }
  if (way_.tip.head<2>().norm() < pass.reach + way_.near_tip)
    treat_flat(true, way_.tip, way_.near_tip);
}

std::int64_t Tile::treat_flat(bool search, const Vec3& aside, double reach) {
  const double step = grid_->step;
  // of the tile's first cell, seen from the ball
  const Vec2 corner = grid_->plane_point(first_column_, first_row_) - way_.centre.head<2>();
  const Vec2 start = corner - aside.head<2>();
  double low = way_.corners.front().y(), high = low;
  for (const Vec3& c : way_.corners) {
    low = std::min(low, c.y());
    high = std::max(high, c.y());
  }
  const double from = std::max(std::ceil((low - reach - start.y()) / step), 0.0);
  const double to = std::min(std::floor((high + reach - start.y()) / step), rows_ - 1.0);
  std::int64_t cells = 0;
  for (int j = static_cast<int>(from); j <= to; ++j) {
    const Span span = row_span(way_, reach, start.y() + j * step);
    const double first = std::max(std::ceil((span.low - start.x()) / step), 0.0);
    const double last = std::min(std::floor((span.high - start.x()) / step), columns_ - 1.0);
    if (!(first <= last)) continue;
    const int c0 = static_cast<int>(first) / kLanes, c1 = static_cast<int>(last) / kLanes + 1;
    kernel_.flat(search, frame_, static_cast<float>(corner.x() + c0 * kLanes * step),
                 static_cast<float>(corner.y() + j * step), static_cast<float>(step), c1 - c0,
                 &height_[static_cast<std::size_t>(j * kTile + c0 * kLanes)]);
    cells += static_cast<std::int64_t>(last - first) + 1;
  }
  return cells;
}

std::int64_t Tile::treat_curved(bool search, const ToothPass& pass, const Vec3& aside,
                                double reach) {
  const Vec3 from_ball = origin_ - way_.centre;
  float shift[3];
  for (int k = 0; k < 3; ++k) shift[k] = static_cast<float>(from_ball[k]);
  const Vec2 corner = grid_->plane_point(first_column_, first_row_);
  const auto cell = [&](double place, double first, int count) {
    return static_cast<int>(std::clamp((place - first) / grid_->step, -2.0, count + 1.0));
  };
  const int row0 = std::max(cell(pass.least[1], corner.y(), rows_) - 1, 0);
  const int row1 = std::min(cell(pass.most[1], corner.y(), rows_) + 2, rows_ - 1);
  const int chunk0 = std::max(cell(pass.least[0], corner.x(), columns_) - 1, 0) / kLanes;
  const int chunk1 = std::min(cell(pass.most[0], corner.x(), columns_) + 2, columns_ - 1) / kLanes;
  std::int64_t chunks = 0;
  for (int row = row0; row <= row1; ++row)
    for (int c = chunk0; c <= chunk1; ++c) {
      const auto chunk = static_cast<std::size_t>(row) * kChunks + c;
      if (chunk_radius_[chunk] < 0.0f) continue;
      const Vec3 middle = chunk_middle_[chunk].cast<double>() + from_ball - aside;
      if (distance_to_way(way_, middle) > reach + chunk_radius_[chunk]) continue;
      const std::size_t at = chunk * kLanes;
      kernel_.curved(search, frame_,
                     {&base_[0][at], &base_[1][at], &base_[2][at], &base_[3][at], &base_[4][at],
                      &base_[5][at]},
                     shift, 1, &height_[at]);
      ++chunks;
    }
  return chunks * kLanes;
}

void Tile::end(std::vector<float>& field) const {
  for (int j = 0; j < rows_; ++j)
    std::copy_n(&height_[static_cast<std::size_t>(j * kTile)], columns_,
                &field[static_cast<std::size_t>(grid_->number(first_column_, first_row_ + j))]);
}

}  // namespace patchmill::marks
