// Choosing among levels only where the action knows the view; see safe_detail.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene/safe_detail.h"

#include <Inventor/actions/SoAction.h>
#include <Inventor/elements/SoComplexityElement.h>
#include <Inventor/elements/SoComplexityTypeElement.h>
#include <Inventor/elements/SoModelMatrixElement.h>
#include <Inventor/elements/SoProjectionMatrixElement.h>
#include <Inventor/elements/SoViewVolumeElement.h>
#include <Inventor/elements/SoViewingMatrixElement.h>
#include <Inventor/elements/SoViewportRegionElement.h>
#include <Inventor/misc/SoState.h>
#include <initializer_list>

namespace patchmill::scene {
namespace {

// Everything from which Coin computes how many pixels a node takes.
bool knows_view(const SoState* state) {
  for (const int element :
       {SoModelMatrixElement::getClassStackIndex(), SoViewportRegionElement::getClassStackIndex(),
        SoViewVolumeElement::getClassStackIndex(), SoViewingMatrixElement::getClassStackIndex(),
        SoProjectionMatrixElement::getClassStackIndex(), SoComplexityElement::getClassStackIndex(),
        SoComplexityTypeElement::getClassStackIndex()})
    if (!state->isElementEnabled(element)) return false;
  return true;
}

}  // namespace

SO_NODE_SOURCE(SafeLevelOfDetail)

SafeLevelOfDetail::SafeLevelOfDetail() {
  SO_NODE_CONSTRUCTOR(SafeLevelOfDetail);
}

void SafeLevelOfDetail::initClass() {
  if (getClassTypeId() != SoType::badType()) return;
  SO_NODE_INIT_CLASS(SafeLevelOfDetail, SoLevelOfDetail, "SoLevelOfDetail");
}

void SafeLevelOfDetail::doAction(SoAction* action) {
  if (knows_view(action->getState()))
    SoLevelOfDetail::doAction(action);
  else
    SoGroup::doAction(action);
}

SafeLevelOfDetail* make_detail() {
  SafeLevelOfDetail::initClass();
  return new SafeLevelOfDetail;
}

}  // namespace patchmill::scene
