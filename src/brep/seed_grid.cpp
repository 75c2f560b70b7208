// Seeds by bilinear cells; see seed_grid.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "brep/seed_grid.h"

#include <algorithm>
#include <cmath>

namespace patchmill {
namespace {

// Cells are made flat enough to find every root, and flatter still where that takes few cells: then
// Newton's method needs a step less.
// Along a fold cells are never flat, so doubling ends somewhere.
constexpr int kMostCells = 512, kMostDoubled = 128, kFewCells = 64;
constexpr double kFlat = 0.02, kFlatter = 0.005, kMargin = 0.15;

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// Solves (1-s)(1-t) a + s(1-t) b + (1-s)t c + st d = p for (s, t) near the cell's middle.
bool inverse_bilinear(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d, const Vec2& p,
                      double& s, double& t) {
  const Vec2 ds = b - a, dt = c - a, dst = a - b - c + d;
  s = t = 0.5;
  for (int i = 0; i < 4; ++i) {
    const Vec2 r = a + s * ds + t * dt + s * t * dst - p;
    const Vec2 js = ds + t * dst, jt = dt + s * dst;
    const double det = cross(js, jt);
    const double size = js.lpNorm<1>() * jt.lpNorm<1>() + 1e-300;  // not less than with roots
    if (std::abs(det) < 1e-12 * size && std::abs(det) < 1e-12 * (js.norm() * jt.norm() + 1e-300))
      return false;
    const double step_s = -cross(r, jt) / det, step_t = -cross(js, r) / det;
    s += step_s;
    t += step_t;
    if (std::abs(step_s) + std::abs(step_t) < 1e-3) break;
  }
  return s >= -kMargin && s <= 1.0 + kMargin && t >= -kMargin && t <= 1.0 + kMargin;
}

// Least and greatest coordinates of a cell with its margin: what lies beyond them is not tried on it.
struct Reach {
  Vec2 low, high;
  Reach(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d)
      : low(a.cwiseMin(b).cwiseMin(c.cwiseMin(d))), high(a.cwiseMax(b).cwiseMax(c.cwiseMax(d))) {
    const Vec2 grow = kMargin * (high - low);
    low -= grow;
    high += grow;
  }
  bool holds(const Vec2& p) const {
    return p.x() >= low.x() && p.x() <= high.x() && p.y() >= low.y() && p.y() <= high.y();
  }
};

}  // namespace

SeedGrid::SeedGrid(const std::function<Vec2(double, double)>& plan, const ParameterBox& box,
                   int u_cells, int v_cells)
    : box_(box), nu_(std::clamp(u_cells, 2, kMostCells)), nv_(std::clamp(v_cells, 2, kMostCells)) {
  sample(plan);
  double bend = most_bend(plan);
  while (bend > kFlat ? std::max(nu_, nv_) < kMostDoubled
                      : bend > kFlatter && std::max(nu_, nv_) < kFewCells) {
    nu_ = std::min(kMostCells, 2 * nu_);
    nv_ = std::min(kMostCells, 2 * nv_);
    sample(plan);
    bend = most_bend(plan);
  }
  bin();
}

void SeedGrid::sample(const std::function<Vec2(double, double)>& plan) {
  corners_.clear();
  corners_.reserve(std::size_t(nu_ + 1) * std::size_t(nv_ + 1));
  for (int j = 0; j <= nv_; ++j)
    for (int i = 0; i <= nu_; ++i)
      corners_.push_back(
          plan(box_.u0 + (box_.u1 - box_.u0) * i / nu_, box_.v0 + (box_.v1 - box_.v0) * j / nv_));
}

double SeedGrid::most_bend(const std::function<Vec2(double, double)>& plan) const {
  double most = 0.0;
  for (int j = 0; j < nv_ && most <= kFlat; ++j)
    for (int i = 0; i < nu_; ++i) {
      const Vec2 &a = corner(i, j), &b = corner(i + 1, j), &c = corner(i, j + 1),
                 &d = corner(i + 1, j + 1);
      const double diagonal = std::max((d - a).norm(), (c - b).norm());
      const Vec2 middle = plan(box_.u0 + (box_.u1 - box_.u0) * (i + 0.5) / nu_,
                               box_.v0 + (box_.v1 - box_.v0) * (j + 0.5) / nv_);
      if (diagonal > 0.0)
        most = std::max(most, (middle - 0.25 * (a + b + c + d)).norm() / diagonal);
    }
  return most;
}

void SeedGrid::bin() {
  low_ = high_ = corners_.front();
  for (const Vec2& p : corners_) {
    low_ = low_.cwiseMin(p);
    high_ = high_.cwiseMax(p);
  }
  const Vec2 size = (high_ - low_).cwiseMax(Vec2::Constant(1e-9));
  bins_x_ = std::clamp(2 * nu_, 1, 1024);
  bins_y_ = std::clamp(2 * nv_, 1, 1024);
  bin_size_ = Vec2(size.x() / bins_x_, size.y() / bins_y_);

  auto each_bin = [&](const auto& visit) {
    for (int j = 0; j < nv_; ++j)
      for (int i = 0; i < nu_; ++i) {
        const Reach cell(corner(i, j), corner(i + 1, j), corner(i, j + 1), corner(i + 1, j + 1));
        const int x0 = std::max(0, int((cell.low.x() - low_.x()) / bin_size_.x()));
        const int x1 = std::min(bins_x_ - 1, int((cell.high.x() - low_.x()) / bin_size_.x()));
        const int y0 = std::max(0, int((cell.low.y() - low_.y()) / bin_size_.y()));
        const int y1 = std::min(bins_y_ - 1, int((cell.high.y() - low_.y()) / bin_size_.y()));
        for (int y = y0; y <= y1; ++y)
          for (int x = x0; x <= x1; ++x) visit(y * bins_x_ + x, j * nu_ + i);
      }
  };
  bin_begin_.assign(std::size_t(bins_x_) * std::size_t(bins_y_) + 1, 0);
  each_bin([&](int bin, int) { ++bin_begin_[std::size_t(bin) + 1]; });
  for (std::size_t k = 1; k < bin_begin_.size(); ++k) bin_begin_[k] += bin_begin_[k - 1];
  bin_cells_.resize(std::size_t(bin_begin_.back()));
  std::vector<int> next = bin_begin_;
  each_bin([&](int bin, int cell) { bin_cells_[std::size_t(next[std::size_t(bin)]++)] = cell; });
}

void SeedGrid::seeds(const Vec2& p, std::vector<Seed>& out) const {
  const int x = static_cast<int>(std::floor((p.x() - low_.x()) / bin_size_.x()));
  const int y = static_cast<int>(std::floor((p.y() - low_.y()) / bin_size_.y()));
  // a point on the outermost line still belongs to the last bin
  const int bx = std::clamp(x, 0, bins_x_ - 1), by = std::clamp(y, 0, bins_y_ - 1);
  if (std::abs(x - bx) > 1 || std::abs(y - by) > 1) return;
  const std::size_t bin = std::size_t(by) * std::size_t(bins_x_) + std::size_t(bx);
  for (int k = bin_begin_[bin]; k < bin_begin_[bin + 1]; ++k) {
    const int cell = bin_cells_[std::size_t(k)], i = cell % nu_, j = cell / nu_;
    const Vec2 &a = corner(i, j), &b = corner(i + 1, j), &c = corner(i, j + 1),
               &d = corner(i + 1, j + 1);
    double s, t;
    if (!Reach(a, b, c, d).holds(p) || !inverse_bilinear(a, b, c, d, p, s, t)) continue;
    s = std::clamp(s, 0.0, 1.0);
    t = std::clamp(t, 0.0, 1.0);
    out.push_back({box_.u0 + (box_.u1 - box_.u0) * (i + s) / nu_,
                   box_.v0 + (box_.v1 - box_.v0) * (j + t) / nv_});
  }
}

}  // namespace patchmill
