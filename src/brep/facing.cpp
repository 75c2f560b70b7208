// Vector area of meshed faces; see facing.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "brep/facing.h"

#include "patchmill/geometry/error.h"

#include <BRepBndLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Poly_Triangulation.hxx>
#include <TopLoc_Location.hxx>

namespace patchmill {

Vec3 facing(const std::vector<TopoDS_Face>& faces) {
  Vec3 sum = Vec3::Zero();
  double area = 0.0;
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
      const Vec3 cross = (at(b) - at(a)).cross(at(c) - at(a));
      sum += sense * cross;
      area += 0.5 * cross.norm();
    }
  }
  if (!(sum.norm() > 0.01 * area))
    throw InputError("AutoDirection", "true",
                     "the faces look to all sides alike: switch it off and give a direction.");
  return sum.normalized();
}

}  // namespace patchmill
