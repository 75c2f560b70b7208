// Reading BREP text; see read_shape.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "brep/read_shape.h"

#include "patchmill/geometry/error.h"

#include <sstream>

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

namespace patchmill {

TopoDS_Shape read_shape(const std::string& brep, const char* property) {
  TopoDS_Shape shape;
  try {
    std::istringstream in(brep);
    BRepTools::Read(shape, in, BRep_Builder());
  } catch (const Standard_Failure& e) {
    throw InputError(property, e.GetMessageString(), "the shape could not be read: repair it.");
  }
  if (shape.IsNull()) throw InputError(property, "no shape", "give a shape with faces.");
  return shape;
}

std::vector<TopoDS_Face> read_faces(const std::string& brep) {
  const TopoDS_Shape shape = read_shape(brep, "Base");
  std::vector<TopoDS_Face> faces;
  for (TopExp_Explorer e(shape, TopAbs_FACE); e.More(); e.Next())
    faces.push_back(TopoDS::Face(e.Current()));
  if (faces.empty())
    throw InputError("Base", "a shape without faces", "select a face, not an edge or a vertex.");
  return faces;
}

}  // namespace patchmill
