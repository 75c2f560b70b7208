// Progress and cancellation of long work. Cancelling is an outcome, not a fault: functions that
// take a Progress say what they return when it stops them.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>

namespace patchmill {

/// Called with the share done, 0 to 1; returns false to ask for a stop. May be called from any
/// thread, one call at a time. An empty function means: no report, never stop.
using Progress = std::function<bool(double share)>;

/// True if the work may go on.
inline bool go_on(const Progress& progress, double share) {
  return !progress || progress(share);
}

}  // namespace patchmill
