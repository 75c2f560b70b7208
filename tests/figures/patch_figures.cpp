// Writes the numbers behind the pictures of docs/patch-division.md, matsuda-condition.md and
// on-surface.md as CSV files. Usage: patch_figures <folder>
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patch/analytic_surfaces.h"
#include "patchmill/patch/advisor.h"
#include "patchmill/patch/boundary.h"
#include "patchmill/patch/cover.h"
#include "patchmill/patch/mask.h"
#include "patchmill/patch/patch_surface.h"
#include "patchmill/patch/surface_lattice.h"

#include <fstream>

#include <fmt/format.h>
#include <fmt/ostream.h>

namespace patchmill {
namespace {

using namespace analytic;

std::string folder;

std::ofstream csv(const std::string& name, const char* header) {
  std::ofstream out(folder + "/" + name + ".csv");
  out << header << "\n";
  return out;
}

const char* shape_name(patch::PatchShape shape) {
  return shape == patch::PatchShape::Square    ? "square"
         : shape == patch::PatchShape::Hexagon ? "hexagon"
                                               : "triangle";
}

const patch::PatchShape kShapes[] = {patch::PatchShape::Square, patch::PatchShape::Hexagon,
                                     patch::PatchShape::Triangle};
const int kSizes[] = {8, 5, 11};

patch::Box2 box(double half) {
  return {Vec2(-half, -half), Vec2(half, half)};
}

void write(std::ofstream& out, const std::string& panel, const patch::Dimples& dimples) {
  for (const patch::Dimple& d : dimples) {
    const Vec3 &p = d.surface.position, &n = d.surface.normal;
    fmt::print(out, "{},{},{},{},{},{},{},{},{},{},{},{}\n", panel, d.patch, d.lattice[0],
               d.lattice[1], p.x(), p.y(), p.z(), n.x(), n.y(), n.z(), patch::name(d.state),
               d.depth);
  }
}
const char* kDimpleHeader = "panel,patch,i,j,x,y,z,nx,ny,nz,state,depth";

// The three shapes with their helices and outlines.
void tilings() {
  auto points = csv("tilings", "shape,patch,x,y");
  auto borders = csv("outlines", "shape,patch,x,y");
  for (int s = 0; s < 3; ++s) {
    const patch::PatchDivision d = patch::cover({kShapes[s], 1.0, kSizes[s] - (s != 1)}, box(9.0));
    for (const patch::Dimple& dimple : patch::lattice_points(d)) {
      const Vec2 at = patch::place(d, dimple.lattice);
      fmt::print(points, "{},{},{},{}\n", shape_name(kShapes[s]), dimple.patch, at.x(), at.y());
    }
    int k = 0;
    for (const patch::Polygon& border : patch::outlines(d)) {
      for (const Vec2& c : border)
        fmt::print(borders, "{},{},{},{}\n", shape_name(kShapes[s]), k, c.x(), c.y());
      ++k;
    }
  }
}

// Planar, pyramid and curved patches of each shape on a wavy face with a border.
// Marks of the free form: aligned, staggered, and 1 % of cross-feed too much, and what the advisor
// makes of the last.
void matsuda() {
  auto out = csv("marks", "panel,x,y");
  auto titles = csv("marks_titles", "titles");
  auto write_marks = [&](const std::string& panel, const patch::FreePatch& p) {
    titles << patch::describe(patch::mark_array(p)) << "\n";
    for (const patch::HelixMark& m : patch::helix_marks(patch::helix_path(p), p.feed_per_tooth))
      fmt::print(out, "{},{},{}\n", panel, m.place.x(), m.place.y());
  };
  write_marks("0", {4, 14.0, 0.5, 0.5});
  write_marks("1", {4, 14.0625, 0.5, 0.5});
  write_marks("2", {4, 14.0, 0.505, 0.5});
  patch::MarkWish wish;
  wish.tool = {1.0, 2};
  wish.spindle_speed = 1000.0 / 60.0;
  wish.side = 14.0;
  wish.feed_per_tooth = 0.5;
  wish.cross_feed = 0.505;
  write_marks("3", patch::advise(wish)[0].patch);
  write_marks("4", {6, 8.0, 0.5 * std::sqrt(0.75), 0.5});
  write_marks("5", {3, 20.0, 0.44, 0.5});
  auto text = csv("advice", "advice");
  for (const patch::MarkProposal& p : patch::advise(wish))
    text << patch::name(p.kept)
         << " kept: " << patch::describe_changes(patch::wished_patch(wish), p) << "; "
         << patch::describe(p.state)
         << fmt::format("; F = {:.2f} mm/min, ridge {:.4f} mm\n", 60 * p.feed, p.ridge_height);
}

// Matsuda's two workpieces: free-form patches on an inclined plane and on a cylinder.
void workpieces() {
  auto out = csv("workpieces", "panel,patch,x,y,z");
  const patch::TexturePlane plane;
  const Ray faces[] = {flat(Vec3::Zero(), Vec3(std::sin(0.5), 0, std::cos(0.5))),
                       cylinder(Vec3(0, 0, -12), Vec3::UnitY(), 14.0)};
  const patch::FreePatch p{4, 4.5, 0.5, 0.5};
  const auto marks = patch::helix_marks(patch::helix_path(p), p.feed_per_tooth);
  for (int k = 0; k < 2; ++k)
    for (int patch = 0; patch < 25; ++patch) {
      std::vector<Vec2> places;
      for (const patch::HelixMark& m : marks)
        places.push_back(m.place + 5.0 * Vec2(patch % 5 - 2, patch / 5 - 2));
      for (const patch::SurfaceSample& s : by_rays(plane, faces[k])(places)) {
        const Vec3& at = s.point.position;
        fmt::print(out, "{},{},{},{},{}\n", k, patch, at.x(), at.y(), at.z());
      }
    }
}

// A flat top that a fillet takes to a slope, with a hole: margin, slivers and what is off the face.
void fillet() {
  auto out = csv("fillet", kDimpleHeader);
  const patch::TexturePlane plane;
  const double r = 10.0, bend = Angle::degrees(50).radians(), end = r * std::sin(bend);
  const Ray top = height_field(
      [=](double x, double) {
        if (x < 0) return 0.0;
        return x < end ? std::sqrt(r * r - x * x) - r
                       : r * std::cos(bend) - r - std::tan(bend) * (x - end);
      },
      [=](double x, double) {
        return Vec2(x < 0 ? 0.0 : x < end ? -x / std::sqrt(r * r - x * x) : -std::tan(bend), 0);
      });
  const Ray part = trimmed(top, [](const patch::SurfacePoint& p) {
    const Vec2 q = p.position.head<2>();
    return q.x() > -16 && q.x() < 14 && std::abs(q.y()) < 12 && (q - Vec2(-5, 1)).norm() > 4;
  });
  std::vector<patch::Segment3> edges;
  auto on = [&](const Vec2& q) { return top(plane.at(q), plane.direction)->position; };
  auto edge = [&](const Vec2& a, const Vec2& b) {
    for (int n = 0; n < 60; ++n)
      edges.push_back({on(a + (b - a) * n / 60.0), on(a + (b - a) * (n + 1) / 60.0)});
  };
  const Vec2 c[4] = {{-16, -12}, {14, -12}, {14, 12}, {-16, 12}};
  for (int n = 0; n < 4; ++n) edge(c[n], c[(n + 1) % 4]);
  for (int n = 0; n < 90; ++n) {
    auto at = [](int k) {
      return Vec2(Vec2(-5, 1) + 4 * Vec2(std::cos(k * kPi / 45), std::sin(k * kPi / 45)));
    };
    edges.push_back({on(at(n)), on(at(n + 1))});
  }
  const patch::PatchDivision d =
      patch::cover({patch::PatchShape::Hexagon, 0.5, 5}, patch::Box2(Vec2(-16, -12), Vec2(14, 12)));
  patch::Dimples dimples =
      *patch::sample_patches(d, plane, by_rays(plane, part), {patch::SurfaceKind::Curved});
  patch::keep_off_edges(dimples, edges, 0.8);
  patch::drop_slivers(dimples, 20);
  write(out, "0", dimples);
}

// A hemisphere up to 60°: projected and on the surface, for both lattices.
void on_surface(const std::string& file, double f) {
  auto out = csv(file, kDimpleHeader);
  auto spread =
      csv(file + "_spread", "panel,dimples,least,greatest,rms,least_angle,greatest_angle");
  const patch::TexturePlane plane;
  const double radius = 20.0, half = radius * std::sin(kPi / 3);
  const auto sampler = by_rays(plane, sphere(Vec3::Zero(), radius));
  for (int panel = 0; panel < 4; ++panel) {
    const patch::LatticeKind kind =
        panel < 2 ? patch::LatticeKind::Square : patch::LatticeKind::Triangular;
    const patch::PatchPattern pattern{
        panel < 2 ? patch::PatchShape::Square : patch::PatchShape::Hexagon, f, panel < 2 ? 8 : 4};
    patch::LatticeRequest request{kind, f, Vec2::Zero(), box(half)};
    request.steepest = Angle::degrees(62);
    patch::Dimples dimples;
    if (panel % 2 == 0) {
      dimples = *patch::sample_patches(patch::cover(pattern, box(half)), plane, sampler,
                                       {patch::SurfaceKind::Curved});
    } else {
      const auto lattice = panel == 1 ? *patch::chebyshev_net(request, plane, sampler)
                                      : *patch::low_distortion_lattice(request, plane, sampler);
      dimples = *patch::sample_patches(patch::cover(pattern, lattice, box(half)), plane,
                                       lattice.place_of, sampler, {patch::SurfaceKind::Curved});
    }
    patch::limit_steepness(dimples, plane.direction, Angle::degrees(60));
    const patch::SpacingSpread s = patch::spacing_spread(dimples, kind, f);
    fmt::print(spread, "{},{},{:.4f},{:.4f},{:.4f},{:.2f},{:.2f}\n", panel,
               patch::count_states(dimples)[0], s.least, s.greatest, s.rms, s.least_angle.degrees(),
               s.greatest_angle.degrees());
    write(out, fmt::format("{}", panel), dimples);
  }
}

// Letters by curves, density and depth by an image, on a wavy face.
void masks() {
  auto out = csv("masks", kDimpleHeader);
  const patch::TexturePlane plane;
  const auto sampler = by_rays(plane, waves(1.0, 40.0));
  const patch::PatchDivision d =
      patch::cover({patch::PatchShape::Square, 0.4, 10}, patch::Box2(Vec2(-14, -8), Vec2(14, 8)));
  const patch::Dimples all =
      *patch::sample_patches(d, plane, sampler, {patch::SurfaceKind::Curved});
  const auto place_of = [&](const Vec2& lattice) { return patch::place(d, lattice); };
  patch::Polygon bowl{{-11, -6}, {-8.5, -6}, {-8.5, -1}, {-6, -1}}, eye{{-8.5, 1}, {-6, 1}};
  for (int n = 0; n <= 20; ++n) {
    const double t = -0.5 * kPi + kPi * n / 20;
    bowl.push_back({-6 + 3.5 * std::cos(t), 2.5 + 3.5 * std::sin(t)});
    eye.push_back({-6 + 1.5 * std::cos(t), 2.5 + 1.5 * std::sin(t)});
  }
  bowl.push_back({-11, 6});
  eye.push_back({-8.5, 4});
  const patch::Polygon m{{0, -6},  {2.5, -6}, {2.5, 1.5}, {5.5, -3},  {8.5, 1.5}, {8.5, -6},
                         {11, -6}, {11, 6},   {8.5, 6},   {5.5, 1.2}, {2.5, 6},   {0, 6}};
  patch::Dimples letters = all;
  patch::keep_where(letters, place_of, patch::curve_mask({bowl, eye, m}));
  write(out, "0", letters);
  patch::Image rings{140, 80, {}};
  for (int r = 0; r < 80; ++r)
    for (int c = 0; c < 140; ++c) {
      const double away = std::hypot((c - 69.5) / 5, (r - 39.5) / 5);
      rings.values.push_back(float(0.5 + 0.5 * std::cos(away * 0.9)));
    }
  const patch::Mask image = patch::image_mask(rings, patch::Box2(Vec2(-14, -8), Vec2(14, 8)));
  patch::Dimples density = all, depth = all;
  patch::thin_out(density, place_of, image);
  write(out, "1", density);
  patch::set_depth(depth, place_of, image, 0.0, 0.018, 0.001);
  write(out, "2", depth);
}

}  // namespace
}  // namespace patchmill

int main(int argc, char** argv) {
  using namespace patchmill;
  folder = argc > 1 ? argv[1] : ".";
  tilings();
  matsuda();
  workpieces();
  fillet();
  on_surface("hemisphere", 1.25);
  on_surface("hemisphere_fine", 0.5);
  masks();
  return 0;
}
