// Vector area of meshed faces; see facing.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "brep/facing.h"

#include "patchmill/geometry/error.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <BRepBndLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Poly_Triangulation.hxx>
#include <TopLoc_Location.hxx>
#include <fmt/format.h>

namespace patchmill {

namespace {

// Area vectors of the triangles of a mesh that is at most 1 % of the faces' size off, out of the material.
std::vector<Vec3> area_vectors(const std::vector<TopoDS_Face>& faces) {
  std::vector<Vec3> vectors;
  for (const TopoDS_Face& face : faces) {
    Bnd_Box box;
    BRepBndLib::Add(face, box);
    const double size = box.IsVoid() ? 1.0 : std::sqrt(box.SquareExtent());
    BRepMesh_IncrementalMesh(face, 0.01 * size, Standard_False, 0.3);
    TopLoc_Location location;
    const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, location);
    if (mesh.IsNull()) continue;
    auto at = [&](int n) {
      const gp_Pnt p = mesh->Node(n).Transformed(location.Transformation());
      return Vec3(p.X(), p.Y(), p.Z());
    };
    const double sense = face.Orientation() == TopAbs_REVERSED ? -0.5 : 0.5;
    for (int t = 1; t <= mesh->NbTriangles(); ++t) {
      int a, b, c;
      mesh->Triangle(t).Get(a, b, c);
      vectors.push_back(sense * (at(b) - at(a)).cross(at(c) - at(a)));
    }
  }
  return vectors;
}

// Summed vector area, or nothing if it is under 1 % of the area.
std::optional<Vec3> summed(const std::vector<Vec3>& vectors) {
  Vec3 sum = Vec3::Zero();
  double area = 0.0;
  for (const Vec3& v : vectors) {
    sum += v;
    area += v.norm();
  }
  if (!(sum.norm() > 0.01 * area)) return std::nullopt;
  return sum.normalized();
}

}  // namespace

Vec3 facing(const std::vector<TopoDS_Face>& faces) {
  const auto sum = summed(area_vectors(faces));
  if (!sum)
    throw InputError("AutoDirection", "true",
                     "the faces look to all sides alike: switch it off and give a direction.");
  return *sum;
}

SeenBest seen_best(const std::vector<TopoDS_Face>& faces, const Vec3& preferred) {
  if (!preferred.allFinite() || !(preferred.norm() > 1e-12))
    throw InputError("Direction",
                     fmt::format("({}, {}, {})", preferred.x(), preferred.y(), preferred.z()),
                     "give a finite vector that is not zero.");
  const std::vector<Vec3> vectors = area_vectors(faces);
  if (const auto sum = summed(vectors)) return {-*sum, false};
  const auto seen = [&](const Vec3& direction) {
    double area = 0.0;
    for (const Vec3& v : vectors) area += std::max(0.0, -v.dot(direction));
    return area;
  };
  const Vec3 first = preferred.normalized();
  Vec3 best = first;
  for (const Vec3& axis : {Vec3(Vec3::UnitZ()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitX())})
    for (const double side : {-1.0, 1.0})
      if (seen(side * axis) > 1.000001 * seen(best)) best = side * axis;
  return {seen(first) >= 0.5 * seen(best) ? first : best, true};
}

}  // namespace patchmill
