// A level of detail that lives under any action. Coin's own asks for matrices and the viewport whatever action comes
// by; FreeCAD's actions for preselection, highlight colours and the like carry none, and the program ends there.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Inventor/nodes/SoLevelOfDetail.h>

namespace patchmill::scene {

/// As SoLevelOfDetail under actions that know the view; under all others a group: every child is visited.
/// Call initClass() before the first is made, in the GUI's thread and after Coin's own start.
class SafeLevelOfDetail : public SoLevelOfDetail {
  SO_NODE_HEADER(SafeLevelOfDetail);

 public:
  SafeLevelOfDetail();
  /// Tells Coin of the class; again is no harm.
  static void initClass();

  void doAction(SoAction* action) override;

 protected:
  ~SafeLevelOfDetail() override = default;
};

/// A new one, of a class that Coin knows.
SafeLevelOfDetail* make_detail();

}  // namespace patchmill::scene
