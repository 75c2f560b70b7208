// Large pages; see large_vector.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/geometry/large_vector.h"

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace patchmill {

namespace {

constexpr std::uintptr_t kLarge = std::uintptr_t{1} << 21, kPage = std::uintptr_t{1} << 12;
// What is less the allocator may have had in hand before, with its pages: the C library's keeps what was up to 32 MiB.
constexpr std::size_t kAlwaysNew = std::size_t{32} << 20;

// The whole pages in some memory; none where it is less than a few large ones.
struct Pages {
  std::uintptr_t first, last;
  Pages(const void* begin, std::size_t bytes)
      : first((reinterpret_cast<std::uintptr_t>(begin) + kPage - 1) / kPage * kPage),
        last((reinterpret_cast<std::uintptr_t>(begin) + bytes) / kPage * kPage) {
    if (last < first + 2 * kLarge) last = first;
  }
};

}  // namespace

void use_large_pages(const void* begin, std::size_t bytes) {
  const Pages pages(begin, bytes);
  if (pages.last == pages.first) return;
#ifdef MADV_HUGEPAGE
  madvise(reinterpret_cast<void*>(pages.first), pages.last - pages.first,
          MADV_HUGEPAGE);  // advice: no matter if refused
#endif
}

void make_large_pages(const void* begin, std::size_t bytes) {
  if (bytes <= kAlwaysNew) return;
  use_large_pages(begin, bytes);
#ifdef MADV_POPULATE_WRITE
  const Pages pages(begin, bytes);
  constexpr std::uintptr_t kPiece = 4 * kLarge;
  const std::uintptr_t pieces = (pages.last - pages.first + kPiece - 1) / kPiece;
  patchmill::parallel_for(std::uintptr_t{0}, pieces, [&](std::uintptr_t i) {
    const std::uintptr_t from = pages.first + i * kPiece;
    madvise(reinterpret_cast<void*>(from), std::min(kPiece, pages.last - from),
            MADV_POPULATE_WRITE);  // advice, too
  });
#endif
}

}  // namespace patchmill
