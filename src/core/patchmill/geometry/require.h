// Checks of arguments that are vectors or lists; those of single numbers are in error.h. What passes them is
// finite, so that no NaN gets into a path or a program unseen.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/geometry/error.h"
#include "patchmill/geometry/vec.h"

#include <cstddef>

namespace patchmill {

/// Throws InputError unless `value` is finite. `unit` is for the message only.
void require_finite(const char* property, double value, const char* unit);

/// Throws InputError unless every component is finite.
void require_finite(const char* property, const Eigen::Ref<const Eigen::VectorXd>& value,
                    const char* unit);

/// The unit vector along `direction`, of any length. Throws InputError unless it is finite and longer than
/// 1e-9 by its largest component.
Vec3 unit_along(const char* property, const Vec3& direction);

/// Throws InputError unless a list has as many entries as there are things to give one for: `given` ==
/// `wanted`. `of` is the plural of the thing, for the message: "dimples".
void require_one_each(const char* property, std::size_t given, std::size_t wanted, const char* of);

}  // namespace patchmill
