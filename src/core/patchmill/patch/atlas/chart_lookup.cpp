// Interpolation over flattened meshes; see chart_lookup.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/atlas/chart_lookup.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/LU>

namespace patchmill::patch {
namespace {

constexpr double kOutside = -1e-9;  // barycentric weights of places that count as in a triangle
constexpr double kTie =
    1e-9;  // weights that differ by less are equal: the first of two triangles at an edge
constexpr int kSteps = 12;

Eigen::Vector3d barycentric(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& p) {
  const Vec2 ab = b - a, ac = c - a, ap = p - a;
  const double det = ab.x() * ac.y() - ab.y() * ac.x();
  const double v = (ap.x() * ac.y() - ap.y() * ac.x()) / det;
  const double w = (ab.x() * ap.y() - ab.y() * ap.x()) / det;
  return {1.0 - v - w, v, w};
}

int slot(double x, const Box2& box, int axis, int count) {
  const double size = box.sizes()[axis];
  const double at = size > 0.0 ? (x - box.min()[axis]) / size * count : 0.0;
  return std::clamp(static_cast<int>(std::clamp(at, -1.0, count + 1.0)), 0, count - 1);
}

void put(std::vector<std::vector<int>>& buckets, const Box2& all, int count, const Box2& one,
         int t) {
  for (int j = slot(one.min().y(), all, 1, count); j <= slot(one.max().y(), all, 1, count); ++j)
    for (int i = slot(one.min().x(), all, 0, count); i <= slot(one.max().x(), all, 0, count); ++i)
      buckets[std::size_t(j * count + i)].push_back(t);
}

}  // namespace

ChartLookup::ChartLookup(const CurvedFace& face, ChartMesh mesh, std::vector<Vec2> flat,
                         std::vector<char> fit)
    : face_(face), mesh_(std::move(mesh)), flat_(std::move(flat)), fit_(std::move(fit)) {
  std::vector<Box2> boxes, uv_boxes;
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    Box2 box, uv_box;
    for (int k = 0; k < 3; ++k) {
      box.extend(corner(t, k));
      uv_box.extend(mesh_.triangles[t][std::size_t(k)].uv);
    }
    if (mesh_.on_face[t] && box.min().allFinite()) bounds_.extend(box);
    uv_bounds_.extend(uv_box);
    boxes.push_back(box);
    uv_boxes.push_back(uv_box);
  }
  count_ = std::clamp(static_cast<int>(std::sqrt(double(boxes.size()))), 1, kMostBuckets);
  buckets_.resize(std::size_t(count_ * count_));
  uv_buckets_.resize(buckets_.size());
  for (std::size_t t = 0; t < boxes.size(); ++t) {
    put(uv_buckets_, uv_bounds_, count_, uv_boxes[t], static_cast<int>(t));
    if (boxes[t].min().allFinite() && !bounds_.isEmpty())
      put(buckets_, bounds_, count_, boxes[t], static_cast<int>(t));
  }
}

Vec2 ChartLookup::corner(std::size_t t, int k) const {
  return flat_[std::size_t(mesh_.triangles[t][std::size_t(k)].vertex)];
}

ChartLookup::Weights ChartLookup::weights(std::size_t t, const Vec2& flat) const {
  return barycentric(corner(t, 0), corner(t, 1), corner(t, 2), flat);
}

int ChartLookup::triangle_at_uv(const Vec2& uv) const {
  const int at = slot(uv.y(), uv_bounds_, 1, count_) * count_ + slot(uv.x(), uv_bounds_, 0, count_);
  int best = -1;
  double inside = -std::numeric_limits<double>::infinity();
  for (int t : uv_buckets_[std::size_t(at)]) {
    const auto& c = mesh_.triangles[std::size_t(t)];
    const double least = barycentric(c[0].uv, c[1].uv, c[2].uv, uv).minCoeff();
    if (least > inside + kTie) {
      inside = least;
      best = t;
    }
  }
  return best;
}

Vec2 ChartLookup::flat(const Vec2& uv) const {
  const int found = triangle_at_uv(uv);
  if (found < 0) return Vec2::Constant(std::numeric_limits<double>::quiet_NaN());
  const auto& c = mesh_.triangles[std::size_t(found)];
  auto at = [&](int k) { return mesh_.positions[std::size_t(c[std::size_t(k)].vertex)]; };
  // the weights that bring uv()'s interpolation in space nearest to the point
  Eigen::Matrix<double, 3, 2> sides;
  sides << at(1) - at(0), at(2) - at(0);
  const Vec2 w =
      (sides.transpose() * sides).inverse() * (sides.transpose() * (face_.d1(uv).point - at(0)));
  const auto t = std::size_t(found);
  return (1.0 - w.x() - w.y()) * corner(t, 0) + w.x() * corner(t, 1) + w.y() * corner(t, 2);
}

std::optional<Chart::Place> ChartLookup::uv(const Vec2& flat) const {
  if (bounds_.isEmpty() || !bounds_.contains(flat)) return std::nullopt;
  const int at = slot(flat.y(), bounds_, 1, count_) * count_ + slot(flat.x(), bounds_, 0, count_);
  for (int found : buckets_[std::size_t(at)]) {
    const auto t = std::size_t(found);
    const Weights w = weights(t, flat);
    if (!(w.minCoeff() >= kOutside)) continue;
    Vec2 uv = Vec2::Zero();
    Vec3 point = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
      const auto& c = mesh_.triangles[t][std::size_t(k)];
      uv += w[k] * c.uv;
      point += w[k] * mesh_.positions[std::size_t(c.vertex)];
    }
    return Chart::Place{nearest_on_face(uv, point), fit_[t] != 0};
  }
  return std::nullopt;
}

// Gauss-Newton on the distance, within the mesh's parameters.
Vec2 ChartLookup::nearest_on_face(Vec2 uv, const Vec3& point) const {
  for (int step = 0; step < kSteps; ++step) {
    const SurfaceD1 at = face_.d1(uv);
    const Vec3 off = point - at.point;
    Eigen::Matrix2d normal;
    normal << at.du.squaredNorm(), at.du.dot(at.dv), at.du.dot(at.dv), at.dv.squaredNorm();
    normal.diagonal() *= 1.0 + 1e-9;
    normal.diagonal().array() += 1e-300;
    const Vec2 move = normal.inverse() * Vec2(at.du.dot(off), at.dv.dot(off));
    if (!move.allFinite()) break;
    const Vec2 next = (uv + move).cwiseMax(uv_bounds_.min()).cwiseMin(uv_bounds_.max());
    const double moved = ((next.x() - uv.x()) * at.du + (next.y() - uv.y()) * at.dv).norm();
    uv = next;
    if (moved < 1e-10) break;
  }
  return uv;
}

}  // namespace patchmill::patch
