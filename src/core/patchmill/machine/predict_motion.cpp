// Period-by-period prediction; see predict_motion.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/machine/predict_motion.h"

#include "patchmill/geometry/error.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace patchmill::machine {
namespace {

constexpr double kArrived = 1e-12;  // mm

// A straight or a rounding: what the controller plans as one.
struct Piece {
  std::size_t move;        // whose end is in it, see `mark`
  double length;           // mm
  double acceleration;     // along it, mm/s²
  double limit;            // greatest speed, mm/s
  double feed;             // mm/s; 0: locked
  double pitch;            // mm per turn if locked
  double mark = -1.0;      // way into the piece at which the move ends; -1: not in this one
  bool stop = false;       // the tool stands still at its end
  double end_speed = 0.0;  // allowed, from the backward pass
};

std::vector<Piece> cut_into_pieces(const ToolPath& path, const MotionModel& model) {
  const std::vector<Corner> corner = corners(path, model);
  const std::vector<double> pitch = locked_pitches(path, corner);
  std::vector<Piece> pieces;
  pieces.reserve(2 * path.moves.size());
  Vec3 from = path.start.tip;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Move& move = path.moves[i];
    const Vec3 way = move.end.tip - from;
    from = move.end.tip;
    const double length = way.norm();
    if (length < kArrived) continue;
    const double limit = velocity_along(model, way / length);
    const double acceleration = acceleration_beside(i ? corner[i - 1] : Corner{}, corner[i],
                                                    acceleration_along(model, way / length));
    double feed = 0.0;
    if (move.pace == Pace::Feed)
      feed =
          std::isnan(move.turns) ? limit : std::min(limit, length / duration(move, path.spindle));
    if (move.pace == Pace::Feed && !(feed > 0.0))
      throw InputError("Turns", fmt::format("{} in move {}", move.turns, i),
                       "a timed move needs more than no turns.");
    const bool arc = !corner[i].stop && corner[i].arc > 0.0;
    const double before = i ? corner[i - 1].trim : 0.0;
    Piece line{i, length - before - corner[i].trim, acceleration, limit, feed, pitch[i]};
    line.stop = corner[i].stop;
    if (!arc) line.mark = line.length;
    pieces.push_back(line);
    if (!arc) continue;
    Piece bend{i,
               corner[i].arc,
               0.5 * model.acceleration,
               std::min(limit, corner[i].speed),
               feed,
               i + 1 < pitch.size() ? pitch[i + 1] : pitch[i]};
    bend.mark = 0.5 * bend.length;
    pieces.push_back(bend);
  }
  return pieces;
}

void plan_backwards(std::vector<Piece>& pieces) {
  double after = 0.0;  // speed at which the piece after may be entered
  for (std::size_t i = pieces.size(); i-- > 0;) {
    Piece& piece = pieces[i];
    piece.end_speed = piece.stop ? 0.0 : std::min(after, piece.limit);
    after = std::min(piece.limit, std::sqrt(piece.end_speed * piece.end_speed +
                                            2.0 * piece.acceleration * piece.length));
  }
}

// The spindle as the controller sees it, and the account of the lock.
class Lock {
 public:
  Lock(double turns_per_second, double period) : rate_(turns_per_second), period_(period) {}

  double turns(double time) const { return rate_ * time; }
  bool engaged() const { return engaged_; }
  void release() { engaged_ = false; }
  /// Waits for the index: the first period after a whole number of turns.
  double wait_for_index(double time) {
    const double index = std::ceil(turns(time) + 1e-9) / rate_;
    engaged_ = matching_ = true;
    zero_ = turns(index);
    periods_ = 0;
    offset_ = 0.0;
    return std::ceil(index / period_) * period_;
  }
  double target(double time, const Piece& piece, double way, double speed) {
    const double now = turns(time) - zero_;
    if (matching_) {
      ++periods_;
      const double wanted = now / (period_ * periods_) * piece.pitch;
      if (speed < wanted) return piece.limit;
      offset_ = now - way / piece.pitch;
      matching_ = false;
      return wanted;
    }
    const double error = (now - offset_) * piece.pitch - way;
    const double closing = std::copysign(std::sqrt(std::abs(error) * piece.acceleration), error);
    return std::max(0.0, rate_ * piece.pitch + closing);
  }
  void finish(const Piece& piece) { offset_ += piece.length / piece.pitch; }

