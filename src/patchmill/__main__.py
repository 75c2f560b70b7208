"""`python3 -m patchmill`: the command (see patchmill.batch.command).

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import sys

from patchmill.batch.command import main

sys.exit(main())
