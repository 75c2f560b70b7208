// Dimples on planar, pyramid and curved patches; see patch_surface.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/patch_surface.h"

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/stop.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>
#include <tbb/blocked_range.h>

namespace patchmill::patch {
namespace {

constexpr std::size_t kBatch = 1 << 16;
constexpr double kStrip = 0.1;          // width over length, under which points make no plane
constexpr double kLeastSlope = 0.0175;  // sin 1°: facets nearer to the direction are no facets

bool stands_along(const Vec3& normal, const Vec3& direction) {
  return !(-normal.dot(direction) > kLeastSlope);
}

Vec3 on_plane(const TexturePlane& plane, const Vec2& place, const FitPlane& fit) {
  const Vec3 from = plane.at(place);
  return from +
         (fit.point - from).dot(fit.normal) / plane.direction.dot(fit.normal) * plane.direction;
}

FitPlane through(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& direction) {
  const Vec3 normal = (b - a).cross(c - a).normalized();
  return {a, normal.dot(direction) > 0.0 ? Vec3(-normal) : normal};
}

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// The places of a patch's corners and, last, of its middle, and what the faces are there.
struct PatchFrame {
  std::vector<Vec2> places;
  std::vector<SurfaceSample> samples;
};

// One patch at work: its dimples are first..last of all.
struct PatchWork {
  const TexturePlane& plane;
  const PatchSurface& surface;
  const std::vector<Vec2>& places;
  Dimples& dimples;
  std::size_t first, last;

  std::vector<SurfacePoint> on_faces() const {
    std::vector<SurfacePoint> points;
    for (std::size_t k = first; k < last; ++k)
      if (on_face(dimples[k].state)) points.push_back(dimples[k].surface);
    return points;
  }

