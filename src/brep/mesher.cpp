// The mesher, and how many triangles it will make; see mesher.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "brep/mesher.h"

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/stop.h"

#include <algorithm>
#include <cmath>

#include <BRepBndLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Message_ProgressIndicator.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <fmt/format.h>
#include <tbb/task.h>

namespace patchmill {
namespace {

constexpr double kFine =
    1e-5;  // of the shape's size: coarser deflections make no great number of triangles
constexpr double kFirst = 1e-3;  // of the shape's size: the first that is tried
constexpr double kFiner = 8.0;   // times, from trial to trial
constexpr double kSlow =
    2.5e-5;  // of the shape's size: below, the mesher's own meshes take too long
constexpr double kCoarse = 1e-4;  // of the shape's size: what is made instead
constexpr double kSurely =
    1.1;  // times the deflection that would do, for small features join in later

/// Tells the mesher to stop when the work that it is part of is to: its own threads do not know what they are part of.
class StopOfMesher : public Message_ProgressIndicator {
 public:
  Standard_Boolean UserBreak() override { return work_ && work_->is_group_execution_cancelled(); }
  void Show(const Message_ProgressScope&, const Standard_Boolean) override {}

 private:
  tbb::task_group_context* work_ = tbb::task::current_context();
};

void mesh(const TopoDS_Shape& shape, double deflection, Angle angle) {
  BRepTools::Clean(shape);
  IMeshTools_Parameters parameters;
  parameters.Deflection = deflection;
  parameters.Angle = angle.radians();
  parameters.InParallel = true;
  BRepMesh_IncrementalMesh mesher;
  mesher.SetShape(shape);
  mesher.ChangeParameters() = parameters;
  const Handle(StopOfMesher) stop = new StopOfMesher;
  mesher.Perform(stop->Start());
  stop_point();
}

double triangles(const TopoDS_Shape& shape) {
  double count = 0.0;
  for (TopExp_Explorer e(shape, TopAbs_FACE); e.More(); e.Next()) {
    TopLoc_Location location;
    const Handle(Poly_Triangulation) found =
        BRep_Tool::Triangulation(TopoDS::Face(e.Current()), location);
    if (!found.IsNull()) count += found->NbTriangles();
  }
  return count;
}

double size_of(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box, false);
  return box.IsVoid() ? 0.0 : std::sqrt(box.SquareExtent());
}

void require_few(const TopoDS_Shape& shape, double size, double deflection, Angle angle,
                 double most) {
  if (!(deflection < kFine * size)) return;
  double at = kFirst * size, before = 0.0;
  for (; at > kCoarse * size; at /= kFiner) {
    mesh(shape, at, angle);
    const double count = triangles(shape);
    // a trial that makes no more than the one before says nothing of those to come
    const double power =
        before > 0.0 ? std::log(std::max(1.0, count / before)) / std::log(kFiner) : 0.0;
    const double foreseen = count * std::pow(at / deflection, power);
    if (foreseen > most)
      throw InputError(
          "Deflection",
          fmt::format("{:.3g} mm, about {:.3g} million triangles", deflection, 1e-6 * foreseen),
          fmt::format("at most about {:.3g} million are made: give {:.3g} mm or more.", 1e-6 * most,
                      kSurely * at * (power > 0.0 ? std::pow(count / most, 1.0 / power) : 1.0)));
    before = count;
  }
}

}  // namespace

double mesh_faces(const TopoDS_Shape& shape, double deflection, Angle angle, double most) {
  const double size = size_of(shape);
  require_few(shape, size, deflection, angle, most);
  const double made = deflection < kSlow * size ? kCoarse * size : deflection;
  mesh(shape, made, angle);
  return made;
}

}  // namespace patchmill
