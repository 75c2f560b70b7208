// Vector area of meshed faces; see facing.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "brep/facing.h"

#include "patchmill/geometry/error.h"

#include <cmath>

#include <BRepBndLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Poly_Triangulation.hxx>
#include <TopLoc_Location.hxx>

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

}  // namespace

Vec3 facing(const std::vector<TopoDS_Face>& faces) {
  const auto sum = patch::summed_normal(area_vectors(faces));
  if (!sum)
    throw InputError("AutoDirection", "true",
                     "the faces look to all sides alike: switch it off and give a direction.");
  return *sum;
}

patch::SeenBest seen_best(const std::vector<TopoDS_Face>& faces, const Vec3& preferred) {
  return patch::seen_best(area_vectors(faces), preferred);
}

}  // namespace patchmill
