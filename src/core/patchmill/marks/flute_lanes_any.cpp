// The simulator's innermost loop for any processor: registers of four lanes.
// SPDX-License-Identifier: LGPL-2.1-or-later
#define PATCHMILL_LANES 4
#define PATCHMILL_ISA any_processor
#include "patchmill/marks/flute_rows.h"
