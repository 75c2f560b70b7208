// Copy milling takes no option that is out of its range, at either end, and names it.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/copy/copy_milling.h"
#include "patchmill/geometry/error.h"

#include <functional>
#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace patchmill::copy {
namespace {

CopyOptions good() {
  CopyOptions options;
  options.tool = {3.0, 2};
  options.spindle.speed = 100.0;
  options.feed = 10.0;
  options.radial_depth = options.axial_depth = 2.0;
  options.stock.include(Vec3::Zero());
  options.stock.include(Vec3(20.0, 20.0, 10.0));
  return options;
}

void expect_refused(const std::string& property, const std::function<void(CopyOptions&)>& change) {
  CopyOptions options = good();
  change(options);
  try {
    require_valid(options);
    ADD_FAILURE() << property << " was taken";
  } catch (const InputError& error) {
    EXPECT_EQ(error.property(), property);
  }
}

TEST(CopyOptions, AreTakenUpToTheEndsOfTheirRanges) {
  require_valid(good());
  for (const double overlap : {0.0, 3.0}) {
    CopyOptions options = good();
    options.overlap = overlap;
    require_valid(options);
  }
  for (const double allowance : {0.0, 1e3}) {
    CopyOptions options = good();
    options.allowance = allowance;
    require_valid(options);
  }
}

TEST(CopyOptions, BeyondThemAreRefusedByName) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {-1e-6, 3.001, nan})
    expect_refused("overlap", [&](CopyOptions& o) { o.overlap = bad; });
  for (const double bad : {-1e-6, 1001.0, nan})
    expect_refused("allowance", [&](CopyOptions& o) { o.allowance = bad; });
  for (const double bad : {0.5e-4, 3.001, nan})
    expect_refused("tolerance", [&](CopyOptions& o) { o.tolerance = bad; });
  for (const double bad : {0.0, -1.0, nan}) {
    expect_refused("feed", [&](CopyOptions& o) { o.feed = bad; });
    expect_refused("radial depth of cut", [&](CopyOptions& o) { o.radial_depth = bad; });
    expect_refused("axial depth of cut", [&](CopyOptions& o) { o.axial_depth = bad; });
    expect_refused("clearance", [&](CopyOptions& o) { o.clearance = bad; });
    expect_refused("spindle speed", [&](CopyOptions& o) { o.spindle.speed = bad; });
  }
}

}  // namespace
}  // namespace patchmill::copy
