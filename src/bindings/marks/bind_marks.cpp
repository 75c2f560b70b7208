// The cutter-mark simulator for Python: motions, reliefs, the dimples found. Angles in radians.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/bindings.h"
#include "bindings/surfaces.h"
#include "patchmill/geometry/require.h"
#include "patchmill/machine/kinematics.h"
#include "patchmill/marks/alignment.h"
#include "patchmill/marks/machine_motion.h"
#include "patchmill/marks/texture_marks.h"
#include "patchmill/sync/phase_rule.h"

namespace patchmill {
namespace {

using Rows2 = Eigen::Matrix<double, -1, 2>;
using Rows3 = Eigen::Matrix<double, -1, 3>;

template <class Items, class Get>
py::array_t<double> pairs_of(const Items& items, Get get) {
  py::array_t<double> array({static_cast<py::ssize_t>(items.size()), py::ssize_t{2}});
  auto out = array.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < out.shape(0); ++i) {
    const Vec2 v = get(items[static_cast<std::size_t>(i)]);
    out(i, 0) = v.x();
    out(i, 1) = v.y();
  }
  return array;
}

marks::ToolMotion motion_of_path(const ToolPath& path, const patch::Dimples& dimples,
                                 const sync::PhaseRule& rule, std::optional<double> start_phase,
                                 const std::optional<Rows3>& housing) {
  marks::MotionOptions options;
  if (housing)
    for (Eigen::Index i = 0; i < housing->rows(); ++i) options.housing_x.push_back(housing->row(i));
  if (start_phase)
    options.start_phase = Angle::radians(*start_phase);
  else
    options.wanted_phase = sync::wanted_phases(dimples, rule, path.spindle);
  return marks::motion_of(path, options);
}

marks::ToolMotion motion_of_samples(const Eigen::VectorXd& time, const Rows3& tips,
                                    const Eigen::VectorXd& angle, const Spindle& spindle,
                                    double radius, const std::optional<Rows3>& axes) {
  const auto n = time.size();
  if (tips.rows() != n || angle.size() != n || (axes && axes->rows() != n))
    throw InputError("Samples", "arrays of different length", "give one row for each moment.");
  std::vector<marks::MotionSample> samples(static_cast<std::size_t>(n));
  for (Eigen::Index i = 0; i < n; ++i) {
    marks::MotionSample& sample = samples[static_cast<std::size_t>(i)];
    sample.time = time[i];
    sample.tip = tips.row(i);
    sample.spindle_angle = angle[i];
    if (axes) sample.axis = unit_along("Axis", axes->row(i));
  }
  return marks::motion_of(samples, spindle.sense, radius);
}

/// What the heights are measured from: faces, the planes of patches, or the texture plane (None).
marks::BaseMaker base_maker(const py::object& base, const patch::TexturePlane& plane,
                            double reach) {
  if (base.is_none()) return {};
  if (!py::isinstance<patch::Dimples>(base) && !py::isinstance<patch::ProjectedSurface>(base))
    throw InputError("Base", py::str(base), "give a FaceSampler, a MeshSampler, Dimples or None.");
  if (py::isinstance<patch::Dimples>(base))
    return marks::base_of_patches(base.cast<const patch::Dimples&>(), plane, reach);
  return marks::base_on(
      sampler_of(base.cast<const patch::ProjectedSurface&>()));  // outlives the call
}

marks::TextureMarks simulate(const marks::ToolMotion& motion, const Tool& tool,
                             const patch::TexturePlane& plane, const Vec2& low, const Vec2& high,
                             double step, double stock, const py::object& base, double reach,
                             double helix, const std::vector<double>& runout, double least_depth,
                             double halo, double memory_limit, const py::object& progress) {
  const marks::BaseMaker maker = base_maker(base, plane, reach);
  marks::TextureMarkOptions options;
  options.marks = {stock, memory_limit};
  options.find.least_depth = least_depth;
  options.halo = halo;
  marks::TextureMarks made;
  const bool done = watched(progress, [&](const Progress& report) {
    made =
        marks::simulate_texture(motion, {tool, Angle::radians(helix), runout},
                                marks::flat_grid(plane, low, high, step), maker, options, report);
  });
  if (!done) made.complete = false;
  return made;
}

/// Every `stride`-th cell of a block of the grid as points on the relief.
py::tuple surface(const marks::TextureMarks& marks, const py::object& base, double reach, int row,
                  int rows, int column, int columns, int stride) {
  const marks::SurfaceGrid& grid = marks.grid;
  if (stride < 1 || row < 0 || column < 0 || rows < 1 || columns < 1 || row > grid.rows - rows ||
      column > grid.columns - columns)
    throw InputError("Block", "outside the relief", "give rows and columns of the relief.");
  marks::SurfaceGrid block;
  block.plane = grid.plane;
  block.first = grid.plane_point(column, row);
  block.step = grid.step * stride;
  block.columns = (columns - 1) / stride + 1;
  block.rows = (rows - 1) / stride + 1;
  const marks::BaseMaker maker = base_maker(base, grid.plane, reach);
  py::array_t<double> points({block.rows, block.columns, 3});
  py::array_t<float> heights({block.rows, block.columns});
  auto p = points.mutable_unchecked<3>();
  auto h = heights.mutable_unchecked<2>();
  const py::gil_scoped_release release;
  if (maker) block = maker(std::move(block));
  for (int j = 0; j < block.rows; ++j)
    for (int i = 0; i < block.columns; ++i) {
      h(j, i) =
          marks
              .height[static_cast<std::size_t>(grid.number(column + i * stride, row + j * stride))];
      const Vec3 at = marks::base_point(block, i, j) + h(j, i) * marks::base_normal(block, i, j);
      for (int k = 0; k < 3; ++k) p(j, i, k) = at[k];
    }
  const py::gil_scoped_acquire acquire;
  return py::make_tuple(points, heights);
}

py::dict compare_dict(const marks::TextureMarks& marks, const patch::Dimples& dimples,
                      const Vec2& low, const Vec2& high, double spacing) {
  marks::WindowComparison window;
  watched(py::none(), [&](const Progress&) {
    window = marks::compare_window(marks.dimples, marks::planned_places(dimples, marks.grid.plane),
                                   low, high, spacing);
  });
  const marks::PlanComparison& c = window.comparison;
  py::dict d;
  d["dimple"] =
      column_of<std::int32_t>(c.matches, [](const marks::DimpleMatch& m) { return m.dimple; });
  d["found"] =
      column_of<std::int32_t>(c.matches, [](const marks::DimpleMatch& m) { return m.found; });
  d["moved"] = pairs_of(c.matches, [](const marks::DimpleMatch& m) { return m.moved; });
  d["extra"] = column_of<std::int32_t>(c.extra, [](std::int32_t k) { return k; });
  const auto& f = window.found;
  d["places"] = pairs_of(f, [](const marks::DimpleMark& m) { return m.place; });
  d["points"] = rows_of(f, [](const marks::DimpleMark& m) { return m.point; });
  d["bottoms"] = column_of<double>(f, [](const marks::DimpleMark& m) { return m.bottom; });
  d["depths"] = column_of<double>(f, [](const marks::DimpleMark& m) { return m.depth; });
  d["diameters"] = column_of<double>(f, [](const marks::DimpleMark& m) { return m.diameter; });
  d["at_edge"] = column_of<bool>(f, [](const marks::DimpleMark& m) { return m.at_edge; });
  d["mean_spacing"] = marks::mean_spacing(f);
  d["missing"] = c.missing;
  d["mean_move"] = c.mean_move;
  d["rms_move"] = c.rms_move;
  d["largest_move"] = c.largest_move;
  d["mean_depth"] = c.mean_depth;
  d["depth_deviation"] = c.depth_deviation;
  d["quality"] = c.quality;
  return d;
}

py::dict alignment_dict(const Rows2& places, const Vec2& feed, double feed_per_tooth,
                        double cross_feed) {
  std::vector<Vec2> list;
  for (Eigen::Index i = 0; i < places.rows(); ++i) list.emplace_back(places.row(i));
  const marks::AlignmentResult result =
      marks::classify_alignment(list, {feed, feed_per_tooth, cross_feed});
  py::dict d;
  d["state"] = name(result.state);
  d["shift"] = result.shift;
  d["agreement"] = result.agreement;
  d["row_agreement"] = result.row_agreement;
  d["rows"] = result.rows.size();
  return d;
}

void bind_motion(py::module_& m) {
  py::class_<marks::ToolMotion>(m, "ToolMotion", "Where the ball is at every spindle angle.")
      .def_property_readonly("runs", [](const marks::ToolMotion& v) { return v.runs.size(); })
      .def_readonly("untimed_moves", &marks::ToolMotion::untimed_moves)
      .def_readonly("standing_moves", &marks::ToolMotion::standing_moves);
  m.def("motion_of_path", &motion_of_path, py::arg("path"), py::arg("dimples"), py::arg("rule"),
        py::arg("start_phase") = py::none(), py::arg("housing") = py::none(),
        "The motion of a path; `start_phase` [rad] of flute 0, or None: right at the first dimple "
        "of every run. `housing`: see housing_x; None for an upright tool. Raises InputError "
        "naming StartPhase or HousingAxis.");
  m.def(
      "housing_x",
      [](const machine::Kinematics& machine, const Rows2& joints) {
        if (!joints.allFinite()) throw InputError("Joints", "not finite", "give finite angles.");
        std::vector<Vec3> x;
        for (Eigen::Index i = 0; i < joints.rows(); ++i)
          x.push_back(machine::housing_to_work(machine, {joints(i, 0), joints(i, 1)}) *
                      Vec3::UnitX());
        return rows_of(x, [](const Vec3& v) { return v; });
      },
      py::arg("machine"), py::arg("joints"),
      "Azimuth 0 of the spindle's housing in the work frame, (n, 3), for (n, 2) angles [rad]. "
      "Raises InputError naming Joints.");
  m.def("motion_of_samples", &motion_of_samples, py::arg("time"), py::arg("tips"),
        py::arg("spindle_angle"), py::arg("spindle"), py::arg("radius"),
        py::arg("axes") = py::none(),
        "The motion of a recording: [s], (n, 3) [mm], azimuth of flute 0 [rad] unwrapped. Raises "
        "InputError naming Samples, Time, Tip, SpindleAngle, BallRadius or Axis.");
  m.def(
      "path_on_machine",
      [](const ToolPath& path, const machine::MotionModel& model) {
        marks::MachinePath made = marks::path_on_machine(path, model);
        return py::make_tuple(made.known, made.reason, std::move(made.path));
      },
      py::arg("path"), py::arg("model"),
      "(known, reason why not, the path with the turns that the motion model predicts). Raises "
      "nothing.");
  m.def(
      "best_start_phase",
      [](const ToolPath& path, const patch::Dimples& dimples, const sync::PhaseRule& rule) {
        return marks::best_start_phase(path, sync::wanted_phases(dimples, rule, path.spindle),
                                       sync::phase_period(path.tool.flutes, rule.flutes))
            .radians();
      },
      py::arg("path"), py::arg("dimples"), py::arg("rule"),
      "Azimuth of flute 0 at the start [rad] that takes the mean phase error away. Raises "
      "InputError naming SpindleTurns.");
}

}  // namespace