  void put(std::size_t k, const FitPlane& facet) const {
    Dimple& dimple = dimples[k];
    if (!on_face(dimple.state)) return;
    if (stands_along(facet.normal, plane.direction)) {
      dimple.state = DimpleState::NoFacet;
      return;
    }
    dimple.surface = {on_plane(plane, places[k], facet), facet.normal};
  }
};

void make_planar(const PatchWork& work, const PatchFrame& frame) {
  const auto& s = frame.samples;
  std::vector<SurfacePoint> points;
  if (work.surface.fit == PlaneFit::Corners)
    for (std::size_t i = 0; i + 1 < s.size() && on_face(s[i].state); ++i)
      points.push_back(s[i].point);
  if (points.size() + 1 != s.size()) points = work.on_faces();
  const auto fit = best_fit_plane(points, work.plane.direction);
  if (!fit) return;
  for (std::size_t k = work.first; k < work.last; ++k) work.put(k, *fit);
}

void make_pyramid(const PatchWork& work, const PatchFrame& frame) {
  const Vec3& direction = work.plane.direction;
  const auto fit = best_fit_plane(work.on_faces(), direction);
  if (!fit) return;
  const std::size_t corner_count = frame.samples.size() - 1;
  auto position = [&](std::size_t i) {
    const bool hit = on_face(frame.samples[i].state);
    return hit ? frame.samples[i].point.position : on_plane(work.plane, frame.places[i], *fit);
  };
  std::vector<Vec3> corner;
  Vec3 base = Vec3::Zero();
  for (std::size_t i = 0; i < corner_count; ++i) {
    corner.push_back(position(i));
    base += corner.back() / double(corner_count);
  }
  const Vec3 apex = base + work.surface.height_factor * (position(corner_count) - base) -
                    work.surface.apex_lift * direction;
  std::vector<FitPlane> facets;
  for (std::size_t i = 0; i < corner_count; ++i)
    facets.push_back(through(apex, corner[i], corner[(i + 1) % corner_count], direction));
  const Vec2 middle = frame.places[corner_count];
  for (std::size_t k = work.first; k < work.last; ++k) {
    // the facet that the place lies in, seen along the projection; on a ridge, the first of the two
    const Vec2 from_middle = work.places[k] - middle;
    std::size_t best = 0;
    double deepest = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < corner_count; ++i) {
      const Vec2 a = frame.places[i] - middle, b = frame.places[(i + 1) % corner_count] - middle;
      const double depth = std::min(cross(a, from_middle), cross(from_middle, b));
      if (depth > deepest + 1e-9 * cross(a, b)) {
        deepest = depth;
        best = i;
      }
    }
    work.put(k, facets[best]);
  }
}

// From lattice coordinates to what is there; whole coordinates are dimples.
using LatticeSampler = std::function<std::vector<SurfaceSample>(const std::vector<Vec2>& lattice)>;

// visit(i) for 0..count-1, on as many threads as there are.
template <class Visit>
void each(std::size_t count, const Visit& visit) {
  constexpr std::size_t kLeast = 4096;
  patchmill::parallel_for(tbb::blocked_range<std::size_t>(0, count, kLeast),
                          [&](const tbb::blocked_range<std::size_t>& range) {
                            for (std::size_t i = range.begin(); i < range.end(); ++i) visit(i);
                          });
}

// Samples in batches, so that progress moves and memory stays bounded. False if asked to stop.
bool sample_all(const LatticeSampler& sampler, const Progress& progress, Dimples& dimples) {
  std::vector<Vec2> batch;
  for (std::size_t first = 0; first < dimples.size(); first += batch.size()) {
    batch.resize(std::min(kBatch, dimples.size() - first));
    each(batch.size(), [&](std::size_t i) { batch[i] = to_vec(dimples[first + i].lattice); });
    const std::vector<SurfaceSample> samples = sampler(batch);
    each(batch.size(), [&](std::size_t i) {
      dimples[first + i].state = samples[i].state;
      if (samples[i].state != DimpleState::OffFace) dimples[first + i].surface = samples[i].point;
    });
    if (!go_on(progress, double(first + batch.size()) / double(dimples.size()))) return false;
  }
  return true;
}

// By way of the texture plane: where the lattice has no place there, it does not reach.
LatticeSampler through_plane(const LatticePlace& place_of, const SurfaceSampler& sampler) {
  return [&](const std::vector<Vec2>& lattice) {
    std::vector<SurfaceSample> all(lattice.size());
    std::vector<Vec2> places;
    std::vector<std::size_t> of;
    for (std::size_t k = 0; k < lattice.size(); ++k) {
      const Vec2 place = place_of(lattice[k]);
      all[k].state = DimpleState::OffNet;
      if (!place.allFinite()) continue;
      places.push_back(place);
      of.push_back(k);
    }
    const std::vector<SurfaceSample> samples = sampler(places);
    for (std::size_t i = 0; i < of.size(); ++i) all[of[i]] = samples[i];
    return all;
  };
}

// A middle that the lattice does not reach of itself is sampled through the plane.
std::vector<PatchFrame> sample_frames(const PatchDivision& division, const LatticePlace& place_of,
                                      const SurfaceSampler& sampler) {
  std::vector<PatchFrame> frames;
  std::vector<Vec2> batch;
  for (const PatchCell& cell : division.cells) {
    PatchFrame frame;
    Vec2 middle = Vec2::Zero();
    const Polygon outline = outline_in_lattice(division.pattern, cell);
    for (const Vec2& corner : outline) {
      frame.places.push_back(place_of(corner));
      middle += frame.places.back() / double(outline.size());
    }
    frame.places.push_back(middle);
    for (const Vec2& place : frame.places)
      if (place.allFinite()) batch.push_back(place);
    frames.push_back(std::move(frame));
  }
  const std::vector<SurfaceSample> samples = sampler(batch);
  auto next = samples.begin();
  for (PatchFrame& frame : frames)
    for (const Vec2& place : frame.places)
      frame.samples.push_back(place.allFinite() ? *next++ : SurfaceSample{});
  return frames;
}

}  // namespace

