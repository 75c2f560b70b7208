// The largest resident memory of this process since a moment, as Linux counts it (proc(5): VmHWM of
// /proc/self/status, forgotten by writing 5 to /proc/self/clear_refs).
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <fstream>
#include <string>

namespace patchmill::voxel {

/// A line of /proc/self/status in bytes; 0 if there is none.
inline double status_bytes(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (word == name + ":") {
      double kib = 0.0;
      status >> kib;
      return 1024.0 * kib;
    }
  return 0.0;
}

class PeakMemory {
 public:
  PeakMemory() {
    std::ofstream forget("/proc/self/clear_refs");
    forget << 5 << std::flush;
    known_ = forget.good();
    before_ = status_bytes("VmRSS");
  }
  bool known() const { return known_ && before_ > 0.0; }
  /// Bytes that were in use at the worst moment, beyond those at the beginning.
  double bytes() const { return status_bytes("VmHWM") - before_; }

 private:
  bool known_ = false;
  double before_ = 0.0;
};

}  // namespace patchmill::voxel
