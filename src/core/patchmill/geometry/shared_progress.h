// Progress of work that several threads do: they report one at a time, and all of them see that it is to stop.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/progress.h"

#include <atomic>
#include <cstddef>
#include <mutex>

namespace patchmill {

/// Progress of several threads as one.
class SharedProgress {
 public:
  /// Of `count` pieces of work; the progress must outlive it.
  SharedProgress(const Progress& progress, std::size_t count)
      : progress_(progress), count_(count) {}

  /// Whether the work is to stop.
  bool stopped() const { return stopped_; }

  /// One more piece is done. False if the work is to stop.
  bool one_done() { return some_done(1); }
  /// So many more pieces are done. False if the work is to stop.
  bool some_done(std::size_t pieces) {
    if (!progress_) return true;
    const std::lock_guard<std::mutex> lock(mutex_);
    done_ += pieces;
    if (!stopped_ && !go_on(progress_, static_cast<double>(done_) / static_cast<double>(count_)))
      stopped_ = true;
    return !stopped_;
  }

 private:
  const Progress& progress_;
  std::size_t count_, done_ = 0;
  std::mutex mutex_;
  std::atomic<bool> stopped_{false};
};

}  // namespace patchmill
