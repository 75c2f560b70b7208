// The load along random moves against a slow simulation that shares no code with it: the cutting surface is divided
// in small elements, and each is asked at many places whether there is material right before it. The stock is known
// without voxels: the block less what the tool has swept, which along a straight move of an upright tool is a convex
// question.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "block.h"

#include <array>
#include <random>

#include <gtest/gtest.h>

namespace patchmill::load {
namespace {

const Resistance kSteel{2000.0, 0.25, 0.3};

struct Sweep {
  Vec3 from, to;  // tips
};

// How far a point is within the tool with its tip at a place: > 0 inside. Ball or flat, upright.
double within(const Vec3& p, const Vec3& tip, const Tool& tool) {
  const double r = std::hypot(p.x() - tip.x(), p.y() - tip.y()), up = p.z() - tip.z();
  if (tool.corner() == 0.0) return std::min(tool.radius - r, up);
  const double low = std::min(0.0, up - tool.radius);
  return tool.radius - std::hypot(r, low);
}

// Whether the tool has been at a point on a straight move up to the share `until`: `within` is concave along it.
bool swept(const Vec3& p, const Sweep& s, double until, const Tool& tool) {
  double a = 0.0, b = until;
  const auto at = [&](double t) { return within(p, s.from + t * (s.to - s.from), tool); };
  for (int i = 0; i < 20; ++i) {
    const double u = a + (b - a) / 3.0, v = b - (b - a) / 3.0;
    (at(u) < at(v) ? a : b) = at(u) < at(v) ? u : v;
  }
  return std::max({at(0.0), at(until), at(0.5 * (a + b))}) > 1e-9;
}

// What one element adds.
struct Element {
  Vec3 place, normal;  // from the tip
  double area, length, radius;
};

std::vector<std::vector<Element>> surface(const Tool& tool) {  // for each angle
  constexpr int kTurns = 90, kAlong = 40;
  const double r = tool.radius, top = 10.0;
  std::vector<std::vector<Element>> all(kTurns);
  for (int i = 0; i < kTurns; ++i) {
    const double angle = 2.0 * kPi * (i + 0.5) / kTurns, part = 2.0 * kPi / kTurns;
    const Vec3 out(std::cos(angle), std::sin(angle), 0.0);
    const double edge = tool.corner() > 0.0 ? r : 0.0;  // where the cylinder begins
    for (int k = 0; k < kAlong; ++k) {
      const double t = (k + 0.5) / kAlong;
      if (tool.corner() > 0.0) {
        const double at = t * 0.5 * kPi, d = 0.5 * kPi * r / kAlong, rho = r * std::sin(at);
        const Vec3 n = std::sin(at) * out - Vec3(0, 0, std::cos(at));
        all[i].push_back({Vec3(0, 0, r) + r * n, n, d * rho * part, d, rho});
      } else {
        all[i].push_back(
            {t * r * out, -Vec3::UnitZ(), r / kAlong * t * r * part, r / kAlong, t * r});
      }
      const double d = (top - edge) / kAlong;
      all[i].push_back({r * out + Vec3(0, 0, edge + t * (top - edge)), out, d * r * part, d, r});
    }
  }
  return all;
}

Engagement brute(const std::vector<Sweep>& done, const Sweep& now, double t, const Tool& tool) {
  const Vec3 d = (now.to - now.from).normalized(), tip = now.from + t * (now.to - now.from);
  static const auto flat = surface({3.0, 2, 0.0}), ball = surface({3.0, 2});
  const auto& elements = tool.corner() > 0.0 ? ball : flat;
  Engagement found;
  double area = 0.0;
  std::vector<Vec3> edge(elements.size(), Vec3::Zero());
  for (std::size_t i = 0; i < elements.size(); ++i)
    for (const Element& e : elements[i]) {
      const double share = e.normal.dot(d);
      const Vec3 p = tip + e.place + 1e-3 * e.normal;
      if (share <= 1e-6 || (p.array() <= 0.0).any() || (p.array() >= kBlock.array()).any() ||
          p.z() <= kFloor || swept(p, now, t, tool))
        continue;
      bool gone = false;
      for (const Sweep& s : done) gone = gone || swept(p, s, 1.0, tool);
      if (gone) continue;
      found.section += share * e.area;
      area += e.area;
      found.power += std::pow(share, 1.0 - kSteel.exponent) * e.area;
      const double cutting = std::pow(share, 1.0 - kSteel.exponent) * e.length;
      const Vec3 out = Vec3(e.place.x(), e.place.y(), 0.0).normalized();
      const Vec3 moving = -Vec3::UnitZ().cross(out);  // M3
      edge[i] -= cutting * (moving + kSteel.normal * e.normal);
    }
  found.chip = area > 0.0 ? found.section / area : 0.0;
  const std::size_t n = edge.size();
  for (std::size_t i = 0; i < n; ++i)
    found.force = std::max(found.force, (edge[i] + edge[(i + n / 2) % n]).norm());
  return found;
}

struct Sums {
  double section = 0.0, area = 0.0, power = 0.0, force = 0.0;
  void add(const Engagement& e, double weight) {
    section += weight * e.section;
    if (e.chip > 0.0) area += weight * e.section / e.chip;
    power += weight * e.power;
    force += weight * e.force;
  }
  // mean over all of the surface that is at work on the way
  double chip() const { return section / area; }
};

// Random moves through the block with one tool, one after the other. The chip thickness under a flat end that sinks
// slowly is left out: its bottom comes to the next layer of samples now and then only.
void compare(const Tool& tool, unsigned seed, bool level) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(0.0, 1.0);
  std::vector<Vec3> tips{Vec3(-4.0, 20.0 * number(random), kTop - 3.0)};
  for (int i = 0; i < 6; ++i)
    tips.emplace_back(22.0 * number(random) - 1.0, 22.0 * number(random) - 1.0,
                      level ? tips[0].z() : kFloor + 0.5 + (kTop - kFloor - 1.5) * number(random));
  const auto found = load_along(passes(tool, tips, 20.0), block(0.5), kSteel);
  Sums ours, theirs;
  std::vector<Sweep> done;
  std::size_t i = 0;
  for (std::size_t m = 1; m < tips.size(); ++m) {
    const Sweep now{tips[m - 1], tips[m]};
    for (; i < found.size() && found[i].move == std::int64_t(m) - 1; ++i)
      ours.add(found[i].engagement, found[i].length);
    const double length = (now.to - now.from).norm();
    constexpr int kPlaces = 10;
    for (int k = 0; k < kPlaces; ++k)
      theirs.add(brute(done, now, (k + 0.5) / kPlaces, tool), length / kPlaces);
    done.push_back(now);
  }
  std::printf("seed %u: section %+.2f %%, chip %+.2f %%, power %+.2f %%, force %+.2f %%\n", seed,
              100 * (ours.section / theirs.section - 1), 100 * (ours.chip() / theirs.chip() - 1),
              100 * (ours.power / theirs.power - 1), 100 * (ours.force / theirs.force - 1));
  EXPECT_NEAR(ours.section, theirs.section, 0.05 * theirs.section);
  if (level || tool.corner() > 0.0) {
    EXPECT_NEAR(ours.chip(), theirs.chip(), 0.05 * theirs.chip());
  }
  EXPECT_NEAR(ours.power, theirs.power, 0.05 * theirs.power);
  EXPECT_NEAR(ours.force, theirs.force, 0.05 * theirs.force);
}

TEST(BruteForce, ABallOnRandomMoves) {
  for (unsigned seed = 1; seed <= 3; ++seed) compare({3.0, 2}, seed, seed % 2 == 0);
}

TEST(BruteForce, AFlatEndOnRandomMoves) {
  for (unsigned seed = 11; seed <= 13; ++seed) compare({3.0, 2, 0.0}, seed, seed % 2 == 0);
}

}  // namespace
}  // namespace patchmill::load
