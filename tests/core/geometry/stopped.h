// Whether work that is told to stop before it begins ends before it is whole.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/stop.h"

#include <thread>

namespace patchmill {

/// Does `work` after it was told to stop; whether it was not done whole.
template <class Work>
bool ends_when_stopped(const Work& work) {
  bool whole = false;
  run_stoppable(
      [&](const Progress&) {
        while (!stopping()) std::this_thread::yield();
        work();
        whole = true;
      },
      [calls = 0](double) mutable { return calls++ == 0; }, std::chrono::milliseconds(1));
  return !whole;
}

}  // namespace patchmill
