// A long text of many lines that Python takes in parts: turning all of it into one Python string would hold
// Python's lock, and so a GUI, for too long.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace patchmill {

class PathText {
 public:
  /// Parts of up to `lines` whole lines.
  explicit PathText(std::string text, std::size_t lines = 5000);

  std::size_t parts() const { return starts_.size() - 1; }
  std::string_view part(std::size_t i) const {
    return std::string_view(text_).substr(starts_[i], starts_[i + 1] - starts_[i]);
  }
  const std::string& whole() const { return text_; }

 private:
  std::string text_;
  std::vector<std::size_t> starts_;  ///< of each part, and the end
};

}  // namespace patchmill
