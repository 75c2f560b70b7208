// Solids as parts to check against; see mesh_distance.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/collision/mesh_distance.h"

#include "patchmill/collision/frustum_search.h"
#include "patchmill/mesh/signed_distance.h"

#include <algorithm>
#include <limits>
#include <memory>

namespace patchmill::collision {
namespace {

// A mesh, the tree over it and the sides of its faces, made once.
struct Solid {
  explicit Solid(const mesh::TriangleMesh& mesh) : bvh(mesh), faces(mesh) {}
  double distance(const Vec3& at) const { return mesh::signed_distance(bvh, faces, at); }

  mesh::TriangleBvh bvh;
  mesh::SmoothFaces faces;
};

}  // namespace

namespace {

constexpr double kExact = 1e-6;     // mm
constexpr double kRelative = 0.02;  // of what a swept section is too near

/// What a section sweeps is all on one side of the surface that it does not touch.
SweptSection sweep(const Solid& solid, const ToolSection& section, const ToolPose& pose,
                   const Vec3& travel, double enough, double within) {
  FrustumSearch search(solid.bvh, pose.tip, pose.axis, std::max(within, kExact),
                       -std::numeric_limits<double>::infinity(), travel, kRelative);
  SweptSection found;
  found.distance = search.nearer(section.frustum(), enough);
  found.place = search.point();
  found.fraction = search.fraction();
  const Vec3 middle = pose.tip + 0.5 * (section.from + section.to) * pose.axis;
  found.inside = found.distance > 0.0 && mesh::inside(solid.bvh, middle);
  return found;
}

}  // namespace

SectionDistance nearest_section(const mesh::TriangleBvh& bvh, const ToolSection& section,
                                const ToolPose& pose, double enough) {
  FrustumSearch search(bvh, pose.tip, pose.axis, kExact, -std::numeric_limits<double>::infinity());
  const double nearest = search.nearer(section.frustum(), enough);
  return {nearest, search.point()};
}

PartShape shape_from_mesh(const mesh::TriangleMesh& mesh) {
  mesh::require_closed(mesh, "Part");
  const auto solid = std::make_shared<const Solid>(mesh);
  PartShape part([solid](const Vec3& at) { return solid->distance(at); });
  part.section = [solid](const ToolSection& section, const ToolPose& pose, double enough) {
    const SectionDistance found = nearest_section(solid->bvh, section, pose, enough);
    if (found.distance < 0.0) return found;
    // it does not touch the surface: it may still be all inside
    const Vec3 middle = pose.tip + 0.5 * (section.from + section.to) * pose.axis;
    if (!mesh::inside(solid->bvh, middle)) return found;
    return SectionDistance{solid->distance(middle), middle};
  };
  part.swept = [solid](const ToolSection& section, const ToolPose& pose, const Vec3& travel,
                       double enough, double within) {
    return sweep(*solid, section, pose, travel, enough, within);
  };
  return part;
}

PartShape join(std::vector<PartShape> parts) {
  if (parts.empty()) return {};
  if (parts.size() == 1) return parts.front();
  const auto all = std::make_shared<const std::vector<PartShape>>(std::move(parts));
  PartShape joined([all](const Vec3& at) {
    double least = std::numeric_limits<double>::infinity();
    for (const PartShape& part : *all) least = std::min(least, part.distance(at));
    return least;
  });
  joined.section = [all](const ToolSection& section, const ToolPose& pose, double enough) {
    SectionDistance best{enough, Vec3::Zero()};
    for (const PartShape& part : *all) {
      const SectionDistance found = part.section(section, pose, best.distance);
      if (found.distance < best.distance) best = found;
    }
    return best;
  };
  joined.swept = [all](const ToolSection& section, const ToolPose& pose, const Vec3& travel,
                       double enough, double within) {
    SweptSection best;
    best.distance = enough;
    for (const PartShape& part : *all) {
      const SweptSection found = part.swept(section, pose, travel, best.distance, within);
      const bool inside = best.inside || found.inside;
      if (found.distance < best.distance) best = found;
      best.inside = inside;
    }
    return best;
  };
  return joined;
}

PartDistance distance_from_mesh(const mesh::TriangleMesh& mesh) {
  mesh::require_closed(mesh, "Part");
  const auto solid = std::make_shared<const Solid>(mesh);
  return [solid](const Vec3& at) { return solid->distance(at); };
}

}  // namespace patchmill::collision
