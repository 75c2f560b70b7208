// A planner, period by period; see planner_cycle.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/machine/planner_cycle.h"

#include "patchmill/machine/passing_axes.h"

#include <algorithm>
#include <cmath>

namespace patchmill::machine {
namespace {

constexpr double kArrived = 1e-12;     // mm
constexpr double kAtRest = 1e-8;       // mm/s
constexpr double kInstant = 1e-12;     // s
constexpr double kSame = 1e-6;         // periods
constexpr double kRampSeconds = 0.01;  // pieces of less are passed with one even acceleration

double within(double value, double limit) {
  return std::clamp(value, -limit, limit);
}

// A piece under way.
struct Runner {
  double way = 0.0, speed = 0.0;
  double target = 0.0;       // speed that is asked for
  double cycle = 0.0;        // what the next update takes [s]
  double final_speed = 0.0;  // at the end of a piece that is being left
  bool active = false, ramp = false, leaving = false, done = false;
};

// The spindle as the controller sees it, and the account of the lock.
class Lock {
 public:
  Lock(double turns_per_second, double period) : rate_(turns_per_second), period_(period) {}

  /// Since a time at which the index had passed: whole at the moment at which it is taken to pass.
  double turns(double time) const { return rate_ * time + shift_; }
  bool engaged() const { return engaged_; }
  void release() { engaged_ = false; }
  /// Waits for the index, which nobody knows to a part of a period: it is taken to pass in the middle of one. The
  /// encoder sees that at the period's end, the planner one later.
  double wait_for_index(double time) {
    const double index = std::ceil(turns(time) + 1e-9);
    const double period_of_it = std::floor((index - shift_) / rate_ / period_ + kSame);
    engaged_ = matching_ = true;
    shift_ = index - rate_ * (period_of_it + 0.5) * period_;
    zero_ = index;
    periods_ = 0;
    offset_ = 0.0;
    return (period_of_it + 2.0) * period_;
  }
  double target(double time, const PathPiece& piece, const Runner& run) {
    const double now = turns(time) - zero_;
    if (matching_) {
      ++periods_;
      const double wanted = now / (period_ * periods_) * piece.pitch;
      if (run.speed < wanted) return piece.limit;
      offset_ = now - run.way / piece.pitch;
      matching_ = false;
      return wanted;
    }
    const double error = (now - offset_) * piece.pitch - run.way;
    const double closing = std::copysign(std::sqrt(std::abs(error) * piece.acceleration), error);
    return std::max(0.0, rate_ * piece.pitch + closing);
  }
  void finish(const PathPiece& piece) { offset_ += piece.length / piece.pitch; }

 private:
  double rate_, period_;
  double shift_ = 0.0;  // of the index, by up to half a period
  bool engaged_ = false, matching_ = false;
  double zero_ = 0.0, offset_ = 0.0;
  int periods_ = 0;
};

class Planner {
 public:
  Planner(const std::vector<PathPiece>& pieces, double period, double rate,
          const std::vector<double>& back)
      : pieces_(pieces), period_(period), lock_(rate, period), axes_(pieces, period, rate, back) {}

  std::vector<Passing> run() {
    if (!pieces_.empty()) begin(here_, 0);
    if (pieces_.size() > 1) begin(next_, 1);
    while (at_ < pieces_.size()) one_period();
    for (int i = 0; i < 3; ++i) {
      time_ += period_;
      axes_.sample(done_, {time_, lock_.turns(time_)});
    }
    return axes_.ends();
  }

 private:
  const PathPiece* piece(std::size_t i) const { return i < pieces_.size() ? &pieces_[i] : nullptr; }

  void begin(Runner& run, std::size_t i) {
    run = Runner{};
    run.cycle = period_;
    // a locked piece has no speed before it or the one before it is under way
    run.target = pieces_[i].feed;
  }
  double wanted(const PathPiece& p, const Runner& run) const {
    return std::min(run.target, p.limit);
  }
  /// Speed at the end of a piece, under what is asked for now.
  double final_speed(const PathPiece& p, const Runner& run, const PathPiece* after,
                     const Runner& after_run) const {
    if (p.stop || !after) return 0.0;
    return std::min({p.end_speed, wanted(p, run), wanted(*after, after_run)});
  }

