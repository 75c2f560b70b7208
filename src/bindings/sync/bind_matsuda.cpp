// Matsuda's free form and the advisor for Python. Phases in teeth; mm, mm/s, revolutions per second.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/bindings.h"
#include "brep/face_sampler.h"
#include "patchmill/patch/advisor.h"
#include "patchmill/patch/ridge.h"
#include "patchmill/patch/surface_lattice.h"
#include "patchmill/sync/free_form_path.h"

namespace patchmill {
namespace {

MarkWish wish_of(const BallEndMill& tool, double spindle_speed, const std::string& shape,
                 double side, const std::string& array, std::optional<double> feed_per_tooth,
                 std::optional<double> ridge_height, std::optional<double> cross_feed) {
  MarkWish wish;
  wish.tool = tool;
  wish.spindle_speed = spindle_speed;
  wish.corners = corners(shape_of(shape));
  wish.side = side;
  wish.array = choose<MarkArray>(
      "MarkArray", array, {{"Square", MarkArray::Square}, {"Staggered", MarkArray::Staggered}});
  wish.feed_per_tooth = feed_per_tooth;
  wish.ridge_height = ridge_height;
  wish.cross_feed = cross_feed;
  return wish;
}

py::dict proposal_dict(const FreePatch& wished, const MarkProposal& proposal) {
  py::dict d;
  d["kept"] = name(proposal.kept);
  d["side"] = proposal.patch.side;
  d["cross_feed"] = proposal.patch.cross_feed;
  d["feed_per_tooth"] = proposal.patch.feed_per_tooth;
  d["feed"] = proposal.feed;
  d["ridge_height"] = proposal.ridge_height;
  d["state"] = describe(proposal.state);
  d["change"] = proposal.change;
  d["changes"] = describe_changes(wished, proposal);
  return d;
}

py::list advise_list(const MarkWish& wish) {
  const FreePatch wished = wished_patch(wish);
  py::list all;
  for (const MarkProposal& proposal : advise(wish)) all.append(proposal_dict(wished, proposal));
  return all;
}

FreePatch patch_of(const std::string& shape, double side, double cross_feed,
                   double feed_per_tooth) {
  const FreePatch patch{corners(shape_of(shape)), side, cross_feed, feed_per_tooth};
  require_valid(patch);
  return patch;
}

py::dict size_dict(const FreePatch& patch, double ball_radius) {
  const double phase = mark_array(patch).first, f_z = patch.feed_per_tooth;
  const double rho = covering_radius({f_z, 0.0}, {phase * f_z, patch.cross_feed});
  py::dict d;
  d["spacing"] = f_z;
  d["depth"] = peak_height(ball_radius, f_z, patch.cross_feed, phase);
  d["diameter"] = 2.0 * rho;
  d["area_share"] = 1.0;
  d["ridge_height"] = cusp_height(ball_radius, 0.5 * f_z);
  d["sunk"] = 0.0;
  d["least_tilt"] = std::asin(std::min(1.0, rho / ball_radius));
  return d;
}

py::object place_free_texture(const FreePatch& patch, bool outward, const PatchDivision& stands,
                              const SurfaceLattice* lattice, const TexturePlane& plane,
                              const FaceSampler& sampler, bool corners_fit,
                              const py::object& progress) {
  const Progress report = progress_of(progress);
  std::optional<PlacedFreeTexture> placed;
  {
    const py::gil_scoped_release release;
    const LatticePlace place_of =
        lattice ? lattice->place_of : LatticePlace([&](const Vec2& p) { return place(stands, p); });
    const SurfaceSampler sample = [&](const std::vector<Vec2>& at) { return sampler.sample(at); };
    placed = place_free(patch, outward ? HelixOrder::Outward : HelixOrder::Inward, stands, place_of,
                        plane, sample, corners_fit ? PlaneFit::Corners : PlaneFit::BestFit, report);
  }
  if (!placed) return py::none();
  return py::make_tuple(std::move(placed->texture), std::move(placed->dimples));
}

// Local points of each patch, (k, 3) in space.
template <class Points>
py::list in_space(const FreeTexture& texture, const Points& local) {
  py::list list;
  for (const FreeFrame& frame : texture.frames)
    list.append(rows_of(local, [&](const Vec2& p) {
      return frame.on_faces ? frame.at(p) : Vec3(Vec3::Constant(std::nan("")));
    }));
  return list;
}

py::dict phases_dict(const ToolPath& path, const FreeTexture& texture, const Dimples& dimples,
                     int patch) {
  const auto phases = measure_phase(path, texture, dimples, patch);
  py::dict d;
  d["lap"] = column_of<std::int32_t>(phases, [](const MeasuredPhase& p) { return p.lap; });
  d["side"] = column_of<std::int32_t>(phases, [](const MeasuredPhase& p) { return p.sector; });
  d["measured"] = column_of<double>(phases, [](const MeasuredPhase& p) { return p.teeth; });
  d["predicted"] = column_of<double>(phases, [&](const MeasuredPhase& p) {
    return phase_difference(texture.patch, p.lap, p.sector);
  });
  return d;
}

void bind_free_form(py::module_& m) {
  py::class_<FreePatch>(m, "FreePatch", "Matsuda's free form: side, cross-feed, f_z [mm].")
      .def(py::init(&patch_of), py::arg("shape"), py::arg("side"), py::arg("cross_feed"),
           py::arg("feed_per_tooth"))
      .def_readonly("side", &FreePatch::side)
      .def_readonly("cross_feed", &FreePatch::cross_feed)
      .def_readonly("feed_per_tooth", &FreePatch::feed_per_tooth)
      .def("state", [](const FreePatch& p) { return describe(mark_array(p)); })
      .def("drift_per_lap", [](const FreePatch& p) { return mark_array(p).drift_per_lap; })
      .def("size", &size_dict, py::arg("ball_radius"), "As texture_size().")
      .def("stands", &stand_pattern, "The lattice that patches stand on, as a PatchPattern.");
  py::class_<FreeTexture>(m, "FreeTexture", "Patches in free form, each in its plane.")
      .def("__len__", [](const FreeTexture& t) { return t.frames.size(); })
      .def_readonly("patch", &FreeTexture::patch)
      .def_property_readonly("marks_per_patch", [](const FreeTexture& t) { return t.marks.size(); })
      .def(
          "outlines", [](const FreeTexture& t) { return in_space(t, free_outline(t.patch)); },
          "Corners of each patch in space [mm], (k, 3); NaN if off the faces.");
  m.def("place_free", &place_free_texture, py::arg("patch"), py::arg("outward"), py::arg("stands"),
        py::arg("lattice"), py::arg("plane"), py::arg("sampler"), py::arg("corners_fit"),
        py::arg("progress") = py::none(),
        "(FreeTexture, Dimples), or None if `progress` returned False.");
  m.def(
      "free_form_path",
      [](const FreeTexture& texture, const Dimples& dimples, const BallEndMill& tool,
         const Spindle& spindle, double feed, double safe_height, double clearance_height,
         int decimals) {
        return free_form_path(texture, dimples, tool, spindle,
                              {feed, {}, safe_height, clearance_height}, Decimals(decimals));
      },
      py::arg("texture"), py::arg("dimples"), py::arg("tool"), py::arg("spindle"), py::arg("feed"),
      py::arg("safe_height"), py::arg("clearance_height"), py::arg("decimals"),
      py::call_guard<py::gil_scoped_release>(), "Straight on along the helix; `feed` [mm/s].");
  m.def("free_form_phases", &phases_dict, py::arg("path"), py::arg("texture"), py::arg("dimples"),
        py::arg("patch"),
        "Phase differences [teeth] of neighbouring passes of one patch: measured on the path, and "
        "predicted.");
}

}  // namespace

void bind_matsuda(py::module_& m) {
  bind_free_form(m);
  py::class_<MarkWish>(m, "MarkWish", "What the user wants of Matsuda's free form.")
      .def(py::init(&wish_of), py::arg("tool"), py::arg("spindle_speed"), py::arg("shape"),
           py::arg("side"), py::arg("array") = "Square", py::arg("feed_per_tooth") = py::none(),
           py::arg("ridge_height") = py::none(), py::arg("cross_feed") = py::none())
      .def(
          "state", [](const MarkWish& w) { return describe(mark_array(wished_patch(w))); },
          "The array that the wish itself gives, in one sentence.");
  m.def("advise", &advise_list, py::arg("wish"),
        "Aligned patches next to the wish, the one that changes least first: a list of dicts.");
}

}  // namespace patchmill
