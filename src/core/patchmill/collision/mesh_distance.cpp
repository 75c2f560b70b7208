// Nearest triangle and side of it; see mesh_distance.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/collision/mesh_distance.h"

#include "patchmill/collision/frustum_search.h"
#include "patchmill/mesh/triangle_bvh.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace patchmill::collision {
namespace {

const double kGentle = std::cos(80.0 * kPi / 180.0);

class Solid {
 public:
  explicit Solid(const mesh::TriangleMesh& mesh) : bvh_(mesh), normal_(mesh.triangles.size()) {
    for (std::size_t i = 0; i < normal_.size(); ++i) {
      const auto& t = mesh.triangles[i];
      const Vec3 a = mesh.vertices[t[0]];
      normal_[i] = (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).normalized();
    }
    find_gentle(mesh);
  }

  const mesh::TriangleBvh& bvh() const { return bvh_; }

  double distance(const Vec3& at) const {
    const mesh::ClosestPoint near = mesh::closest_point(bvh_, at);
    const auto i = static_cast<std::size_t>(near.triangle);
    const double height = (at - near.point).dot(normal_[i]);
    const bool on_face = near.barycentric.minCoeff() > 1e-9;
    // u in the cone of normals that are all within 80 degrees of each other: u . n >= cos 80
    if ((on_face || gentle_[i]) && std::abs(height) >= 0.99 * kGentle * near.distance)
      return std::copysign(near.distance, height);
    return inside(at) ? -near.distance : near.distance;
  }

  bool inside(const Vec3& at) const { return mesh::inside(bvh_, at); }

 private:
  /// Triangles all of whose neighbours, also those at a corner only, have normals within 80 degrees.
  void find_gentle(const mesh::TriangleMesh& mesh) {
    std::vector<std::vector<std::int32_t>> around(mesh.vertices.size());
    for (std::size_t i = 0; i < normal_.size(); ++i)
      for (const std::int32_t v : mesh.triangles[i])
        around[static_cast<std::size_t>(v)].push_back(static_cast<std::int32_t>(i));
    gentle_.resize(normal_.size());
    std::vector<char> calm(mesh.vertices.size(), 1);
    for (std::size_t v = 0; v < around.size(); ++v) {
      if (around[v].size() > 1000) calm[v] = 0;  // the parity then tells
      if (calm[v] == 0) continue;
      for (const std::int32_t a : around[v])
        for (const std::int32_t b : around[v])
          if (!(normal_[static_cast<std::size_t>(a)].dot(normal_[static_cast<std::size_t>(b)]) >
                kGentle))
            calm[v] = 0;
    }
    for (std::size_t i = 0; i < normal_.size(); ++i) {
      const auto& t = mesh.triangles[i];
      gentle_[i] = std::all_of(t.begin(), t.end(),
                               [&](std::int32_t v) { return calm[static_cast<std::size_t>(v)]; });
    }
  }

  mesh::TriangleBvh bvh_;
  std::vector<Vec3> normal_;
  std::vector<char> gentle_;
};

}  // namespace

namespace {

constexpr double kExact = 1e-6;     // mm
constexpr double kRelative = 0.02;  // of what a swept section is too near

/// What a section sweeps is all on one side of the surface that it does not touch.
SweptSection sweep(const Solid& solid, const ToolSection& section, const ToolPose& pose,
                   const Vec3& travel, double enough, double within) {
  FrustumSearch search(solid.bvh(), pose.tip, pose.axis, std::max(within, kExact),
                       -std::numeric_limits<double>::infinity(), travel, kRelative);
  SweptSection found;
  found.distance = search.nearer(section.frustum(), enough);
  found.place = search.point();
  found.fraction = search.fraction();
  const Vec3 middle = pose.tip + 0.5 * (section.from + section.to) * pose.axis;
  found.inside = found.distance > 0.0 && solid.inside(middle);
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
    const SectionDistance found = nearest_section(solid->bvh(), section, pose, enough);
    if (found.distance < 0.0) return found;
    // it does not touch the surface: it may still be all inside
    const Vec3 middle = pose.tip + 0.5 * (section.from + section.to) * pose.axis;
    if (!solid->inside(middle)) return found;
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
