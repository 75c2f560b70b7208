// Vectors of hundreds of megabytes, such as a value for each voxel: made piece by piece, so that a stop ends their
// making at once, and in large pages, so that they are also let go at once. A vector made as a whole fills them all
// before anything can be asked, and an operating system takes a gigabyte back in small pages in a quarter of a second.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/stop.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace patchmill {

/// Asks the system for large pages under memory that was not yet touched; where there are none nothing changes.
void use_large_pages(const void* begin, std::size_t bytes);

/// The same, and has the system make those pages at once, on all threads: for memory that one thread will fill. Most of
/// the time that it takes to write a few hundred megabytes for the first time is the system's.
void make_large_pages(const void* begin, std::size_t bytes);

/// Makes `values` the `count` values of `value(i)`, i = 0, 1, ... . Throws Stopped like a parallel loop.
template <class T, class Value>
void fill_large(std::vector<T>& values, std::size_t count, const Value& value) {
  constexpr std::size_t kPiece = 1U << 14;  // values: few enough to stay in the cache
  std::vector<T>().swap(values);
  values.reserve(count);
  use_large_pages(values.data(), count * sizeof(T));
  while (values.size() < count) {
    stop_point();
    std::size_t i = values.size();
    values.resize(std::min(count, i + kPiece));
    for (; i < values.size(); ++i) values[i] = value(i);
  }
}

/// A vector of `count` values `value(i)`; see fill_large.
template <class T, class Value>
std::vector<T> large_vector(std::size_t count, const Value& value) {
  std::vector<T> values;
  fill_large(values, count, value);
  return values;
}

}  // namespace patchmill
