// Labelling and merging hollows; see hollows.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/marks/hollows.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <queue>

namespace patchmill::marks {
namespace {

constexpr std::int64_t kUncut = -1;

bool is_cut(const Relief& relief, std::int64_t cell) {
  return relief.height[static_cast<std::size_t>(cell)] < static_cast<float>(relief.stock);
}

// Every cut cell points to its steepest lower neighbour; equal heights go to the lower number.
std::vector<std::int64_t> steepest_ways(const Relief& relief) {
  std::vector<std::int64_t> way(relief.height.size(), kUncut);
  for (std::int64_t cell = 0; cell < relief.grid.cells(); ++cell) {
    if (!is_cut(relief, cell)) continue;
    const float here = relief.height[static_cast<std::size_t>(cell)];
    std::int64_t to = cell;
    float steepest = 0.0f;
    for_neighbours(relief.grid, cell, [&](std::int64_t other, bool diagonal) {
      const float there = relief.height[static_cast<std::size_t>(other)];
      if (!(there < here || (there == here && other < cell))) return;
      const float slope = (here - there) * (diagonal ? 0.70710678f : 1.0f);
      if (to != cell && slope <= steepest) return;
      to = other;
      steepest = slope;
    });
    way[static_cast<std::size_t>(cell)] = to;
  }
  return way;
}

}  // namespace

Hollows label_hollows(const Relief& relief) {
  std::vector<std::int64_t> way = steepest_ways(relief);
  Hollows hollows;
  hollows.label.assign(way.size(), kNoHollow);
  std::vector<std::int64_t> trail;
  for (std::int64_t cell = 0; cell < relief.grid.cells(); ++cell) {
    if (way[static_cast<std::size_t>(cell)] == kUncut) continue;
    std::int64_t at = cell;
    while (hollows.label[static_cast<std::size_t>(at)] == kNoHollow &&
           way[static_cast<std::size_t>(at)] != at) {
      trail.push_back(at);
      at = way[static_cast<std::size_t>(at)];
    }
    std::int32_t& label = hollows.label[static_cast<std::size_t>(at)];
    if (label == kNoHollow) {
      label = static_cast<std::int32_t>(hollows.lowest.size());
      hollows.lowest.push_back(at);
    }
    for (const std::int64_t t : trail) hollows.label[static_cast<std::size_t>(t)] = label;
    trail.clear();
  }
  return hollows;
}

HollowMerger::HollowMerger(const Relief& relief, const Hollows& hollows)
    : relief_(relief),
      hollows_(hollows),
      parent_(hollows.lowest.size()),
      dropped_(hollows.lowest.size(), false),
      ridges_(hollows.lowest.size()) {
  std::iota(parent_.begin(), parent_.end(), 0);
  for (std::int64_t cell = 0; cell < relief.grid.cells(); ++cell)
    for_neighbours(relief.grid, cell, [&](std::int64_t other, bool) { take(cell, other); });
}

void HollowMerger::merge(double least) {
  using Entry = std::pair<double, std::int32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  for (std::size_t k = 0; k < parent_.size(); ++k)
    queue.push({depth(static_cast<std::int32_t>(k)), static_cast<std::int32_t>(k)});
  while (!queue.empty() && queue.top().first < least) {
    const auto [was, k] = queue.top();
    queue.pop();
    if (parent_[static_cast<std::size_t>(k)] != k) continue;
    const double now = depth(k);
    if (now != was) {
      queue.push({now, k});
      continue;
    }
    const std::int32_t into = lowest_ridge(k).first;
    if (into == kNoHollow) {
      dropped_[static_cast<std::size_t>(k)] = true;  // shallow, and open to uncut ground only
      continue;
    }
    const std::int32_t winner = join(k, into);
    queue.push({depth(winner), winner});
  }
}

std::int32_t HollowMerger::root(std::int32_t k) const {
  while (parent_[static_cast<std::size_t>(k)] != k) k = parent_[static_cast<std::size_t>(k)];
  return k;
}

double HollowMerger::depth(std::int32_t k) const {
  // a hollow never rises above the stock: there its rim is at the latest
  return std::min(lowest_ridge(k).second, relief_.stock) - bottom(k);
}

// The ridge between two hollows is as high as the lowest way over two neighbouring cells.
void HollowMerger::take(std::int64_t cell, std::int64_t other) {
  const std::int32_t a = hollows_.label[static_cast<std::size_t>(cell)];
  const std::int32_t b = hollows_.label[static_cast<std::size_t>(other)];
  if (a == kNoHollow || b == kNoHollow || a == b) return;
  const double over = std::max(relief_.height[static_cast<std::size_t>(cell)],
                               relief_.height[static_cast<std::size_t>(other)]);
  const auto found = ridges_[static_cast<std::size_t>(a)].try_emplace(b, over).first;
  found->second = std::min(found->second, over);
}

double HollowMerger::bottom(std::int32_t k) const {
  return relief_.height[static_cast<std::size_t>(hollows_.lowest[static_cast<std::size_t>(k)])];
}

std::pair<std::int32_t, double> HollowMerger::lowest_ridge(std::int32_t k) const {
  std::pair<std::int32_t, double> best{kNoHollow, std::numeric_limits<double>::infinity()};
  for (const auto& [other, over] : ridges_[static_cast<std::size_t>(k)])
    if (over < best.second) best = {other, over};
  return best;
}

// Joins two hollows; the one with the lower bottom keeps its number.
std::int32_t HollowMerger::join(std::int32_t a, std::int32_t b) {
  if (std::make_pair(bottom(b), b) < std::make_pair(bottom(a), a)) std::swap(a, b);
  auto &mine = ridges_[static_cast<std::size_t>(a)], &other = ridges_[static_cast<std::size_t>(b)];
  mine.erase(b);
  for (const auto& [next, over] : other) {
    if (next == a) continue;
    auto& theirs = ridges_[static_cast<std::size_t>(next)];
    theirs.erase(b);
    const auto found = mine.try_emplace(next, over).first;
    found->second = std::min(found->second, over);
    theirs[a] = found->second;
  }
  other.clear();
  parent_[static_cast<std::size_t>(b)] = a;
  return a;
}

}  // namespace patchmill::marks
