// Dividing faces and joining charts; see atlas.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/atlas/atlas.h"

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/stop.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace patchmill::patch {
namespace {

constexpr int kMostDivisions = 12;    // one within the other
constexpr double kFewDimples = 24.0;  // a chart worth fewer is not divided
constexpr int kSeamSamples = 24;

using Pairs = std::vector<std::pair<Vec2, Vec2>>;  // places of the same points in two charts

// What two charts have in common: the same points on both, by parameters.
struct Joint {
  int a = 0, b = 0;
  std::vector<Vec2> uv_a, uv_b;
  double length = 0.0;
};

// The two halves of a rectangle, divided across its longer direction on the face.
std::array<Box2, 2> halves(const Chart& chart) {
  const Box2& r = chart.rectangle();
  const int axis = chart.lengths().x() >= chart.lengths().y() * (1.0 - 1e-6) ? 0 : 1;
  std::array<Box2, 2> parts{r, r};
  parts[0].max()[axis] = parts[1].min()[axis] = r.center()[axis];
  return parts;
}

// Charts of one face. False if asked to stop.
bool divide(const std::shared_ptr<const CurvedFace>& face, int number, const Box2& rectangle,
            double spacing, bool close_round, int depth, const Progress& progress,
            std::vector<PlacedChart>& out) {
  stop_point();
  std::optional<Chart> chart =
      Chart::make(face, rectangle, spacing, depth < kMostDivisions, close_round, progress);
  if (!chart) return false;
  if (!(chart->area() > 0.0)) return true;
  const bool small = chart->area() < kFewDimples * spacing * spacing;
  if (small && !chart->fits())
    chart = Chart::make(face, rectangle, spacing, false, false, progress);
  if (!chart) return false;
  if (chart->fits() || depth == kMostDivisions || small) {
    PlacedChart placed{std::move(*chart)};
    placed.face = number;
    out.push_back(std::move(placed));
    return true;
  }
  for (const Box2& part : halves(*chart))
    if (!divide(face, number, part, spacing, false, depth + 1, progress, out)) return false;
  return true;
}

// Joint of two rectangles of one face where `a` ends and `b` begins along an axis; `period` is what lies
// between the two sides' parameters (0, or that of a closed face).
void join_rectangles(const std::vector<PlacedChart>& charts, int a, int b, int axis, double period,
                     std::vector<Joint>& joints) {
  const Chart &ca = charts[std::size_t(a)].chart, &cb = charts[std::size_t(b)].chart;
  const Box2 &ra = ca.rectangle(), &rb = cb.rectangle();
  const int other = 1 - axis;
  const double tolerance = 1e-9 * ca.face().box().sizes()[axis];
  if (std::abs(ra.max()[axis] - period - rb.min()[axis]) > tolerance) return;
  const double low = std::max(ra.min()[other], rb.min()[other]);
  const double high = std::min(ra.max()[other], rb.max()[other]);
  if (!(high > low)) return;
  Joint joint{a, b, {}, {}, 0.0};
  Vec3 before = Vec3::Zero();
  for (int k = 0; k < kSeamSamples; ++k) {
    Vec2 uv_a, uv_b;
    uv_a[axis] = ra.max()[axis];
    uv_b[axis] = rb.min()[axis];
    uv_a[other] = uv_b[other] = low + (high - low) * (k + 0.5) / kSeamSamples;
    if (!ca.face().inside(uv_a)) continue;
    const Vec3 point = ca.face().d1(uv_a).point;
    if (period > 0.0 && (cb.face().d1(uv_b).point - point).norm() > 1e-6) return;
    if (!joint.uv_a.empty()) joint.length += (point - before).norm();
    before = point;
    joint.uv_a.push_back(uv_a);
    joint.uv_b.push_back(uv_b);
  }
  if (joint.length > 0.0) joints.push_back(std::move(joint));
}

bool holds(const Chart& chart, const Vec2& uv) {
  const Vec2 slack = 1e-6 * chart.face().box().sizes();
  return (uv.array() >= (chart.rectangle().min() - slack).array()).all() &&
         (uv.array() <= (chart.rectangle().max() + slack).array()).all();
}

// Joints over the edges that faces share; an edge may touch several charts of each.
void join_faces(const FaceSet& set, const std::vector<PlacedChart>& charts,
                std::vector<Joint>& joints) {
  const auto chart_of = [&](int face, const Vec2& uv) {
    for (std::size_t k = 0; k < charts.size(); ++k)
      if (charts[k].face == face && holds(charts[k].chart, uv)) return static_cast<int>(k);
    return -1;
  };
  for (const SharedEdge& edge : set.edges) {
    std::map<std::pair<int, int>, Joint> by_charts;
    for (std::size_t k = 0; k < edge.uv_a.size(); ++k) {
      const int a = chart_of(edge.a, edge.uv_a[k]), b = chart_of(edge.b, edge.uv_b[k]);
      if (a < 0 || b < 0) continue;
      Joint& joint = by_charts[{a, b}];
      joint.a = a;
      joint.b = b;
      const CurvedFace& face = charts[std::size_t(a)].chart.face();
      if (!joint.uv_a.empty())
        joint.length += (face.d1(edge.uv_a[k]).point - face.d1(joint.uv_a.back()).point).norm();
      joint.uv_a.push_back(edge.uv_a[k]);
      joint.uv_b.push_back(edge.uv_b[k]);
    }
    for (auto& [pair, joint] : by_charts)
      if (joint.length > 0.0) joints.push_back(std::move(joint));
  }
}

std::vector<Joint> all_joints(const FaceSet& set, const std::vector<PlacedChart>& charts) {
  std::vector<Joint> joints;
  const int n = static_cast<int>(charts.size());
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < n; ++b) {
      if (a == b || charts[std::size_t(a)].face != charts[std::size_t(b)].face) continue;
      for (int axis = 0; axis < 2; ++axis) {
        join_rectangles(charts, a, b, axis, 0.0, joints);
        join_rectangles(charts, a, b, axis, charts[std::size_t(a)].chart.face().box().sizes()[axis],
                        joints);
      }
    }
  join_faces(set, charts, joints);
  return joints;
}

// Turns and shifts `to` so that its side of the joint lies on that of `from` as well as it can.
void join(const PlacedChart& from, const std::vector<Vec2>& uv_from, const std::vector<Vec2>& uv_to,
          PlacedChart& to) {
  Pairs pairs;
  Vec2 mean_from = Vec2::Zero(), mean_to = Vec2::Zero();
  for (std::size_t k = 0; k < uv_from.size(); ++k) {
    const Vec2 a = from.to_plane(from.chart.flat(uv_from[k])), b = to.chart.flat(uv_to[k]);
    if (!a.allFinite() || !b.allFinite()) continue;
    pairs.emplace_back(a, b);
    mean_from += a;
    mean_to += b;
  }
  if (pairs.empty()) return;
  mean_from /= double(pairs.size());
  mean_to /= double(pairs.size());
  double dot = 0.0, cross = 0.0;
  for (const auto& [a, b] : pairs) {
    const Vec2 p = b - mean_to, q = a - mean_from;
    dot += p.dot(q);
    cross += p.x() * q.y() - p.y() * q.x();
  }
  const double size = std::hypot(dot, cross);
  if (size > 0.0) {
    to.cosine = dot / size;
    to.sine = cross / size;
  }
  to.shift = Vec2::Zero();
  to.shift = mean_from - to.to_plane(mean_to);
  to.window = from.window;
}

// Puts a chart with its start at the origin and its direction as asked.
void put_first(PlacedChart& first, const Vec2& uv, const Vec2& origin, Angle rotation) {
  const Vec2 step(1e-4 * first.chart.rectangle().sizes().x(), 0.0);
  Vec2 along = first.chart.flat(uv + step) - first.chart.flat(uv - step);
  if (!along.allFinite() || !(along.norm() > 0.0)) along = Vec2::UnitX();
  // a lattice turned by +rotation is a plane turned by -rotation under it
  const double turn = -std::atan2(along.y(), along.x()) - rotation.radians();
  first.cosine = std::cos(turn);
  first.sine = std::sin(turn);
  first.shift = Vec2::Zero();
  first.shift = -first.to_plane(origin);
}

std::size_t largest(const std::vector<PlacedChart>& charts, const std::vector<char>& used) {
  std::size_t best = charts.size();
  for (std::size_t k = 0; k < charts.size(); ++k)
    if (!used[k] &&
        (best == charts.size() || charts[k].chart.area() > 1.000001 * charts[best].chart.area()))
      best = k;
  return best;
}

// Joins charts to those that are placed, over the longest joint first.
Atlas joined(std::vector<PlacedChart> charts, const std::vector<Joint>& joints, std::size_t first,
             const AtlasStart& start) {
  Atlas atlas;
  atlas.windows = 0;
  std::vector<char> used(charts.size(), 0);
  std::vector<std::size_t> order;
  while (order.size() < charts.size()) {
    const Joint* best = nullptr;
    for (const Joint& j : joints)
      if (used[std::size_t(j.a)] != used[std::size_t(j.b)] &&
          (!best || j.length > 1.000001 * best->length))
        best = &j;
    std::size_t next = order.empty() ? first : largest(charts, used);
    if (best && !order.empty()) {
      const bool forward = used[std::size_t(best->a)] != 0;
      next = std::size_t(forward ? best->b : best->a);
      join(charts[std::size_t(forward ? best->a : best->b)], forward ? best->uv_a : best->uv_b,
           forward ? best->uv_b : best->uv_a, charts[next]);
    } else {
      PlacedChart& c = charts[next];
      const bool given = order.empty() && start.at;
      const Vec2 uv = given ? start.at->second : Vec2(c.chart.rectangle().center());
      put_first(c, uv, given ? c.chart.flat(uv) : c.chart.middle(), start.rotation);
      c.window = atlas.windows++;
    }
    used[next] = 1;
    order.push_back(next);
  }
  for (std::size_t k : order) atlas.charts.push_back(std::move(charts[k]));
  return atlas;
}

}  // namespace

std::optional<Atlas> make_atlas(const FaceSet& set, double spacing, const AtlasStart& start,
                                const Progress& progress) {
  std::vector<PlacedChart> charts;
  // a lattice that is turned does not come back to itself
  const bool close_round = std::abs(std::sin(start.rotation.radians())) < 1e-9;
  for (std::size_t f = 0; f < set.faces.size(); ++f)
    if (!divide(set.faces[f], static_cast<int>(f), set.faces[f]->box(), spacing, close_round, 0,
                progress, charts))
      return std::nullopt;
  if (charts.empty())
    throw InputError("Base", "faces without area", "choose faces that have an inside.");
  const std::vector<Joint> joints = all_joints(set, charts);
  std::size_t first = largest(charts, std::vector<char>(charts.size(), 0));
  for (std::size_t k = 0; start.at && k < charts.size(); ++k)
    if (charts[k].face == start.at->first && holds(charts[k].chart, start.at->second)) {
      first = k;
      break;
    }
  double area = 0.0;
  for (const PlacedChart& c : charts) area += c.chart.area();
  Atlas atlas = joined(std::move(charts), joints, first, start);
  atlas.area = area;
  return atlas;
}

}  // namespace patchmill::patch
