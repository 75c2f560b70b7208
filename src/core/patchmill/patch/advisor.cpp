// Proposals of aligned patches; see advisor.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/advisor.h"

#include "patchmill/geometry/error.h"
#include "patchmill/patch/ridge.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace patchmill::patch {
namespace {

double offset(MarkArray array) {
  return array == MarkArray::Staggered ? 0.5 : 0.0;
}

// One family of aligned patches: c and a for f_z = 1.
struct Family {
  double cross_feed, side;
};

Family family(const MarkWish& wish, double q, double n) {
  return {q / (2.0 * std::tan(kPi / wish.corners)),
          (n + 0.5 * q + offset(wish.array)) / wish.corners};
}

// The q and n whose family comes nearest to c/f_z = `cross` and a/f_z = `side`.
Family nearest_family(const MarkWish& wish, double cross, double side) {
  const double q = std::max(1.0, std::round(2.0 * std::tan(kPi / wish.corners) * cross));
  const double n = std::round(side * wish.corners - 0.5 * q - offset(wish.array));
  return family(wish, q, std::max(n, 1.0));
}

FreePatch scaled(const MarkWish& wish, const Family& f, double feed_per_tooth) {
  return {wish.corners, f.side * feed_per_tooth, f.cross_feed * feed_per_tooth, feed_per_tooth};
}

double largest_change(const FreePatch& wished, const FreePatch& p) {
  return std::max({std::abs(p.feed_per_tooth / wished.feed_per_tooth - 1.0),
                   std::abs(p.cross_feed / wished.cross_feed - 1.0),
                   std::abs(p.side / wished.side - 1.0)});
}

// Smallest largest change within a family: the scale midway between the extremes of the ratios.
double best_scale(const FreePatch& wished, const Family& f) {
  const auto [low, high] = std::minmax(
      {1.0 / wished.feed_per_tooth, f.cross_feed / wished.cross_feed, f.side / wished.side});
  return 2.0 / (low + high);
}

// Keeps c: the whole number of drift teeth per side that changes f_z least decides.
FreePatch keep_cross_feed(const MarkWish& wish, const FreePatch& w) {
  const double tangent = std::tan(kPi / w.corners);
  const double q = std::max(1.0, std::round(2.0 * tangent * w.cross_feed / w.feed_per_tooth));
  const double feed_per_tooth = 2.0 * tangent * w.cross_feed / q;
  return scaled(wish, nearest_family(wish, w.cross_feed / feed_per_tooth, w.side / feed_per_tooth),
                feed_per_tooth);
}

// Distance from the nearest mark of the point furthest from all marks.
double reach(const MarkWish& wish, const FreePatch& p) {
  return covering_radius({p.feed_per_tooth, 0.0},
                         {offset(wish.array) * p.feed_per_tooth, p.cross_feed});
}

MarkProposal proposal(const MarkWish& wish, const FreePatch& wished, Kept kept,
                      const FreePatch& patch) {
  MarkProposal p;
  p.kept = kept;
  p.patch = patch;
  p.feed = patch.feed_per_tooth * wish.tool.flutes * wish.spindle_speed;
  p.ridge_height =
      peak_height(wish.tool.radius, patch.feed_per_tooth, patch.cross_feed, offset(wish.array));
  p.state = mark_array(patch);
  p.change = largest_change(wished, patch);
  return p;
}

}  // namespace

const char* name(Kept kept) {
  switch (kept) {
    case Kept::FeedPerTooth:
      return "feed per tooth";
    case Kept::CrossFeed:
      return "cross-feed";
    case Kept::Side:
      return "side";
    case Kept::RidgeHeight:
      return "ridge height";
    case Kept::Nothing:
      return "nothing";
  }
  return "?";
}

