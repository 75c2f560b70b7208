// Cutting a text into parts at ends of lines; see path_text.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/path/path_text.h"

namespace patchmill {

PathText::PathText(std::string text, std::size_t lines) : text_(std::move(text)), starts_{0} {
  std::size_t seen = 0;
  for (std::size_t i = 0; i < text_.size(); ++i)
    if (text_[i] == '\n' && ++seen % lines == 0) starts_.push_back(i + 1);
  if (starts_.back() != text_.size()) starts_.push_back(text_.size());
}

}  // namespace patchmill
