// Explicit diffusion: exact decay of modes, the stability limit, divergence of the paper's numbers.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/voxel/transient.h"

#include "patchmill/dcm/feed_field.h"
#include "patchmill/geometry/error.h"
#include "patchmill/voxel/laplace_solver.h"
#include "patchmill/voxel/voxelise.h"
#include "voxel/shapes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include <gtest/gtest.h>

namespace patchmill::voxel {
namespace {

// The paper's numbers: dt = 0.1 s, D = 40, dx = 2 mm; r = 1.
TransientOptions paper(double time) {
  TransientOptions options;
  options.time = time;
  options.step = 0.1;
  options.diffusivity = 40.0;
  return options;
}
constexpr double kPaperPitch = 2.0;
constexpr dcm::FeedLimits kPaperFeed{400.0 / 60.0, 800.0 / 60.0};

VoxelGrid convex_grid() {
  VoxelOptions options;
  options.pitch = kPaperPitch;
  return voxelise(mesh::box_mesh(Vec3::Zero(), Vec3(50, 50, 36)), shapes::convex_part(40), options);
}

TEST(Transient, ASineDecaysExactlyAsTheSchemeSays) {
  const int n = 40;  // a row of cells, ends held at zero
  const BrickTable table = shapes::full_table(Cell(n, 1, 1));
  std::vector<CellRole> role(table.cell_count(), CellRole::Outside);
  std::vector<double> field(role.size(), 0.0);
  shapes::for_each_cell(table, [&](std::size_t i, const Cell& c) {
    role[i] = c.x() == 0 || c.x() == n - 1 ? CellRole::Held : CellRole::Unknown;
    if (role[i] == CellRole::Unknown) field[i] = std::sin(3 * kPi * c.x() / (n - 1));
  });
  TransientOptions options;
  options.time = 2.0;
  options.step = 0.02;
  options.diffusivity = 6.0;  // r = 0.12 at 1 mm
  ASSERT_EQ(diffuse_transient(table, role, DiffusionAxes::X, 1.0, options, field), 100);
  const double decay = 1.0 - 4.0 * 0.12 * std::pow(std::sin(3 * kPi / (2.0 * (n - 1))), 2);
  shapes::for_each_cell(table, [&](std::size_t i, const Cell& c) {
    const double start = c.x() == n - 1 ? 0.0 : std::sin(3 * kPi * c.x() / (n - 1));
    ASSERT_NEAR(field[i], start * std::pow(decay, 100), 1e-13);
  });
}

TEST(Transient, EndsInTheSteadyState) {
  const VoxelGrid grid = convex_grid();
  const auto role = dcm::roles(grid, dcm::ExteriorRule::Held);
  std::vector<double> late = dcm::initial_feed(grid, kPaperFeed);
  TransientOptions options = paper(400.0);
  options.substep = true;
  EXPECT_EQ(diffuse_transient(grid.table, role, DiffusionAxes::X, kPaperPitch, options, late),
            8000);
  const dcm::FeedField steady = dcm::steady_feed(grid, kPaperFeed);
  for (std::size_t i = 0; i < late.size(); ++i) {
    if (role[i] == CellRole::Unknown) {
      ASSERT_NEAR(late[i], steady.along[0][i], 1e-9);
    }
  }
}

TEST(Transient, InThreeDimensionsItEndsInTheSolversSteadyState) {
  const VoxelGrid grid = convex_grid();
  const auto role = dcm::roles(grid, dcm::ExteriorRule::Held);
  std::vector<double> late = dcm::initial_feed(grid, kPaperFeed);
  TransientOptions options = paper(60.0);
  options.substep = true;
  diffuse_transient(grid.table, role, DiffusionAxes::All, kPaperPitch, options, late);
  std::vector<std::vector<double>> steady{dcm::initial_feed(grid, kPaperFeed)};
  LaplaceOptions solver;
  solver.tolerance = 1e-11;
  ASSERT_TRUE(solve_laplace(grid.table, role, steady, solver).converged);
  for (std::size_t i = 0; i < late.size(); ++i) {
    if (role[i] == CellRole::Unknown) {
      ASSERT_NEAR(late[i], steady[0][i], 1e-7);
    }
  }
}

TEST(Transient, WithAFreeExteriorVHiAsInitialValueIsLost) {
  const VoxelGrid grid = convex_grid();
  std::vector<double> field = dcm::initial_feed(grid, kPaperFeed);
  TransientOptions options = paper(1200.0);
  options.substep = true;
  diffuse_transient(grid.table, dcm::roles(grid, dcm::ExteriorRule::Free), DiffusionAxes::Z,
                    kPaperPitch, options, field);
  for (std::size_t i = 0; i < field.size(); ++i) {
    if (grid.kind[i] == VoxelKind::Removal || grid.kind[i] == VoxelKind::Exterior) {
      ASSERT_NEAR(field[i], kPaperFeed.low, 1e-3 * kPaperFeed.low);
    }
  }
}

TEST(Transient, ThePapersNumbersAreRefusedWithTheLimitNamed) {
  for (const auto& [axes, limit, longest] :
       {std::tuple(DiffusionAxes::X, "r = 0.5:", "at most 0.05 s"),
        std::tuple(DiffusionAxes::All, "r = 0.1667:", "at most 0.01667 s")}) {
    try {
      transient_steps(axes, kPaperPitch, paper(10.0));
      FAIL() << "accepted";
    } catch (const InputError& e) {
      EXPECT_EQ(e.property(), "time step");
      EXPECT_EQ(e.value(), "0.1 s, r = D dt / dx^2 = 1");
      EXPECT_NE(e.remedy().find(limit), std::string::npos) << e.remedy();
      EXPECT_NE(e.remedy().find(longest), std::string::npos) << e.remedy();
    }
  }
  TransientOptions finer = paper(10.0);
  finer.substep = true;
  EXPECT_EQ(transient_steps(DiffusionAxes::X, kPaperPitch, finer), 200);
  EXPECT_EQ(transient_steps(DiffusionAxes::All, kPaperPitch, finer), 600);
}

TEST(Transient, ThePapersNumbersWouldDiverge) {
  const VoxelGrid grid = convex_grid();
  const auto role = dcm::roles(grid, dcm::ExteriorRule::Held);
  for (const auto axes : {DiffusionAxes::X, DiffusionAxes::All}) {
    std::vector<double> now = dcm::initial_feed(grid, kPaperFeed), next(now.size());
    for (int step = 0; step < 30; ++step) {
      explicit_step(grid.table, role, axes, 1.0, now, next);
      now.swap(next);
    }
    const double largest = *std::max_element(now.begin(), now.end());
    std::printf("paper's step, 30 times: largest feed %.3g mm/min of at most 800\n", 60 * largest);
    EXPECT_GT(largest, 1000.0 * kPaperFeed.high);
  }
}

}  // namespace
}  // namespace patchmill::voxel