 private:
  double rate_, period_;
  bool engaged_ = false, matching_ = false;
  double zero_ = 0.0, offset_ = 0.0;
  int periods_ = 0;
};

class Simulation {
 public:
  Simulation(std::vector<Piece> pieces, const MotionModel& model, double rate, std::size_t moves)
      : pieces_(std::move(pieces)),
        period_(model.period),
        lock_(rate, model.period),
        ends_(moves) {}

  std::vector<Passing> run() {
    while (at_ < pieces_.size()) one_period();
    return std::move(ends_);
  }

 private:
  double target() {
    const Piece& piece = pieces_[at_];
    if (piece.pitch <= 0.0) {
      lock_.release();
      return piece.feed;
    }
    if (!lock_.engaged()) time_ = lock_.wait_for_index(time_);
    return std::min(piece.limit, lock_.target(time_, piece, way_, speed_));
  }

  void one_period() {
    const double wanted = target();
    double left = period_;
    while (left > 0.0 && at_ < pieces_.size()) {
      if (!pieces_[at_].stop && finish_within(left, wanted)) continue;
      step(left, wanted);
      left = 0.0;
    }
    time_ = std::round(time_ / period_) * period_;
  }

  /// Runs through the end of a piece that is not stopped at, if that is nearer than `left`.
  bool finish_within(double& left, double wanted) {
    const Piece& piece = pieces_[at_];
    const double rest = piece.length - way_;
    const double reach = piece.acceleration * left;
    const double speed = std::clamp(std::min(piece.end_speed, wanted),
                                    std::max(0.0, speed_ - reach), speed_ + reach);
    const double mean = 0.5 * (speed_ + speed);
    if (rest > mean * left) return false;
    const double duration = mean > 0.0 ? rest / mean : 0.0;
    move_on(rest, duration);
    left -= duration;
    speed_ = speed;
    next_piece();
    return true;
  }

  void step(double dt, double wanted) {
    const Piece& piece = pieces_[at_];
    const SampledStep next =
        sampled_step(piece.length - way_, speed_, piece.end_speed, wanted, piece.acceleration, dt);
    move_on(next.way, dt);
    speed_ = next.speed;
    if (piece.length - way_ > kArrived) return;
    if (piece.stop) speed_ = 0.0;
    next_piece();
  }

  void move_on(double advance, double dt) {
    const Piece& piece = pieces_[at_];
    if (piece.mark >= way_ && piece.mark <= way_ + advance + kArrived) {
      const double share = advance > 0.0 ? std::min(1.0, (piece.mark - way_) / advance) : 1.0;
      const double t = time_ + share * dt;
      ends_[piece.move] = {t, lock_.turns(t)};
    }
    way_ += advance;
    time_ += dt;
  }

  void next_piece() {
    if (pieces_[at_].pitch > 0.0) lock_.finish(pieces_[at_]);
    ++at_;
    way_ = 0.0;
  }

  std::vector<Piece> pieces_;
  double period_;
  Lock lock_;
  std::vector<Passing> ends_;
  std::size_t at_ = 0;
  double way_ = 0.0, speed_ = 0.0, time_ = 0.0;
};

// With a jerk limit: rest to rest, each move by its closed form, rounded up to whole periods.
Prediction predict_stops(const std::vector<Piece>& pieces, const ToolPath& path,
                         const MotionModel& model, double rate) {
  Prediction result;
  result.ends.resize(path.moves.size());
  double time = 0.0;
  for (const Piece& piece : pieces) {
    if (!piece.stop || piece.pitch > 0.0) {
      result.reason = "a finite jerk limit is only known for moves that stop, timed by their feed";
      return result;
    }
    const double t = stop_to_stop_time(piece.length, piece.feed, piece.acceleration, model.jerk);
    time += std::ceil(t / model.period - 1e-9) * model.period;
    result.ends[piece.move] = {time, time * rate};
  }
  result.known = true;
  return result;
}

}  // namespace

Prediction predict(const ToolPath& path, const MotionModel& model, double speed_ratio) {
  require_valid(model);
  std::vector<Piece> pieces = cut_into_pieces(path, model);
  plan_backwards(pieces);
  const double rate = path.spindle.speed * speed_ratio;
  if (std::isfinite(model.jerk)) return predict_stops(pieces, path, model, rate);
  Simulation simulation(std::move(pieces), model, rate, path.moves.size());
  return {true, {}, simulation.run()};
}

}  // namespace patchmill::machine