void bind_marks(py::module_& m) {
  bind_motion(m);
  py::class_<marks::TextureMarks>(m, "TextureMarks",
                                  "The relief of a texture and the dimples found in it.")
      .def_property_readonly(
          "heights",
          [](py::object self) {
            const auto& marks = self.cast<const marks::TextureMarks&>();
            return py::array_t<float>({marks.grid.rows, marks.grid.columns}, marks.height.data(),
                                      self);
          },
          "Deviation from the base along its normal [mm], (rows, columns); NaN: no base.")
      .def_property_readonly(
          "first", [](const marks::TextureMarks& v) { return v.grid.first; },
          "Plane coordinates of cell [0, 0] [mm].")
      .def_property_readonly("step", [](const marks::TextureMarks& v) { return v.grid.step; })
      .def_readonly("stock", &marks::TextureMarks::stock)
      .def_readonly("complete", &marks::TextureMarks::complete)
      .def_property_readonly("passes",
                             [](const marks::TextureMarks& v) { return v.statistics.passes; })
      .def_property_readonly("evaluations",
                             [](const marks::TextureMarks& v) { return v.statistics.evaluations; })
      .def("surface", &surface, py::arg("base"), py::arg("reach"), py::arg("row"), py::arg("rows"),
           py::arg("column"), py::arg("columns"), py::arg("stride"),
           "(points (r, c, 3) [mm], heights (r, c)) of a block, every `stride`-th cell. Raises "
           "InputError naming Base, Reach or Block.");
  m.def("simulate_texture", &simulate, py::arg("motion"), py::arg("tool"), py::arg("plane"),
        py::arg("low"), py::arg("high"), py::arg("step"), py::arg("stock"),
        py::arg("base") = py::none(), py::arg("reach") = 1.0, py::arg("helix") = 0.0,
        py::arg("runout") = std::vector<double>{}, py::arg("least_depth") = 0.002,
        py::arg("halo") = 1.0, py::arg("memory_limit") = 4e9, py::arg("progress") = py::none(),
        "The relief over `low` to `high` of the plane [mm] and its dimples; `base`: a "
        "ProjectedSurface, "
        "Dimples (the planes of patches), or None (the plane). Raises InputError naming Base, "
        "Reach, HelixAngle, Runout, LeastDepth, Halo, Memory, GridSize, GridStep or Stock.");
  m.def("compare_window", &compare_dict, py::arg("marks"), py::arg("dimples"), py::arg("low"),
        py::arg("high"), py::arg("spacing"),
        "The dimples of a window and how they compare with the plan: arrays and figures. Raises "
        "InputError naming Window or Spacing.");
  m.def("classify_alignment", &alignment_dict, py::arg("places"), py::arg("feed"),
        py::arg("feed_per_tooth"), py::arg("cross_feed"),
        "How marks line up along rows: state, shift, agreement. Raises InputError naming Places, "
        "FeedDirection, FeedPerTooth or CrossFeed.");
}

}  // namespace patchmill
