// Large pages; see large_vector.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/geometry/large_vector.h"

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace patchmill {

void use_large_pages(const void* begin, std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  constexpr std::uintptr_t kLarge = std::uintptr_t{1} << 21, kPage = std::uintptr_t{1} << 12;
  const std::uintptr_t first =
      (reinterpret_cast<std::uintptr_t>(begin) + kPage - 1) / kPage * kPage;
  const std::uintptr_t last = (reinterpret_cast<std::uintptr_t>(begin) + bytes) / kPage * kPage;
  if (last > first && last - first >= 2 * kLarge)
    madvise(reinterpret_cast<void*>(first), last - first,
            MADV_HUGEPAGE);  // advice: no matter if refused
#else
  static_cast<void>(begin);
  static_cast<void>(bytes);
#endif
}

}  // namespace patchmill
