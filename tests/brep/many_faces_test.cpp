// Many faces at once: the bins that tell where a face may be, against trying every face at every place.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "brep/face_bins.h"
#include "brep/face_sampler.h"

#include <algorithm>
#include <random>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <gtest/gtest.h>

namespace patchmill {
namespace {

// Triangles of different sizes above and beside each other, all as seen from above.
std::vector<TopoDS_Face> triangles(std::mt19937& random, int count) {
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<TopoDS_Face> faces;
  while (static_cast<int>(faces.size()) < count) {
    const double size = faces.size() % 20 == 0 ? 25.0 : 2.0;
    const gp_Pnt middle(20 * number(random), 20 * number(random), 5 * number(random));
    const auto corner = [&](double x, double y) {
      return gp_Pnt(middle.X() + size * x, middle.Y() + size * y,
                    middle.Z() + 0.3 * number(random));
    };
    const double wide = 0.6 + 0.3 * number(random);
    faces.push_back(BRepBuilderAPI_MakeFace(
        BRepBuilderAPI_MakePolygon(corner(-wide, -0.5), corner(wide, -0.4), corner(0.0, 1.0), true),
        true));
  }
  return faces;
}

TEST(ManyFaces, TheFirstOfAllIsHit) {
  std::mt19937 random(7);
  const std::vector<TopoDS_Face> faces = triangles(random, 150);
  std::uniform_real_distribution<double> number(-30, 30);
  std::vector<Vec2> places;
  for (int i = 0; i < 4000; ++i) places.emplace_back(number(random), number(random));
  const Angle steepest = Angle::degrees(80);
  std::vector<patch::SurfaceSample> highest(places.size());
  for (const TopoDS_Face& face : faces) {
    const auto hits = FaceSampler({face}, patch::TexturePlane(), steepest).sample(places);
    for (std::size_t i = 0; i < places.size(); ++i)
      if (patch::on_face(hits[i].state) &&
          (!patch::on_face(highest[i].state) ||
           hits[i].point.position.z() > highest[i].point.position.z()))
        highest[i] = hits[i];
  }
  const auto hits = FaceSampler(faces, patch::TexturePlane(), steepest).sample(places);
  int on = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    ASSERT_EQ(hits[i].state, highest[i].state) << places[i].transpose();
    if (!patch::on_face(hits[i].state)) continue;
    ++on;
    ASSERT_EQ(hits[i].point.position, highest[i].point.position);
    ASSERT_EQ(hits[i].point.normal, highest[i].point.normal);
  }
  EXPECT_GT(on, 1000);
  EXPECT_LT(on, 3900);
}

TEST(FaceBins, TellEveryBoxThatAPlaceIsIn) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> number(0, 1);
  for (const int count : {1, 2, 30, 1000}) {
    std::vector<PlanBox> boxes;
    for (int i = 0; i < count; ++i) {
      const Vec2 low(100 * number(random), 3 * number(random));
      const double size = i % 17 == 0 ? 60.0 : 1.0;  // some over nearly all others
      boxes.push_back({low, low + size * Vec2(number(random), number(random))});
    }
    boxes.push_back({Vec2(5, 1), Vec2(5, 1)});  // a box that is a point
    const FaceBins bins(boxes);
    std::size_t told = 0;
    constexpr int kPlaces = 500;
    for (int k = 0; k < kPlaces; ++k) {
      Vec2 p(-20 + 200 * number(random), -20 + 100 * number(random));
      const PlanBox& some = boxes[std::size_t(k) % boxes.size()];
      if (k % 3 == 0) p = some.low;  // corners are in their boxes
      if (k % 3 == 1) p = some.high;
      const auto range = bins.over(p);
      EXPECT_TRUE(std::is_sorted(range.begin(), range.end()));
      told += std::size_t(range.end() - range.begin());
      for (std::size_t b = 0; b < boxes.size(); ++b) {
        const bool in =
            (p.array() >= boxes[b].low.array()).all() && (p.array() <= boxes[b].high.array()).all();
        if (in) {
          EXPECT_TRUE(std::binary_search(range.begin(), range.end(), std::int32_t(b)));
        }
      }
    }
    if (count == 1000) {
      EXPECT_LT(told, std::size_t(kPlaces) * 1000 / 4);
    }
  }
}

}  // namespace
}  // namespace patchmill
