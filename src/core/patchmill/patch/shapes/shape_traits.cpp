// The table of patch shapes; see shape_traits.h.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include "patchmill/patch/shapes/shape_traits.h"

namespace patchmill::patch {

#define PATCHMILL_DECLARE_SHAPE(name) extern const ShapeTraits k##name##Shape;
PATCHMILL_PATCH_SHAPES(PATCHMILL_DECLARE_SHAPE)
#undef PATCHMILL_DECLARE_SHAPE

const ShapeTraits& traits(PatchShape shape) {
#define PATCHMILL_SHAPE_CASE(name) \
  case PatchShape::name:           \
    return k##name##Shape;
  switch (shape) { PATCHMILL_PATCH_SHAPES(PATCHMILL_SHAPE_CASE) }
#undef PATCHMILL_SHAPE_CASE
  return kSquareShape;
}

const std::vector<PatchShape>& all_patch_shapes() {
#define PATCHMILL_SHAPE_ENTRY(name) PatchShape::name,
  static const std::vector<PatchShape> all{PATCHMILL_PATCH_SHAPES(PATCHMILL_SHAPE_ENTRY)};
#undef PATCHMILL_SHAPE_ENTRY
  return all;
}

int corners(PatchShape shape) {
  return static_cast<int>(traits(shape).outline(traits(shape).least, false).size());
}

bool is_regular(PatchShape shape) {
  return traits(shape).turns == corners(shape);
}

double row_pitch(PatchShape shape) {
  return second_axis(traits(shape).lattice).y();
}

}  // namespace patchmill::patch
