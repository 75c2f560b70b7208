// How long work stops from outside at any moment, wherever it is: it runs as a group of oneTBB's tasks, which
// run_stoppable() cancels, and parallel loops within begin no more pieces then. What they were to make is not whole,
// so that each of them throws Stopped after its end, as stop_point() does in long loops that are not parallel. Stopped
// goes up to run_stoppable() and no further; without it around nothing is ever stopped.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/progress.h"

#include <chrono>
#include <utility>

#include <tbb/parallel_for.h>
#include <tbb/task_group.h>

namespace patchmill {

/// Thrown in work that is to stop. No fault, and so no std::exception.
struct Stopped {};

/// Whether the work that this is part of is to stop. Cheap: a look at what this thread does.
inline bool stopping() {
  return tbb::is_current_task_group_canceling();
}

/// Ends the work that this is part of if it is to stop. For loops that may take long: at least once in 10 ms.
inline void stop_point() {
  if (stopping()) throw Stopped{};
}

/// tbb::parallel_for that is whole when it returns.
template <class... Arguments>
void parallel_for(Arguments&&... arguments) {
  tbb::parallel_for(std::forward<Arguments>(arguments)...);
  stop_point();
}

/// Does `work` in a thread of its own, and meanwhile asks `ask` with the fraction done, in this thread: before the
/// work, each `period`, where the fraction grew by 0.04, and after the work if the fraction changed. False if `ask`
/// returned false: then the work was stopped as soon as it looked, and what it made is not whole. What `work` or
/// `ask` throws comes out here, after its end.
bool run_stoppable(const std::function<void(const Progress&)>& work, const Progress& ask,
                   std::chrono::milliseconds period = std::chrono::milliseconds(30));

}  // namespace patchmill
