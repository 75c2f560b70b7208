// Grid-accelerated trimming; see trim_grid.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "brep/trim_grid.h"

#include <algorithm>
#include <cmath>

#include <BRepAdaptor_Curve2d.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

namespace patchmill {

TrimGrid::TrimGrid(const TopoDS_Face& face) : face_(face) {
  double u1, v1;
  BRepTools::UVBounds(face, u0_, u1, v0_, v1);
  du_ = (u1 - u0_) / kCells;
  dv_ = (v1 - v0_) / kCells;
}

void TrimGrid::make() const {
  cells_.assign(std::size_t(kCells) * kCells, Cell::Unknown);
  // the classifier's tolerance is one of parameters: 1e-7 mm on the surface, whatever its scale
  const BRepAdaptor_Surface surface(face_, false);
  const double tolerance = std::min(surface.UResolution(Precision::Confusion()),
                                    surface.VResolution(Precision::Confusion()));
  classifier_ = std::make_unique<BRepTopAdaptor_FClass2d>(face_, tolerance);
  mark_border();
  fill();
}

int TrimGrid::column(double u) const {
  const double x = (u - u0_) / du_;
  return x >= 0.0 && x < kCells ? static_cast<int>(x) : -1;
}

int TrimGrid::row(double v) const {
  const double y = (v - v0_) / dv_;
  return y >= 0.0 && y < kCells ? static_cast<int>(y) : -1;
}

// The cell and its eight neighbours, so that what happens between two samples is covered.
void TrimGrid::mark_border_point(double u, double v) const {
  const int i = static_cast<int>(std::floor((u - u0_) / du_));
  const int j = static_cast<int>(std::floor((v - v0_) / dv_));
  for (int b = std::max(0, j - 1); b <= std::min(kCells - 1, j + 1); ++b)
    for (int a = std::max(0, i - 1); a <= std::min(kCells - 1, i + 1); ++a)
      cells_[std::size_t(b) * kCells + std::size_t(a)] = Cell::Border;
}

void TrimGrid::mark_border() const {
  for (TopExp_Explorer e(face_, TopAbs_EDGE); e.More(); e.Next()) {
    const BRepAdaptor_Curve2d curve(TopoDS::Edge(e.Current()), face_);
    const double t0 = curve.FirstParameter(), t1 = curve.LastParameter();
    // walk in steps of at most half a cell: halve the step until it is, double it when it may grow
    double t = t0, step = (t1 - t0) / 64.0;
    const double least = (t1 - t0) * 1e-7;
    gp_Pnt2d at = curve.Value(t);
    mark_border_point(at.X(), at.Y());
    while (t < t1) {
      const double next = std::min(t1, t + step);
      const gp_Pnt2d p = curve.Value(next);
      const double cells = std::max(std::abs(p.X() - at.X()) / du_, std::abs(p.Y() - at.Y()) / dv_);
      if (cells > 0.5 && step > least) {
        step *= 0.5;
        continue;
      }
      mark_border_point(p.X(), p.Y());
      t = next;
      at = p;
      if (cells < 0.2) step *= 2.0;
    }
  }
}

// One question to the classifier per connected region that the border leaves.
void TrimGrid::fill() const {
  std::vector<int> stack;
  for (int seed = 0; seed < kCells * kCells; ++seed) {
    if (cells_[std::size_t(seed)] != Cell::Unknown) continue;
    const double u = u0_ + (seed % kCells + 0.5) * du_, v = v0_ + (seed / kCells + 0.5) * dv_;
    const Cell cell = ask(u, v) ? Cell::Inside : Cell::Outside;
    stack.assign(1, seed);
    cells_[std::size_t(seed)] = cell;
    while (!stack.empty()) {
      const int at = stack.back();
      stack.pop_back();
      const int i = at % kCells, j = at / kCells;
      const int next[4] = {i > 0 ? at - 1 : -1, i + 1 < kCells ? at + 1 : -1,
                           j > 0 ? at - kCells : -1, j + 1 < kCells ? at + kCells : -1};
      for (const int n : next)
        if (n >= 0 && cells_[std::size_t(n)] == Cell::Unknown) {
          cells_[std::size_t(n)] = cell;
          stack.push_back(n);
        }
    }
  }
}

bool TrimGrid::ask(double u, double v) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return classifier_->Perform(gp_Pnt2d(u, v)) != TopAbs_OUT;
}

bool TrimGrid::inside(double u, double v) const {
  std::call_once(made_, [this] { make(); });
  const int i = column(u), j = row(v);
  if (i < 0 || j < 0) return ask(u, v);  // on the rectangle's edge, or a period away
  const Cell cell = cells_[std::size_t(j) * kCells + std::size_t(i)];
  return cell == Cell::Border ? ask(u, v) : cell == Cell::Inside;
}

}  // namespace patchmill
