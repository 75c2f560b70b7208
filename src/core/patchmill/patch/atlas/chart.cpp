// Charts by formula and by flattened meshes; see chart.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/atlas/chart.h"

#include "patchmill/geometry/angle.h"
#include "patchmill/patch/atlas/chart_lookup.h"

#include <algorithm>
#include <cmath>

namespace patchmill::patch {
namespace {

constexpr int kCells = 160;
constexpr double kWorthATry = 1.12;     // spread above which evening out does not help enough
constexpr int kSamples = 64;            // along each side, of a face that rolls out
constexpr double kMostCurvature = 3.0;  // sr: more is divided without a try (a cap of 58° has 2.95)
constexpr double kShortest =
    0.78;  // least stretch in the plane over the spread, of charts that fit
constexpr double kUnfit[2] = {0.7,
                              1.25};  // stretch over the spread beyond which there are no dimples
constexpr double kMostSpreadOfRolled = 1.12;

// Straight distance of two points over their distance along a circle that bends as much as the face does.
double chord_share(double spacing, double bend) {
  const double half = 0.5 * std::min(spacing * bend, kPi);
  return half > 1e-6 ? std::sin(half) / half : 1.0;
}

double greatest_bend(const ChartMesh& mesh) {
  double bend = 0.0;
  for (const auto& e : mesh.edges) {
    const auto a = std::size_t(e.a), b = std::size_t(e.b);
    const Vec3 chord = mesh.positions[b] - mesh.positions[a];
    const double squared = chord.squaredNorm();
    if (squared > 0.0)
      bend = std::max(bend, std::abs((mesh.normals[b] - mesh.normals[a]).dot(chord)) / squared);
  }
  return bend;
}

// Exceeded on a twentieth of the area only: around the apex of a cone there is no limit.
double usual_bend(std::vector<std::pair<double, double>>& bends, double area) {
  std::sort(bends.begin(), bends.end());
  double above = 0.0;
  while (!bends.empty() && above + bends.back().second < 0.05 * area) {
    above += bends.back().second;
    bends.pop_back();
  }
  return bends.empty() ? 0.0 : bends.back().first;
}

}  // namespace

// Of the triangles on the face.
struct Chart::Extremes {
  std::vector<Stretch> all;
  double least = 1e9, greatest = 0.0;
  bool turned_over = false;
};

Chart::Extremes Chart::extremes(const ChartMesh& mesh, const std::vector<Vec2>& flat) {
  Extremes e;
  e.all = stretches(mesh, flat);
  for (std::size_t t = 0; t < e.all.size(); ++t) {
    if (!mesh.on_face[t]) continue;
    e.least = std::min(e.least, e.all[t].least);
    e.greatest = std::max(e.greatest, e.all[t].greatest);
    e.turned_over = e.turned_over || e.all[t].turned_over;
  }
  return e;
}

std::optional<Chart> Chart::make(std::shared_ptr<const CurvedFace> face, const Box2& rectangle,
                                 double spacing, bool may_divide, bool close_round,
                                 const Progress& progress) {
  Chart chart;
  chart.face_ = std::move(face);
  chart.rectangle_ = rectangle;
  if (chart.face_->development()) {
    chart.measure(spacing, close_round);
    return chart;
  }
  ChartMesh mesh = chart_mesh(*chart.face_, rectangle, kCells);
  chart.area_ = mesh.area;
  chart.lengths_ = {mesh.length_u, mesh.length_v};
  chart.fits_ = std::abs(mesh.curvature) < kMostCurvature;
  if (mesh.triangles.empty() || (!chart.fits_ && may_divide)) return chart;
  std::optional<std::vector<Vec2>> flat = flatten(mesh, progress);
  if (!flat) return std::nullopt;
  const double chord = chord_share(spacing, greatest_bend(mesh));
  Extremes e = extremes(mesh, *flat);
  const double wanted = kLeastDistance * e.greatest / chord;
  if (wanted > 1.0 && (!may_divide || wanted < kWorthATry)) {
    if (!even_out(mesh, *flat, progress)) return std::nullopt;
    e = extremes(mesh, *flat);
  }
  chart.settle(std::move(mesh), std::move(*flat), e, chord);
  return chart;
}

void Chart::settle(ChartMesh mesh, std::vector<Vec2> flat, const Extremes& e, double chord) {
  const double wanted = kLeastDistance * e.greatest / chord;
  spread_ = std::clamp(wanted, 1.0, kMostSpread);
  fits_ = fits_ && !e.turned_over && wanted <= kMostSpread && e.least > kShortest * spread_;
  std::vector<char> fit;
  for (const Stretch& s : e.all)
    fit.push_back(!s.turned_over && s.least > kUnfit[0] * spread_ &&
                  s.greatest < kUnfit[1] * spread_);
  double sum = 0.0;
  for (std::size_t t = 0; t < e.all.size(); ++t) {
    if (!mesh.on_face[t] || e.all[t].turned_over) continue;
    Vec2 p[3];
    for (int k = 0; k < 3; ++k) p[k] = flat[std::size_t(mesh.triangles[t][std::size_t(k)].vertex)];
    const Vec2 b = p[1] - p[0], c = p[2] - p[0];
    const double weight = 0.5 * (b.x() * c.y() - b.y() * c.x());
    middle_ += weight / 3.0 * (p[0] + p[1] + p[2]);
    sum += weight;
  }
  if (sum > 0.0) middle_ = own(middle_ / sum);
  lookup_ =
      std::make_shared<const ChartLookup>(*face_, std::move(mesh), std::move(flat), std::move(fit));
  for (int c = 0; c < 4 && !lookup_->bounds().isEmpty(); ++c) {
    const Vec2 corner = lookup_->bounds().corner(Box2::CornerType(c));
    bounds_.extend(own(corner));
  }
}

// Area, middle and bounds of a face that rolls out, from points of a grid inside the trimming.
void Chart::measure(double spacing, bool close_round) {
  const Vec2 size = rectangle_.sizes() / kSamples;
  const Development& roll = *face_->development();
  std::vector<std::pair<double, double>> bends;  // and the area that has it
  double count = 0.0;
  for (int i = 0; i < kSamples; ++i)
    for (int j = 0; j < kSamples; ++j) {
      const Vec2 uv = rectangle_.min() + size.cwiseProduct(Vec2(i + 0.5, j + 0.5));
      const SurfaceD1 at = face_->d1(uv);
      const Vec3 next = face_->d1(uv + Vec2(size.x(), 0.0)).point - at.point;
      const Vec3 turn = face_->normal(uv + Vec2(size.x(), 0.0)) - face_->normal(uv);
      if (!face_->inside(uv)) continue;
      const double weight = at.du.cross(at.dv).norm() * size.x() * size.y();
      bends.emplace_back(next.norm() > 0.0 ? turn.norm() / next.norm() : 0.0, weight);
      area_ += weight;
      middle_ += weight * roll.flat(uv);
      count += 1.0;
      lengths_ += size.cwiseProduct(Vec2(at.du.norm(), at.dv.norm())) * kSamples;
    }
  if (count > 0.0) lengths_ /= count;
  const double chord = chord_share(spacing, usual_bend(bends, area_));
  spread_ = std::clamp(kLeastDistance / chord, 1.0, kMostSpreadOfRolled);
  if (close_round) close(spacing, chord);
  if (area_ > 0.0) middle_ = own(middle_ / area_);
  for (int i = 0; i <= kSamples; ++i)
    for (int j = 0; j <= kSamples; ++j) {
      const Vec2 uv = rectangle_.min() + size.cwiseProduct(Vec2(i, j));
      bounds_.extend(own(roll.flat(uv)));
    }
  // between two samples a cone's outline bulges by less than this
  const Vec2 slack = 0.01 * bounds_.sizes() + Vec2::Constant(1e-9);
  bounds_ = Box2(bounds_.min() - slack, bounds_.max() + slack);
}

// The face's two ends of u are the same line, and every line of constant v is as long as the others in the plane.
void Chart::close(double spacing, double chord) {
  const Development& roll = *face_->development();
  const Vec2 &low = rectangle_.min(), &high = rectangle_.max();
  Vec2 round[2];
  for (int k = 0; k < 2; ++k) {
    const double v = k ? high.y() : low.y();
    const Vec2 a(low.x(), v), b(high.x(), v);
    if ((face_->d1(a).point - face_->d1(b).point).norm() > 1e-7) return;
    round[k] = roll.flat(b) - roll.flat(a);
  }
  const double length = round[0].x();
  if (!(length > spacing) || (round[1] - round[0]).norm() > 1e-9 * length ||
      std::abs(round[0].y()) > 1e-9 * length)
    return;
  double count = std::max(1.0, std::round(length / (spacing * spread_)));
  if (count > 1.0 && length / count * chord < kLeastDistance * spacing) count -= 1.0;
  squeeze_ = count * spacing * spread_ / length;
  round_count_ = static_cast<int>(count);
  round_spacing_ = length / count;
}

Vec2 Chart::flat(const Vec2& uv) const {
  return own(lookup_ ? lookup_->flat(uv) : face_->development()->flat(uv));
}

std::optional<Chart::Place> Chart::uv(const Vec2& flat) const {
  const Vec2 in_map = mapped(flat);
  if (lookup_) return lookup_->uv(in_map);
  const Vec2 uv = face_->development()->uv(in_map);
  const Vec2 slack = 1e-9 * rectangle_.sizes();
  Vec2 end = rectangle_.max() + slack;
  if (round_count_ > 0) end.x() = rectangle_.max().x() - 1e3 * slack.x();  // it is where it begins
  if (!uv.allFinite() || (uv.array() < (rectangle_.min() - slack).array()).any() ||
      (uv.array() > end.array()).any())
    return std::nullopt;
  return Place{uv, true};
}

SurfacePoint Chart::point(const Vec2& uv) const {
  return {face_->d1(uv).point, face_->normal(uv)};
}

}  // namespace patchmill::patch
