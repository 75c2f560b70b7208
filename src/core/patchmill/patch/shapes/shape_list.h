// The patch shapes there are, in the order in which they are offered. A new shape is a line here and a file beside
// this one that defines its ShapeTraits.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#define PATCHMILL_PATCH_SHAPES(SHAPE) \
  SHAPE(Square)                       \
  SHAPE(Hexagon)                      \
  SHAPE(Triangle)                     \
  SHAPE(Rectangle)