FreePatch wished_patch(const MarkWish& wish) {
  require_positive("BallRadius", wish.tool.radius, "mm");
  require_ball(wish.tool, "free-form textures are milled");
  require_in_range("Flutes", wish.tool.flutes, 1, 32, "flutes");
  require_positive("SpindleSpeed", wish.spindle_speed * 60.0, "rpm");
  require_in_range("Corners", wish.corners, 3, 360, "corners");
  if (wish.array != MarkArray::Square && wish.array != MarkArray::Staggered)
    throw InputError("MarkArray", name(wish.array), "choose square or staggered.");
  if (wish.feed_per_tooth.has_value() == wish.ridge_height.has_value())
    throw InputError("FeedPerTooth", wish.feed_per_tooth ? "given with RidgeHeight" : "missing",
                     "give either the feed per tooth or the ridge height.");
  const double ratio = wish.array == MarkArray::Staggered ? std::sqrt(0.75) : 1.0;
  FreePatch p{wish.corners, wish.side, 0.0, 0.0};
  if (wish.feed_per_tooth) {
    p.feed_per_tooth = *wish.feed_per_tooth;
  } else {
    const double rho = cusp_distance(wish.tool.radius, *wish.ridge_height);
    p.feed_per_tooth = rho / covering_radius({1.0, 0.0}, {offset(wish.array), ratio});
  }
  p.cross_feed = wish.cross_feed.value_or(ratio * p.feed_per_tooth);
  require_valid(p);
  if (reach(wish, p) > wish.tool.radius)
    throw InputError(
        "FeedPerTooth", fmt::format("{:.4g} mm", p.feed_per_tooth),
        fmt::format("a ball of radius {} mm leaves untouched material between marks "
                    "so far apart: choose less, a smaller cross-feed or a larger ball.",
                    wish.tool.radius));
  return p;
}

std::vector<MarkProposal> advise(const MarkWish& wish) {
  const FreePatch w = wished_patch(wish);
  if (apothem(w) < w.cross_feed || w.side < w.feed_per_tooth)
    throw InputError("PatchSide", fmt::format("{} mm", w.side),
                     fmt::format("the patch has no two passes at a cross-feed of {:.4g} mm: choose "
                                 "a longer side.",
                                 w.cross_feed));
  const Family near =
      nearest_family(wish, w.cross_feed / w.feed_per_tooth, w.side / w.feed_per_tooth);
  std::vector<MarkProposal> all;
  auto add = [&](Kept kept, const FreePatch& p) {
    if (reach(wish, p) <= wish.tool.radius) all.push_back(proposal(wish, w, kept, p));
  };
  add(Kept::Nothing, scaled(wish, near, best_scale(w, near)));
  add(Kept::FeedPerTooth, scaled(wish, near, w.feed_per_tooth));
  add(Kept::CrossFeed, keep_cross_feed(wish, w));
  add(Kept::Side, scaled(wish, near, w.side / near.side));
  if (wish.ridge_height) {
    const double rho = covering_radius({1.0, 0.0}, {offset(wish.array), near.cross_feed});
    const double f_z = cusp_distance(wish.tool.radius, *wish.ridge_height) / rho;
    const Family f = nearest_family(wish, near.cross_feed, w.side / f_z);
    add(Kept::RidgeHeight, scaled(wish, f, f_z));
  }
  std::stable_sort(all.begin(), all.end(), [](const MarkProposal& l, const MarkProposal& r) {
    return l.change < r.change;
  });
  return all;
}

std::string describe_changes(const FreePatch& w, const MarkProposal& proposal) {
  const FreePatch& p = proposal.patch;
  std::string text;
  auto say = [&](const char* what, double was, double is) {
    if (std::abs(is / was - 1.0) < 1e-9) return;
    text += fmt::format("{}{} {:.4g} → {:.4g} mm ({:+.2f} %)", text.empty() ? "" : ", ", what, was,
                        is, 100.0 * (is / was - 1.0));
  };
  say("feed per tooth", w.feed_per_tooth, p.feed_per_tooth);
  say("cross-feed", w.cross_feed, p.cross_feed);
  say("side", w.side, p.side);
  return text.empty() ? "nothing changes" : text;
}

}  // namespace patchmill::patch
