// Paths through the voxel model, and copy milling, for Python.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/bindings.h"
#include "bindings/solid.h"
#include "bindings/voxel/voxel_materials.h"
#include "patchmill/collision/clear_axis.h"
#include "patchmill/copy/chosen_faces.h"
#include "patchmill/copy/copy_milling.h"
#include "patchmill/copy/live_session.h"
#include "patchmill/copy/plunge_feed.h"
#include "patchmill/dcm/air_cuts.h"
#include "patchmill/dcm/apply_dcm.h"
#include "patchmill/geometry/require.h"

namespace patchmill {
namespace {

using Sections = std::vector<std::array<double, 4>>;

std::vector<collision::HolderSection> holder_of(const Sections& sections) {
  std::vector<collision::HolderSection> holder;
  for (const auto& s : sections) holder.push_back({s[0], s[1], s[2], s[3]});
  return holder;
}

collision::ClearOptions clear_options(double clearance, double lowest) {
  collision::ClearOptions options;
  options.clearance = clearance;
  options.resolution = std::max(0.02, 0.1 * clearance);
  options.lowest = Angle::radians(lowest);
  return options;
}

dcm::DcmOptions dcm_options(const std::string& reading, const std::string& read_at,
                            double feed_tolerance, double axis_tolerance, double axis_rate,
                            double acceleration) {
  dcm::DcmOptions options;
  if (reading != "Smooth" && reading != "Staircase")
    throw InputError("Reading", "'" + reading + "'", "give Smooth or Staircase.");
  if (read_at != "Ball centre" && read_at != "Tip")
    throw InputError("ReadAt", "'" + read_at + "'", "give Ball centre or Tip.");
  options.reading = reading == "Smooth" ? dcm::Reading::Trilinear : dcm::Reading::Nearest;
  options.read_at = read_at == "Tip" ? dcm::ReadAt::Tip : dcm::ReadAt::BallCentre;
  options.feed_tolerance = feed_tolerance;
  options.axis_tolerance = Angle::radians(axis_tolerance);
  options.axis_rate = axis_rate;
  options.acceleration = acceleration;
  return options;
}

py::array_t<std::int64_t> source_array(const std::vector<std::int64_t>& source) {
  return column_of<std::int64_t>(source, [](std::int64_t v) { return v; });
}

py::tuple apply(const ToolPath& path, const voxel::VoxelGrid& grid, const dcm::FeedField* feed,
                const dcm::PostureField* posture, const Solid* part, const Sections& holder,
                double clearance, double lowest, const std::string& reading,
                const std::string& read_at, double feed_tolerance, double axis_tolerance,
                double axis_rate, double acceleration) {
  dcm::DcmOptions options =
      dcm_options(reading, read_at, feed_tolerance, axis_tolerance, axis_rate, acceleration);
  const auto sections = holder_of(holder);
  const collision::ClearOptions limits = clear_options(clearance, lowest);
  std::int64_t not_clear = 0;
  if (part && !sections.empty())
    options.axis_rule = [&](const Vec3& centre, const Vec3& wanted) {
      const collision::ClearAxis found =
          collision::clear_axis(part->bvh, sections, centre, wanted, limits);
      not_clear += found.clear ? 0 : 1;
      return found.axis;
    };
  std::vector<std::int64_t> source;
  ToolPath out;
  watched(py::none(), [&](const Progress&) {
    out = dcm::apply_dcm(path, grid, feed, posture, options, &source);
  });
  return py::make_tuple(std::move(out), source_array(source), not_clear);
}

py::dict steps_dict(const ToolPath& path) {
  const dcm::PathSteps s = dcm::path_steps(path);
  py::dict d;
  d["feed"] = s.feed;
  d["feed_at_corners"] = s.feed_at_corners;
  d["axis_per_move"] = s.axis_per_move.radians();
  d["axis_at_rest"] = s.axis_at_rest.radians();
  d["axis_rate"] = s.axis_rate;
  d["moves"] = s.moves;
  return d;
}

py::dict clearance_dict(const Solid& part, const Sections& holder, const ToolPath& path,
                        double clearance, double step) {
  collision::PathClearance found;
  watched(py::none(), [&](const Progress&) {
    found = collision::path_clearance(part.bvh, holder_of(holder), path,
                                      clear_options(clearance, kPi), step);
  });
  py::dict d;
  d["least"] = found.least;
  d["move"] = found.move;
  d["too_near"] = found.too_near;
  return d;
}

ToolPath joined(const std::vector<ToolPath>& paths) {
  if (paths.empty()) throw InputError("path", "none", "give one or more paths.");
  ToolPath out = paths.front();
  for (std::size_t i = 1; i < paths.size(); ++i) {
    Move over;  // from the end of one to the start of the next: both are clear of the stock
    over.end = paths[i].start;
    out.moves.push_back(over);
    out.moves.insert(out.moves.end(), paths[i].moves.begin(), paths[i].moves.end());
  }
  return out;
}

copy::CopyMode copy_mode(const std::string& name) {
  if (name == "Scanning") return copy::CopyMode::Scanning;
  if (name == "Scanning with undercuts") return copy::CopyMode::ScanningUndercut;
  if (name == "Contour") return copy::CopyMode::Contour;
  throw InputError("Mode", "'" + name + "'", "give Scanning, Scanning with undercuts, or Contour.");
}

void bind_copy(py::module_& m) {
  py::class_<copy::CopyOptions>(m, "CopyOptions", "What copy_mill needs beside the part. mm, s.")
      .def(py::init([](const std::string& mode, const Tool& tool, const Spindle& spindle,
                       double feed, double radial_depth, double axial_depth, double tolerance,
                       double allowance, const Vec3& low, const Vec3& high, double clearance,
                       double overlap) {
             copy::CopyOptions o;
             o.mode = copy_mode(mode);
             o.tool = tool;
             o.spindle = spindle;
             o.feed = feed;
             o.radial_depth = radial_depth;
             o.axial_depth = axial_depth;
             o.tolerance = tolerance;
             o.allowance = allowance;
             o.stock.include(low);
             o.stock.include(high);
             o.clearance = clearance;
             o.overlap = overlap;
             return o;
           }),
           py::arg("mode"), py::arg("tool"), py::arg("spindle"), py::arg("feed"),
           py::arg("radial_depth"), py::arg("axial_depth"), py::arg("tolerance"),
           py::arg("allowance"), py::arg("low"), py::arg("high"), py::arg("clearance"),
           py::arg("overlap") = 0.0,
           "`mode`: Scanning, Scanning with undercuts or Contour; `feed` [mm/s], lengths in mm; "
           "the stock is the box from `low` to `high`. Raises InputError naming Mode. copy_mill "
           "refuses the rest.");
  m.def(
      "copy_mill",
      [](const Solid& part, const copy::CopyOptions& options, const py::object& progress) {
        copy::CopiedPath made;
        const bool done = watched(progress, [&](const Progress& report) {
          made = copy::copy_mill(part.bvh, options, report);
        });
        if (!done) made = {};
        return std::make_pair(std::move(made.path), made.out_of_reach);
      },
      py::arg("part"), py::arg("options"), py::arg("progress") = py::none(),
      "(ToolPath of a ball end mill over the part, layer by layer from the stock; how many lines "
      "cannot be reached from above and were left out). If progress(share) returns False: what was "
      "done so far. Raises InputError naming tool radius, feed, radial depth of cut, axial depth "
      "of "
      "cut, depth of cut, tolerance, allowance, stock, clearance or overlap.");
  m.def(
      "over_faces",
      [](const ToolPath& path, const Solid& part, const Solid& faces,
         const copy::CopyOptions& options, const py::object& progress) {
        ToolPath made;
        const bool done = watched(progress, [&](const Progress& report) {
          made = copy::over_faces(path, part.bvh, faces.bvh, options, report);
        });
        return done ? made : ToolPath();
      },
      py::arg("path"), py::arg("part"), py::arg("faces"), py::arg("options"),
      py::arg("progress") = py::none(),
      "Of a path that copy_mill made of `part` with `options`, the cuts on which the ball works on "
      "`faces`; all else is left out. If progress(share) returns False: what was done so far. "
      "Raises nothing.");
  m.def("with_plunge_feed", interruptible(&copy::with_plunge_feed), py::arg("path"),
        py::arg("vertical"),
        "The path with no timed move going down faster than `vertical` [mm/s]. Raises InputError "
        "naming VertFeed.");
  m.def("joined", &joined, py::arg("paths"),
        "Paths one after the other, a rapid between; tool and spindle are the first one's. Raises "
        "InputError naming path.");
  m.def(
      "scallop_height",
      [](double radius, double cross_feed) {
        require_positive("BallRadius", radius, "mm");
        require_in_range("CrossFeed", cross_feed, 0.0, 1e6, "mm");
        return scallop_height(Tool{radius, 1}, cross_feed);
      },
      py::arg("radius"), py::arg("cross_feed"),
      "Ridge on a flat between passes [mm]; the radius where the ball does not reach between them. "
      "Raises InputError naming BallRadius or CrossFeed.");
}

copy::LiveConditions changed(const copy::LiveConditions& now, const std::optional<double>& radial,
                             const std::optional<double>& axial, const std::optional<double>& low,
                             const std::optional<double>& high) {
  return {radial.value_or(now.radial_depth),
          axial.value_or(now.axial_depth),
          {low.value_or(now.feed.low), high.value_or(now.feed.high)}};
}

void bind_live(py::module_& m) {
  py::class_<copy::LiveSession>(m, "LiveSession", "Copy milling made while the tool cuts. mm, s.")
      .def(py::init([](const Solid& part, const voxel::VoxelGrid& grid,
                       const copy::CopyOptions& options, double low, double high,
                       const VoxelMaterials* materials, const std::vector<double>& factors) {
             dcm::FeedFactors found;
             if (materials) found = {materials->number, factors};
             return copy::LiveSession(part.bvh, grid, options, {low, high}, {}, std::move(found));
           }),
           py::arg("part"), py::arg("grid"), py::arg("options"), py::arg("low"), py::arg("high"),
           py::arg("materials") = nullptr, py::arg("factors") = std::vector<double>(),
           py::keep_alive<1, 2>(), py::keep_alive<1, 3>(),
           "V_Lo and V_Hi in mm/s; `factors` on the feed, the stock's own first, as scale_feed's. "
           "Raises InputError naming lowest feed or highest feed.")
      .def("next", &copy::LiveSession::next, py::arg("seconds"),
           py::call_guard<py::gil_scoped_release>(),
           "ToolPath of the next moves, at most `seconds`; without moves when all is cut. Raises "
           "InputError naming batch time.")
      .def(
          "change",
          [](copy::LiveSession& s, const std::optional<double>& radial,
             const std::optional<double>& axial, const std::optional<double>& low,
             const std::optional<double>& high) {
            s.change(changed(s.conditions(), radial, axial, low, high));
          },
          py::arg("radial_depth") = py::none(), py::arg("axial_depth") = py::none(),
          py::arg("low") = py::none(), py::arg("high") = py::none(),
          "From the next batch on; what is not given stays. The radial depth from the next line "
          "on. Raises InputError naming radial depth of cut, axial depth of cut, lowest feed or "
          "highest feed.")
      .def_property_readonly("done", &copy::LiveSession::done)
      .def_property_readonly("line", &copy::LiveSession::line)
      .def_property_readonly("level", &copy::LiveSession::level)
      .def_property_readonly("conditions", [](const copy::LiveSession& s) {
        const copy::LiveConditions& c = s.conditions();
        py::dict d;
        d["radial_depth"] = c.radial_depth;
        d["axial_depth"] = c.axial_depth;
        d["low"] = c.feed.low;
        d["high"] = c.feed.high;
        return d;
      });
}

}  // namespace

void bind_dcm_path(py::module_& m) {
  constexpr double kNoLimit = std::numeric_limits<double>::infinity();
  m.def("apply_dcm", &apply, py::arg("path"), py::arg("grid"), py::arg("feed"), py::arg("posture"),
        py::arg("part") = nullptr, py::arg("holder") = Sections(), py::arg("clearance") = 1.0,
        py::arg("lowest") = kPi / 2, py::arg("reading") = "Smooth",
        py::arg("read_at") = "Ball centre", py::arg("feed_tolerance") = 0.1,
        py::arg("axis_tolerance") = 0.0043633231299858, py::arg("axis_rate") = kNoLimit,
        py::arg("acceleration") = kNoLimit,
        "(path, number of the given move of each move, places where no axis was clear). `holder`: "
        "frusta (from, to, radius from, radius to), heights above the ball centre [mm]. Raises "
        "InputError naming FeedField, PostureField, Reading, ReadAt, holder section, height of "
        "holder section, radius of holder section, holder clearance, lowest axis, feed tolerance, "
        "axis tolerance, axis rate or acceleration.");
  m.def(
      "path_steps", &steps_dict, py::arg("path"),
      "Largest changes from move to move: feed [mm/s], axis [rad], rate [rad/s]. Raises nothing.");
  m.def("holder_clearance", &clearance_dict, py::arg("part"), py::arg("holder"), py::arg("path"),
        py::arg("clearance"), py::arg("step") = 0.5,
        "Smallest distance of the holder from the part along the timed moves [mm], where, and how "
        "many moves come nearer than `clearance`. Raises InputError naming holder section, height "
        "of holder section, radius of holder section, holder clearance or step.");
  m.def(
      "hurry_in_air",
      [](const ToolPath& path, const voxel::VoxelGrid& grid, double feed) {
        std::vector<std::int64_t> source;
        ToolPath out;
        watched(py::none(), [&](const Progress&) {
          out = dcm::hurry_in_air(path, grid, {feed, 0.0}, &source);
        });
        return py::make_tuple(std::move(out), source_array(source));
      },
      py::arg("path"), py::arg("grid"), py::arg("feed"),
      "(path with moves through emptied voxels at `feed` [mm/s], number of the given move of "
      "each). Raises InputError naming feed in air.");
  bind_copy(m);
  bind_live(m);
}

}  // namespace patchmill
