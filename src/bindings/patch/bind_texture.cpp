// Sizes, masks, lattices on the surface and their measure, for Python.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/bindings.h"
#include "bindings/surfaces.h"
#include "patchmill/geometry/error.h"
#include "patchmill/patch/mask.h"
#include "patchmill/patch/surface_lattice.h"
#include "patchmill/patch/texture_size.h"

namespace patchmill {
namespace {

using Points = Eigen::Matrix<double, -1, 2>;
using Pixels = py::array_t<float, py::array::c_style | py::array::forcecast>;

// std::function crosses to Python as a class of its own, so that it is never called through Python
struct MaskFunction {
  patch::Mask value;
};

patch::Polygon polygon_of(const Points& points) {
  patch::Polygon polygon;
  for (Eigen::Index i = 0; i < points.rows(); ++i) polygon.emplace_back(points.row(i));
  return polygon;
}

py::dict size_dict(const std::string& kind, const std::string& shape, double ball_radius,
                   std::optional<double> spacing, std::optional<double> depth,
                   std::optional<double> diameter, std::optional<double> area_share,
                   std::optional<double> ridge_height, std::optional<double> tilt) {
  patch::TextureWish wish;
  wish.kind = choose<patch::TextureKind>("TextureKind", kind,
                                         {{"Overlapping", patch::TextureKind::Overlapping},
                                          {"Isolated", patch::TextureKind::Isolated}});
  wish.lattice = patch::lattice_of(shape_of(shape));
  wish.ball_radius = ball_radius;
  wish.spacing = spacing;
  wish.depth = depth;
  wish.diameter = diameter;
  wish.area_share = area_share;
  wish.ridge_height = ridge_height;
  if (tilt) wish.tilt = Angle::radians(*tilt);
  const patch::TextureSize size = patch::complete(wish);
  py::dict d;
  d["spacing"] = size.spacing;
  d["depth"] = size.depth;
  d["diameter"] = size.diameter;
  d["area_share"] = size.area_share;
  d["ridge_height"] = size.ridge_height;
  d["sunk"] = size.sunk;
  d["least_tilt"] = size.least_tilt.radians();
  return d;
}

MaskFunction image_of(const Pixels& pixels, const Vec2& low, const Vec2& high, double outside) {
  if (pixels.ndim() != 2) throw InputError("MaskImage", "not grey", "give rows of grey values.");
  patch::Image image;
  image.rows = static_cast<int>(pixels.shape(0));
  image.columns = static_cast<int>(pixels.shape(1));
  image.values.assign(pixels.data(), pixels.data() + pixels.size());
  return {patch::image_mask(std::move(image), patch::Box2(low, high), outside)};
}

MaskFunction curves_of(const std::vector<Points>& loops) {
  std::vector<patch::Polygon> polygons;
  for (const Points& loop : loops) polygons.push_back(polygon_of(loop));
  return {patch::curve_mask(std::move(polygons))};
}

patch::LatticePlace place_function(const patch::PatchDivision& division,
                                   const patch::SurfaceLattice* lattice) {
  if (lattice) return lattice->place_of;
  return [&division](const Vec2& p) { return patch::place(division, p); };
}

void bind_masks(py::module_& m) {
  py::class_<MaskFunction>(m, "Mask", "Values from 0 to 1 over the texture plane.")
      .def(
          "inverted", [](const MaskFunction& f) { return MaskFunction{patch::inverted(f.value)}; },
          "The mask with 1 less each value. Raises nothing.")
      .def(
          "at",
          [](const MaskFunction& f, const Points& places) {
            return column_of<double>(polygon_of(places), [&](const Vec2& p) { return f.value(p); });
          },
          py::arg("places"), "Values at (n, 2) places [mm]. Raises nothing.");
  m.def("image_mask", &image_of, py::arg("pixels"), py::arg("low"), py::arg("high"),
        py::arg("outside") = 0.0,
        "Grey rows from the top, 0 to 1, laid on the rectangle from `low` to `high` [mm]. Raises "
        "InputError naming Image, MaskImage, MaskOutside or MaskArea.");
  m.def("curve_mask", &curves_of, py::arg("loops"),
        "1 inside closed loops of (n, 2) points [mm], 0 outside and in loops within loops. Raises "
        "InputError naming Curves.");
  const auto released = py::call_guard<py::gil_scoped_release>();
  m.def(
      "keep_where",
      [](patch::Dimples& dimples, const patch::PatchDivision& division,
         const patch::SurfaceLattice* lattice, const MaskFunction& mask, double threshold) {
        patch::keep_where(dimples, place_function(division, lattice), mask.value, threshold);
      },
      py::arg("dimples"), py::arg("division"), py::arg("lattice"), py::arg("mask"),
      py::arg("threshold") = 0.5, released,
      "Leaves out dimples where the mask is below it. Raises InputError naming Threshold.");
  m.def(
      "thin_out",
      [](patch::Dimples& dimples, const patch::PatchDivision& division,
         const patch::SurfaceLattice* lattice, const MaskFunction& mask) {
        patch::thin_out(dimples, place_function(division, lattice), mask.value);
      },
      py::arg("dimples"), py::arg("division"), py::arg("lattice"), py::arg("mask"), released,
      "Leaves the share of dimples that the mask says. Raises nothing.");
  m.def(
      "set_depth",
      [](patch::Dimples& dimples, const patch::PatchDivision& division,
         const patch::SurfaceLattice* lattice, const MaskFunction& mask, double at_0, double at_1,
         double least) {
        patch::set_depth(dimples, place_function(division, lattice), mask.value, at_0, at_1, least);
      },
      py::arg("dimples"), py::arg("division"), py::arg("lattice"), py::arg("mask"),
      py::arg("depth_at_0"), py::arg("depth_at_1"), py::arg("least") = 0.0, released,
      "Depth linear in the mask [mm]; dimples shallower than `least` are left out. Raises "
      "InputError naming Depth or MinimumDepth.");
}

std::optional<patch::SurfaceLattice> lay_lattice(const patch::PatchPattern& pattern,
                                                 const patch::ProjectedSurface& sampler,
                                                 const patch::TexturePlane& plane,
                                                 const Vec2& start, const Vec2& low,
                                                 const Vec2& high, const py::object& progress) {
  patch::LatticeRequest request;
  request.kind = patch::lattice_of(pattern.shape);
  request.spacing = pattern.spacing;
  request.start = start;
  request.area = patch::Box2(low, high);
  const auto lay = request.kind == patch::LatticeKind::Square ? patch::chebyshev_net
                                                              : patch::low_distortion_lattice;
  std::optional<patch::SurfaceLattice> laid;
  const bool done = watched(progress, [&](const Progress& report) {
    laid = lay(request, plane, sampler_of(sampler), report);
  });
  return done ? std::move(laid) : std::nullopt;
}

py::dict spread_dict(const patch::Dimples& dimples, const patch::PatchPattern& pattern) {
  patch::SpacingSpread spread;
  watched(py::none(), [&](const Progress&) {
    spread = patch::spacing_spread(dimples, patch::lattice_of(pattern.shape), pattern.spacing);
  });
  py::dict d;
  d["least"] = spread.least;
  d["greatest"] = spread.greatest;
  d["rms"] = spread.rms;
  d["least_angle"] = spread.least_angle.radians();
  d["greatest_angle"] = spread.greatest_angle.radians();
  d["pairs"] = spread.along[0].pairs + spread.along[1].pairs + spread.along[2].pairs;
  return d;
}

void bind_lattices(py::module_& m) {
  py::class_<patch::SurfaceLattice>(m, "SurfaceLattice", "A lattice laid on the surface.")
      .def(
          "places",
          [](const patch::SurfaceLattice& lattice, const Points& points) {
            Points places(points.rows(), 2);
            for (Eigen::Index i = 0; i < points.rows(); ++i)
              places.row(i) = lattice.place_of(points.row(i)).transpose();
            return places;
          },
          py::arg("points"),
          "Places in the texture plane [mm] of (n, 2) lattice coordinates; NaN beyond its end. "
          "Raises nothing.")
      .def(
          "counted_from",
          [](const patch::SurfaceLattice& lattice, const Vec2& flat,
             const patch::PatchPattern& pattern) {
            return patch::counted_from(lattice, flat, patch::lattice_of(pattern.shape),
                                       pattern.spacing);
          },
          py::arg("flat"), py::arg("pattern"),
          "The same lattice with the point next to `flat` [mm] as (0, 0). Raises InputError naming "
          "Start.");
  m.def("lay_lattice", &lay_lattice, py::arg("pattern"), py::arg("sampler"), py::arg("plane"),
        py::arg("start"), py::arg("low"), py::arg("high"), py::arg("progress") = py::none(),
        "The pattern's lattice on the surface over the rectangle from `low` to `high` [mm]: a "
        "Chebyshev net for squares, else of low distortion. None if `progress` returned False. "
        "Raises InputError naming Start, Area or Spacing.");
  m.def(
      "nearest_start",
      [](const Vec2& wanted, const Vec2& low, const Vec2& high,
         const patch::ProjectedSurface& sampler) {
        return patch::nearest_start(wanted, patch::Box2(low, high), sampler_of(sampler));
      },
      py::arg("wanted"), py::arg("low"), py::arg("high"), py::arg("sampler"),
      "The place nearest to `wanted` that can be cut [mm]. Raises InputError naming Start or "
      "Area.");
  m.def("cover_lattice",
        interruptible([](const patch::PatchPattern& pattern, const patch::SurfaceLattice& lattice,
                         const Vec2& low, const Vec2& high) {
          return patch::cover(pattern, lattice, patch::Box2(low, high));
        }),
        py::arg("pattern"), py::arg("lattice"), py::arg("low"), py::arg("high"),
        "The patches with lattice points over the rectangle from `low` to `high` [mm]. Raises "
        "InputError naming Area.");
  m.def("spacing_spread", &spread_dict, py::arg("dimples"), py::arg("pattern"),
        "Distances of neighbouring dimples over the spacing: least, greatest, rms of the change, "
        "and the least and greatest angle of the lattice [rad]. Raises nothing.");
}

}  // namespace

void bind_texture(py::module_& m) {
  bind_masks(m);
  bind_lattices(m);
  m.def("sink", &patch::sink, py::arg("dimples"), py::arg("depth"),
        "Puts the bottoms of all dimples `depth` [mm] below the surface. Raises InputError naming "
        "Depth.");
  m.def("texture_size", &size_dict, py::arg("kind"), py::arg("shape"), py::arg("ball_radius"),
        py::arg("spacing") = py::none(), py::arg("depth") = py::none(),
        py::arg("diameter") = py::none(), py::arg("area_share") = py::none(),
        py::arg("ridge_height") = py::none(), py::arg("tilt") = py::none(),
        "All sizes of a texture from those that are given [mm, 0 to 1, rad]. Raises InputError "
        "naming TextureKind, PatchShape, BallRadius, Spacing, Depth, DimpleDiameter, AreaShare, "
        "RidgeHeight or Tilt.");
}

}  // namespace patchmill
