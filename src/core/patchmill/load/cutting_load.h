// Cutting load: what the stock resists a tool with. Kienzle 1952 ("Die Bestimmung von Kraeften und Leistungen an
// spanenden Werkzeugen und Werkzeugmaschinen", VDI-Z 94, 299-305): on an edge of length b that takes a chip h thick the
// cutting force is
//     F_c = k_c b h,   k_c = k_c1.1 (h / 1 mm)^-m_c
// Of a mill that moves by f_z for each tooth, h = f_z (n . d) where the cutting surface has the normal n and the tool
// goes in the direction d (Altintas, "Manufacturing Automation", 2nd ed. 2012, section 2.8: h = f_z sin phi sin kappa).
// All that depends on where the tool meets the stock is therefore a few numbers, its engagement, and the feed stays a
// factor: the largest feed within a limit is known in closed form.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/path/tool_path.h"

#include <limits>

namespace patchmill::load {

/// What a material resists with.
struct Resistance {
  double specific = 2000.0;  ///< k_c1.1: of a chip 1 mm thick and wide [N/mm^2], > 0, at most 1e5
  double exponent = 0.25;    ///< m_c, 0 .. 0.9: how much thin chips resist more
  double normal = 0.3;       ///< force normal to the cutting surface over the cutting force, 0 .. 5
};

/// Where the tool meets the stock, over a stretch of its way. With S the cutting surface that is at work:
struct Engagement {
  double section = 0.0;  ///< volume taken for each length of the way, integral of n.d over S [mm^2]
  double chip = 0.0;     ///< mean of n.d over S: the mean chip thickness over f_z, 0 .. 1
  double power = 0.0;    ///< integral of (n.d)^(1 - m_c) over S [mm^2]
  double force =
      0.0;  ///< largest force in a turn, all teeth together, over k_c1.1 f_z^(1 - m_c) [mm]
};

/// The load itself.
struct Load {
  double removal = 0.0;  ///< material removed [mm^3/s]
  double chip = 0.0;     ///< mean chip thickness [mm]
  double force = 0.0;    ///< largest on the tool in a turn [N]
  double power = 0.0;    ///< at the edges, mean over a turn [W]
};

/// What the load is to stay within; infinite means: not looked at.
struct LoadLimits {
  double chip = std::numeric_limits<double>::infinity();   ///< mean chip thickness [mm], > 0
  double force = std::numeric_limits<double>::infinity();  ///< [N], > 0
  double power = std::numeric_limits<double>::infinity();  ///< [W], > 0
};

/// Errors: InputError naming SpecificForce, ForceExponent or NormalForce.
void require_valid(const Resistance& resistance);

/// Errors: InputError naming ChipLimit, ForceLimit or PowerLimit.
void require_valid(const LoadLimits& limits);

/// The load at a feed [mm/s] > 0 with `teeth` [1/s] > 0 of them coming by in a second.
Load load_at(const Engagement& engagement, const Resistance& resistance, double feed, double teeth);

/// The largest feed [mm/s] that keeps all limits; infinite where nothing is cut.
double largest_feed(const Engagement& engagement, const Resistance& resistance,
                    const LoadLimits& limits, double teeth);

}  // namespace patchmill::load
