// What the programs that make G-code for the controller tests share: key=value options, the dimples, and how
// an error is told.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patch/table1_surface.h"
#include "patchmill/geometry/error.h"
#include "patchmill/machine/motion_model.h"

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
