// Inputs of a reader, damaged: bytes changed, put in, taken away and doubled, pieces of others put in. The same ones
// every time.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <vector>

namespace patchmill::fuzz {

using Bytes = std::vector<std::uint8_t>;

/// What the files of a folder hold, in the order of their names.
inline std::vector<Bytes> files_of(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.push_back(entry.path());
  std::sort(names.begin(), names.end());
  std::vector<Bytes> found;
  for (const auto& name : names) {
    std::ifstream file(name, std::ios::binary);
    found.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return found;
}

/// One of `good`, damaged at one to six places.
template <class Numbers>
Bytes damaged(const std::vector<Bytes>& good, Numbers& numbers) {
  const auto below = [&](std::size_t count) {
    return static_cast<std::ptrdiff_t>(numbers() % count);
  };
  Bytes data = good[numbers() % good.size()];
  for (auto times = 1 + below(6); times > 0; --times) {
    const auto at = data.begin() + below(data.size() + 1);
    const auto rest = static_cast<std::size_t>(data.end() - at);
    const auto kind = below(5);
    if (kind == 0 && rest > 0) {
      *at = static_cast<std::uint8_t>(numbers());
    } else if (kind == 1) {
      data.insert(at, static_cast<std::uint8_t>(numbers()));
    } else if (kind == 2) {
      data.erase(at, at + below(std::min<std::size_t>(rest, 30) + 1));
    } else if (kind == 3 && rest > 0) {  // a bit: digits become others, and letters
      *at = static_cast<std::uint8_t>(*at ^ 1 << below(8));
    } else {
      const Bytes& other = good[numbers() % good.size()];
      const auto from = other.begin() + below(other.size() + 1);
      const Bytes piece(from, from + below(std::min<std::ptrdiff_t>(other.end() - from, 40) + 1));
      data.insert(at, piece.begin(), piece.end());
    }
  }
  return data;
}

}  // namespace patchmill::fuzz
