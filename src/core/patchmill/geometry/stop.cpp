// A thread for the work and one that watches; see stop.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/geometry/stop.h"

#include <atomic>
#include <cmath>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

namespace patchmill {
namespace {

constexpr double kStep = 0.04;  // of the work: so often it waits for an answer, however fast it is
constexpr double kRounding = 1e-9;  // a share told at a multiple of it is at that multiple

class Job {
 public:
  explicit Job(const std::function<void(const Progress&)>& work)
      : thread_([this, &work] { run(work); }) {}
  ~Job() { thread_.join(); }
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  /// Waits for the end, or until the work waits for being told on; no longer than `period`. Whether it is at its end.
  bool ended(std::chrono::milliseconds period) {
    std::unique_lock<std::mutex> lock(mutex_);
    news_.wait_for(lock, period, [&] { return ended_ || waits_; });
    return ended_;
  }
  void go_on_from(double fraction) {
    const std::lock_guard<std::mutex> lock(mutex_);
    told_ = fraction;
    waits_ = false;
    answer_.notify_all();
  }
  void stop() {
    stop_ = true;
    group_.cancel();
    go_on_from(fraction_);
    std::unique_lock<std::mutex> lock(mutex_);
    news_.wait(lock, [&] { return ended_; });
  }
  double fraction() const { return fraction_; }
  /// After the end: what the work threw.
  std::exception_ptr error() const { return error_; }

 private:
  void run(const std::function<void(const Progress&)>& work) {
    group_.run_and_wait([&] {
      try {
        work([this](double fraction) { return tell(fraction); });
      } catch (const Stopped&) {
        stop_ = true;
      } catch (...) {
        error_ = std::current_exception();
      }
    });
    const std::lock_guard<std::mutex> lock(mutex_);
    ended_ = true;
    news_.notify_all();
  }

  bool tell(double fraction) {
    fraction_ = fraction;
    std::unique_lock<std::mutex> lock(mutex_);
    if (stop_ || std::abs(fraction - told_) < kStep - kRounding) return !stop_;
    waits_ = true;
    news_.notify_all();
    answer_.wait(lock, [&] { return !waits_; });
    return !stop_;
  }

  tbb::task_group group_;
  std::atomic<double> fraction_{0.0};
  std::atomic<bool> stop_{false};
  std::exception_ptr error_;
  std::mutex mutex_;
  std::condition_variable news_, answer_;
  bool ended_ = false, waits_ = false;
  double told_ = 0.0;
  std::thread thread_;  // last: it uses all of the others
};

}  // namespace

bool run_stoppable(const std::function<void(const Progress&)>& work, const Progress& ask,
                   std::chrono::milliseconds period) {
  if (!go_on(ask, 0.0)) return false;
  Job job(work);
  double told = 0.0;
  const auto goes_on = [&] {
    told = job.fraction();
    bool on = false;
    try {
      on = go_on(ask, told);
    } catch (...) {
      job.stop();
      throw;
    }
    if (on)
      job.go_on_from(told);
    else
      job.stop();
    return on;
  };
  while (!job.ended(period))
    if (!goes_on()) return false;
  if (job.error()) std::rethrow_exception(job.error());
  return job.fraction() == told || goes_on();
}

}  // namespace patchmill