  void one_period() {
    const PathPiece& p = pieces_[at_];
    if (!here_.active) {
      here_.active = true;
      const double mean = here_.speed + std::min(p.end_speed, wanted(p, here_));
      here_.ramp = !p.stop && mean > 0.0 && 2.0 * (p.length - here_.way) / mean < kRampSeconds;
    }
    if (p.pitch > 0.0) {
      if (!lock_.engaged()) time_ = lock_.wait_for_index(time_);
      here_.target = lock_.target(time_, p, here_);
      if (const PathPiece* after = piece(at_ + 1))
        if (after->pitch > 0.0) next_.target = here_.target;
    } else {
      lock_.release();
    }
    if (here_.leaving)
      leave(p);
    else
      update(p, here_, piece(at_ + 1), next_);
    time_ = std::round(time_ / period_ + 1.0) * period_;
    axes_.sample(done_ + here_.way + next_.way, {time_, lock_.turns(time_)});
    if (here_.done) complete(p);
  }

  /// The rest of this piece and the beginning of the next share a period.
  void leave(const PathPiece& p) {
    here_.way = p.length;
    here_.done = true;
    const PathPiece* after = piece(at_ + 1);
    if (!after || p.stop) return;
    next_.cycle = period_ - here_.cycle;
    next_.speed = here_.final_speed;
    Runner then;
    if (const PathPiece* third = piece(at_ + 2)) {
      begin(then, at_ + 2);
      update(*after, next_, third, then);
    } else {
      update(*after, next_, nullptr, then);
    }
  }

  void complete(const PathPiece& p) {
    if (p.pitch > 0.0) lock_.finish(p);
    if (p.stop) axes_.stopped(at_, {time_, lock_.turns(time_)});
    done_ += p.length;
    ++at_;
    here_ = next_;
    if (at_ + 1 < pieces_.size())
      begin(next_, at_ + 1);
    else
      next_ = Runner{};
  }

  void update(const PathPiece& p, Runner& run, const PathPiece* after, const Runner& after_run) {
    const double ending = final_speed(p, run, after, after_run), rest = p.length - run.way;
    double speed = 0.0;
    if (run.ramp && ending >= kAtRest) {
      const double mean = 0.5 * (run.speed + ending);
      speed = run.speed +
              within((ending - run.speed) * mean / std::max(rest, kArrived), p.acceleration) *
                  run.cycle;
    } else {
      const double half = 0.5 * p.acceleration * run.cycle;
      const double room = ending * ending + p.acceleration * (2.0 * rest - run.speed * run.cycle);
      const double brakeable = (room > 0.0 ? std::sqrt(room + half * half) : 0.0) - half;
      speed = run.speed +
              within(std::min(brakeable, wanted(p, run)) - run.speed, p.acceleration * run.cycle);
    }
    if (speed < 0.0) {
      if (rest < run.speed * run.cycle) run.way = p.length;
      speed = 0.0;
    } else {
      run.way = std::min(p.length, run.way + 0.5 * (run.speed + speed) * run.cycle);
    }
    run.speed = speed;
    run.cycle = period_;
    look_ahead(p, run, ending);
  }

  /// Whether the piece ends within the next period, and how.
  void look_ahead(const PathPiece& p, Runner& run, double ending) {
    const double rest = p.length - run.way;
    if (rest <= kArrived) {
      run.way = p.length;
      run.leaving = true;
      run.cycle = 0.0;
      run.final_speed = run.speed;
      run.done = p.stop;
      return;
    }
    if (p.stop) return;
    const double mean = 0.5 * (run.speed + ending);
    if (mean <= kAtRest) return;
    double seconds = std::max(0.5 * kInstant, rest / mean);
    const double asked = (ending - run.speed) / seconds;
    const double a = within(asked, p.acceleration);
    if (a != asked) {
      const double square = run.speed * run.speed / (a * a) + 2.0 / a * rest;
      if (square < 0.0) return;
      const double root = square < kInstant * kInstant ? 0.0 : std::sqrt(square);
      seconds = -run.speed / a + (a > 0.0 ? root : -root);
      ending = run.speed + seconds * a;
    }
    if (seconds >= period_) return;
    run.leaving = true;
    run.final_speed = ending;
    run.cycle = seconds < kInstant ? 0.0 : seconds;
    if (seconds < kInstant) run.way = p.length;
  }

  const std::vector<PathPiece>& pieces_;
  double period_;
  Lock lock_;
  Axes axes_;
  Runner here_, next_;
  std::size_t at_ = 0;
  double done_ = 0.0, time_ = 0.0;
};

}  // namespace

std::vector<Passing> planner_cycles(const std::vector<PathPiece>& pieces, double period,
                                    double rate, std::size_t moves) {
  return planner_cycles(pieces, period, rate, std::vector<double>(moves, 1.0));
}

std::vector<Passing> planner_cycles(const std::vector<PathPiece>& pieces, double period,
                                    double rate, const std::vector<double>& back) {
  return Planner(pieces, period, rate, back).run();
}

}  // namespace patchmill::machine
