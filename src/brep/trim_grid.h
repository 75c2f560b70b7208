// Is a parameter pair inside a trimmed face? A grid over the parameter rectangle answers at once
// for cells that no trimming curve comes near; in the others OpenCASCADE's exact classifier is
// asked.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include <BRepTopAdaptor_FClass2d.hxx>
#include <TopoDS_Face.hxx>

namespace patchmill {

class TrimGrid {
 public:
  /// `face` must have p-curves on its edges, as every valid face has.
  explicit TrimGrid(const TopoDS_Face& face);

  /// True if (u, v) is inside the trimming or within 1e-7 mm of its border. Thread-safe. The first question makes the
  /// grid: faces that are only measured need none.
  bool inside(double u, double v) const;

  double u_min() const { return u0_; }
  double u_max() const { return u0_ + du_ * kCells; }
  double v_min() const { return v0_; }
  double v_max() const { return v0_ + dv_ * kCells; }

 private:
  enum class Cell : std::uint8_t { Unknown, Border, Inside, Outside };
  static constexpr int kCells = 96;

  int column(double u) const;  // -1 if outside the rectangle
  int row(double v) const;
  void make() const;
  void mark_border() const;
  void mark_border_point(double u, double v) const;
  void fill() const;
  bool ask(double u, double v) const;

  TopoDS_Face face_;
  double u0_ = 0, v0_ = 0, du_ = 1, dv_ = 1;
  mutable std::once_flag made_;
  mutable std::vector<Cell> cells_;
  mutable std::unique_ptr<BRepTopAdaptor_FClass2d> classifier_;
  mutable std::mutex mutex_;  // the classifier keeps state between questions
};

}  // namespace patchmill
