"""Machine files from the configuration of a LinuxCNC machine.

SPDX-License-Identifier: LGPL-2.1-or-later
"""