std::optional<FitPlane> best_fit_plane(const std::vector<SurfacePoint>& points,
                                       const Vec3& direction) {
  if (points.empty()) return std::nullopt;
  FitPlane fit;
  Vec3 normal = Vec3::Zero();
  for (const SurfacePoint& p : points) {
    fit.point += p.position / double(points.size());
    normal += p.normal;
  }
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (const SurfacePoint& p : points) {
    const Vec3 d = p.position - fit.point;
    moments += d * d.transpose();
  }
  const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - direction * direction.transpose();
  const Vec3 seen = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(across * moments * across,
                                                                   Eigen::EigenvaluesOnly)
                        .eigenvalues();
  const bool strip = seen[1] < kStrip * kStrip * seen[2] || points.size() < 3;
  fit.normal =
      strip ? Vec3(normal.normalized())
            : Vec3(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments).eigenvectors().col(0));
  if (fit.normal.dot(direction) > 0.0) fit.normal = -fit.normal;
  return fit;
}

namespace {

std::optional<Dimples> sampled(const PatchDivision& division, const TexturePlane& plane,
                               const LatticePlace& place_of, const SurfaceSampler& sampler,
                               const LatticeSampler& on_lattice, const PatchSurface& surface,
                               const Progress& progress) {
  require_in_range("HeightFactor", surface.height_factor, -1e3, 1e3, "times the apex' own height");
  require_in_range("ApexLift", surface.apex_lift, -1e3, 1e3, "mm");
  Dimples dimples = lattice_points(division);
  if (!sample_all(on_lattice, progress, dimples)) return std::nullopt;
  if (surface.kind == SurfaceKind::Curved) return dimples;
  std::vector<Vec2> places;
  places.reserve(dimples.size());
  for (const Dimple& dimple : dimples) places.push_back(place_of(to_vec(dimple.lattice)));
  const std::vector<PatchFrame> frames = sample_frames(division, place_of, sampler);
  const std::size_t count = dimples.size() / std::max<std::size_t>(1, frames.size());
  patchmill::parallel_for(std::size_t{0}, frames.size(), [&](std::size_t k) {
    const PatchWork work{plane, surface, places, dimples, k * count, (k + 1) * count};
    // corners beyond the net's end make no frame
    const bool framed = std::all_of(frames[k].places.begin(), frames[k].places.end(),
                                    [](const Vec2& p) { return p.allFinite(); });
    if (surface.kind == SurfaceKind::Pyramid && framed)
      make_pyramid(work, frames[k]);
    else
      make_planar(work, frames[k]);
  });
  return dimples;
}

}  // namespace

std::optional<Dimples> sample_patches(const PatchDivision& division, const TexturePlane& plane,
                                      const LatticePlace& place_of, const SurfaceSampler& sampler,
                                      const PatchSurface& surface, const Progress& progress) {
  return sampled(division, plane, place_of, sampler, through_plane(place_of, sampler), surface,
                 progress);
}

std::optional<Dimples> sample_patches(const PatchDivision& division, const TexturePlane& plane,
                                      const SurfaceLattice& lattice, const SurfaceSampler& sampler,
                                      const PatchSurface& surface, const Progress& progress) {
  if (!lattice.sample_of)
    return sample_patches(division, plane, lattice.place_of, sampler, surface, progress);
  const LatticeSampler on_faces = [&](const std::vector<Vec2>& points) {
    std::vector<SurfaceSample> samples;
    samples.reserve(points.size());
    for (const Vec2& p : points) samples.push_back(lattice.sample_of(p));
    return samples;
  };
  return sampled(division, plane, lattice.place_of, sampler, on_faces, surface, progress);
}

std::optional<Dimples> sample_patches(const PatchDivision& division, const TexturePlane& plane,
                                      const SurfaceSampler& sampler, const PatchSurface& surface,
                                      const Progress& progress) {
  const auto flat = [&](const Vec2& lattice) { return place(division, lattice); };
  const LatticeSampler everywhere = [&](const std::vector<Vec2>& lattice) {
    std::vector<Vec2> places(lattice.size());
    each(places.size(), [&](std::size_t i) { places[i] = flat(lattice[i]); });
    return sampler(places);
  };
  return sampled(division, plane, flat, sampler,
                 division.anchor.allFinite() ? everywhere : through_plane(flat, sampler), surface,
                 progress);
}

}  // namespace patchmill::patch
