// What the programs that make G-code for the controller tests share: key=value options, the dimples, and how
// an error is told.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patch/table1_surface.h"
#include "patchmill/geometry/error.h"
#include "patchmill/machine/motion_model.h"
#include "patchmill/patch/row_order.h"
#include "patchmill/sync/contact_azimuth.h"

#include <iostream>
#include <map>
#include <string>

namespace patchmill {

class Options {
 public:
  /// Words key=value from argument `first` on.
  Options(int argc, char** argv, int first) {
    for (int i = first; i < argc; ++i) {
      const std::string word = argv[i];
      const std::size_t equals = word.find('=');
      words_[word.substr(0, equals)] = word.substr(equals + 1);
    }
  }
  double number(const std::string& key, double otherwise) const {
    const auto at = words_.find(key);
    return at == words_.end() ? otherwise : std::stod(at->second);
  }
  std::string word(const std::string& key, const std::string& otherwise) const {
    const auto at = words_.find(key);
    return at == words_.end() ? otherwise : at->second;
  }

 private:
  std::map<std::string, std::string> words_;
};

/// A controller that can follow the spindle; acceleration [mm/s^2] and velocity [mm/s] as given.
inline machine::MotionModel locked_model(const char* acceleration, const char* velocity) {
  machine::MotionModel model;
  model.acceleration = std::stod(acceleration);
  model.velocity = std::stod(velocity);
  model.spindle_lock = true;
  return model;
}

/// One, two or four patches of side x side dimples in the corner of the paper's surface, 0.5 mm apart.
inline patch::Dimples corner_dimples(int side, int patches) {
  return patch::table1_dimples_from({-27.5, -27.5}, side, patches > 1 ? 2 : 1, patches > 2 ? 2 : 1);
}

/// The axis of a leaned tool, from the options ax, ay, az; upright without them.
inline Vec3 leaned_axis(const Options& options) {
  return Vec3(options.number("ax", 0.0), options.number("ay", 0.0), options.number("az", 1.0))
      .normalized();
}

/// What turns that axis upright.
inline Eigen::Matrix3d upright_from(const Options& options) {
  return Eigen::Quaterniond::FromTwoVectors(leaned_axis(options), Vec3::UnitZ()).toRotationMatrix();
}

/// Contact azimuth of each dimple about a leaned axis; none for a tool that stands upright.
inline std::vector<Angle> leaned_azimuths(const patch::Dimples& dimples, const Options& options) {
  std::vector<Angle> azimuths;
  if (leaned_axis(options) == Vec3::UnitZ()) return azimuths;
  const Eigen::Matrix3d turn = upright_from(options);
  for (const patch::Dimple& dimple : dimples)
    azimuths.push_back(sync::contact_azimuth(Vec3(turn * dimple.surface.normal)));
  return azimuths;
}

/// The dimples that the options ask for on the paper's surface: `side`, `spacing`, `triangle`, `x` and `y` of the
/// first dimple [mm]; on the whole face, 64 patches, those near the tip are left out; with `rows` in rows along
/// lattice step `direction`, to and fro unless `oneway`.
inline patch::Dimples dimples_of(const Options& options, int patches) {
  const int side = static_cast<int>(options.number("side", 14));
  const double spacing = options.number("spacing", 0.5);
  const bool triangle = options.number("triangle", 0.0) > 0.0;
  const patch::PatchShape shape =
      triangle ? patch::PatchShape::Triangle : patch::PatchShape::Square;
  const Vec2 first(options.number("x", -27.5), options.number("y", -27.5));
  const int across = patches == 64 ? static_cast<int>(std::lround(112.0 / side))
                     : patches > 1 ? 2
                                   : 1;
  const int up = patches == 64 ? across : patches > 2 ? 2 : 1;
  patch::Dimples dimples =
      patches == 64 ? patch::table1_dimples(shape, side, across, up, spacing, Vec2::Zero())
                    : patch::table1_dimples_from(shape, first, side, across, up, spacing);
  if (patches == 64)
    sync::mark_tool_tip(dimples, leaned_axis(options), Angle::degrees(options.number("tip", 1.0)));
  if (options.number("rows", 0.0) <= 0.0) return dimples;
  patch::RowOrder order;
  order.direction = static_cast<std::size_t>(options.number("direction", 0.0));
  order.one_way = options.number("oneway", 0.0) > 0.0;
  return patch::in_rows(dimples, patch::lattice_of(shape), order);
}

/// The exit status of run(argc, argv); an InputError is told on standard error. `usage` is told if there are
/// less than `least` arguments.
template <class Run>
int run_or_tell(Run run, int argc, char** argv, int least, const char* usage) {
  if (argc <= least) {
    std::cerr << usage << "\n";
    return 2;
  }
  try {
    run(argc, argv);
    return 0;
  } catch (const InputError& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}

}  // namespace patchmill
