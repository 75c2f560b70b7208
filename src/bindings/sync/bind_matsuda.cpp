// Matsuda's free form and the advisor for Python. Phases in teeth; mm, mm/s, revolutions per second.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/bindings.h"
#include "bindings/surfaces.h"
#include "patchmill/patch/advisor.h"
#include "patchmill/patch/ridge.h"
#include "patchmill/patch/surface_lattice.h"
#include "patchmill/sync/free_form_path.h"

namespace patchmill {
namespace {

int regular_corners(const std::string& shape) {
  if (!patch::is_regular(shape_of(shape)))
    throw InputError("PatchShape", shape, "the free form takes regular polygons: choose Square.");
  return patch::corners(shape_of(shape));
}

patch::MarkWish wish_of(const Tool& tool, double spindle_speed, const std::string& shape,
                        double side, const std::string& array, std::optional<double> feed_per_tooth,
                        std::optional<double> ridge_height, std::optional<double> cross_feed) {
  patch::MarkWish wish;
  wish.tool = tool;
  wish.spindle_speed = spindle_speed;
  wish.corners = regular_corners(shape);
  wish.side = side;
  wish.array = choose<patch::MarkArray>(
      "MarkArray", array,
      {{"Square", patch::MarkArray::Square}, {"Staggered", patch::MarkArray::Staggered}});
  wish.feed_per_tooth = feed_per_tooth;
  wish.ridge_height = ridge_height;
  wish.cross_feed = cross_feed;
  return wish;
}

py::dict proposal_dict(const patch::FreePatch& wished, const patch::MarkProposal& proposal) {
  py::dict d;
  d["kept"] = patch::name(proposal.kept);
  d["side"] = proposal.patch.side;
  d["cross_feed"] = proposal.patch.cross_feed;
  d["feed_per_tooth"] = proposal.patch.feed_per_tooth;
  d["feed"] = proposal.feed;
  d["ridge_height"] = proposal.ridge_height;
  d["state"] = patch::describe(proposal.state);
  d["change"] = proposal.change;
  d["changes"] = patch::describe_changes(wished, proposal);
  return d;
}

py::list advise_list(const patch::MarkWish& wish) {
  const patch::FreePatch wished = patch::wished_patch(wish);
  py::list all;
  for (const patch::MarkProposal& proposal : patch::advise(wish))
    all.append(proposal_dict(wished, proposal));
  return all;
}

patch::FreePatch patch_of(const std::string& shape, double side, double cross_feed,
                          double feed_per_tooth) {
  const patch::FreePatch patch{regular_corners(shape), side, cross_feed, feed_per_tooth};
  require_valid(patch);
  return patch;
}

py::dict size_dict(const patch::FreePatch& patch, double ball_radius) {
  const double phase = patch::mark_array(patch).first, f_z = patch.feed_per_tooth;
  const double rho = patch::covering_radius({f_z, 0.0}, {phase * f_z, patch.cross_feed});
  py::dict d;
  d["spacing"] = f_z;
  d["depth"] = patch::peak_height(ball_radius, f_z, patch.cross_feed, phase);
  d["diameter"] = 2.0 * rho;
  d["area_share"] = 1.0;
  d["ridge_height"] = patch::cusp_height(ball_radius, 0.5 * f_z);
  d["sunk"] = 0.0;
  d["least_tilt"] = std::asin(std::min(1.0, rho / ball_radius));
  return d;
}

py::object place_free_texture(const patch::FreePatch& patch, bool outward,
                              const patch::PatchDivision& stands,
                              const patch::SurfaceLattice* lattice,
                              const patch::TexturePlane& plane,
                              const patch::ProjectedSurface& sampler, bool corners_fit,
                              const py::object& progress) {
  std::optional<patch::PlacedFreeTexture> placed;
  const bool done = watched(progress, [&](const Progress& report) {
    const patch::LatticePlace place_of =
        lattice ? lattice->place_of
                : patch::LatticePlace([&](const Vec2& p) { return patch::place(stands, p); });
    const patch::SurfaceSampler sample = sampler_of(sampler);
    placed = patch::place_free(
        patch, outward ? patch::HelixOrder::Outward : patch::HelixOrder::Inward, stands, place_of,
        plane, sample, corners_fit ? patch::PlaneFit::Corners : patch::PlaneFit::BestFit, report);
  });
  if (!done || !placed) return py::none();
  return py::make_tuple(std::move(placed->texture), std::move(placed->dimples));
}

// Local points of each patch, (k, 3) in space.
template <class Points>
py::list in_space(const patch::FreeTexture& texture, const Points& local) {
  py::list list;
  for (const patch::FreeFrame& frame : texture.frames)
    list.append(rows_of(local, [&](const Vec2& p) {
      return frame.on_faces ? frame.at(p) : Vec3(Vec3::Constant(std::nan("")));
    }));
  return list;
}

py::dict phases_dict(const ToolPath& path, const patch::FreeTexture& texture,
                     const patch::Dimples& dimples, int patch) {
  const auto phases = sync::measure_phase(path, texture, dimples, patch);
  py::dict d;
  d["lap"] = column_of<std::int32_t>(phases, [](const patch::MeasuredPhase& p) { return p.lap; });
  d["side"] =
      column_of<std::int32_t>(phases, [](const patch::MeasuredPhase& p) { return p.sector; });
  d["measured"] = column_of<double>(phases, [](const patch::MeasuredPhase& p) { return p.teeth; });
  d["predicted"] = column_of<double>(phases, [&](const patch::MeasuredPhase& p) {
    return patch::phase_difference(texture.patch, p.lap, p.sector);
  });
  return d;
}

void bind_free_form(py::module_& m) {
  py::class_<patch::FreePatch>(m, "FreePatch", "Matsuda's free form: side, cross-feed, f_z [mm].")
      .def(py::init(&patch_of), py::arg("shape"), py::arg("side"), py::arg("cross_feed"),
           py::arg("feed_per_tooth"),
           "Lengths in mm. Raises InputError naming PatchShape, PatchSide, CrossFeed or "
           "FeedPerTooth.")
      .def_readonly("side", &patch::FreePatch::side)
      .def_readonly("cross_feed", &patch::FreePatch::cross_feed)
      .def_readonly("feed_per_tooth", &patch::FreePatch::feed_per_tooth)
      .def(
          "state", [](const patch::FreePatch& p) { return patch::describe(patch::mark_array(p)); },
          "The array that its marks make, in one sentence. Raises nothing.")
      .def(
          "drift_per_lap",
          [](const patch::FreePatch& p) { return patch::mark_array(p).drift_per_lap; },
          "By how much marks shift from lap to lap [teeth]. Raises nothing.")
      .def("size", &size_dict, py::arg("ball_radius"),
           "As texture_size(). Raises InputError naming BallRadius or Spacing.")
      .def("stands", &patch::stand_pattern,
           "The lattice that patches stand on, as a PatchPattern. Raises nothing.");
  py::class_<patch::FreeTexture>(m, "FreeTexture", "Patches in free form, each in its plane.")
      .def(
          "__len__", [](const patch::FreeTexture& t) { return t.frames.size(); },
          "How many patches there are. Raises nothing.")
      .def_readonly("patch", &patch::FreeTexture::patch)
      .def_property_readonly("marks_per_patch",
                             [](const patch::FreeTexture& t) { return t.marks.size(); })
      .def(
          "outlines",
          [](const patch::FreeTexture& t) { return in_space(t, patch::free_outline(t.patch)); },
          "Corners of each patch in space [mm], (k, 3); NaN if off the faces. Raises nothing.");
  m.def("place_free", &place_free_texture, py::arg("patch"), py::arg("outward"), py::arg("stands"),
        py::arg("lattice"), py::arg("plane"), py::arg("sampler"), py::arg("corners_fit"),
        py::arg("progress") = py::none(),
        "(FreeTexture, Dimples), or None if `progress` returned False. Raises nothing.");
  m.def("free_form_path",
        interruptible([](const patch::FreeTexture& texture, const patch::Dimples& dimples,
                         const Tool& tool, const Spindle& spindle, double feed, double safe_height,
                         double clearance_height, int decimals) {
          return sync::free_form_path(texture, dimples, tool, spindle,
                                      {feed, {}, safe_height, clearance_height},
                                      Decimals(decimals));
        }),
        py::arg("texture"), py::arg("dimples"), py::arg("tool"), py::arg("spindle"),
        py::arg("feed"), py::arg("safe_height"), py::arg("clearance_height"), py::arg("decimals"),
        "Straight on along the helix; `feed` [mm/s]. Raises InputError naming Dimples, Feed, "
        "FeedPerTooth, SafeHeight, ClearanceHeight or Decimals.");
  m.def("free_form_phases", &phases_dict, py::arg("path"), py::arg("texture"), py::arg("dimples"),
        py::arg("patch"),
        "Phase differences [teeth] of neighbouring passes of one patch: measured on the path, and "
        "predicted. Raises InputError naming Dimples or Patch.");
}

}  // namespace

void bind_matsuda(py::module_& m) {
  bind_free_form(m);
  py::class_<patch::MarkWish>(m, "MarkWish", "What the user wants of Matsuda's free form.")
      .def(py::init(&wish_of), py::arg("tool"), py::arg("spindle_speed"), py::arg("shape"),
           py::arg("side"), py::arg("array") = "Square", py::arg("feed_per_tooth") = py::none(),
           py::arg("ridge_height") = py::none(), py::arg("cross_feed") = py::none(),
           "Lengths in mm, speed in revolutions per second. Raises InputError naming PatchShape or "
           "MarkArray. state() and advise() refuse the rest.")
      .def(
          "state",
          [](const patch::MarkWish& w) {
            return patch::describe(patch::mark_array(patch::wished_patch(w)));
          },
          "The array that the wish itself gives, in one sentence. Raises InputError naming "
          "Lattice, SpindleSpeed, PatchSide, CrossFeed, FeedPerTooth or RidgeHeight.");
  m.def("advise", &advise_list, py::arg("wish"),
        "Aligned patches next to the wish, the one that changes least first: a list of dicts. "
        "Raises InputError naming Lattice, SpindleSpeed, PatchSide, CrossFeed, FeedPerTooth or "
        "RidgeHeight.");
}

}  // namespace patchmill
