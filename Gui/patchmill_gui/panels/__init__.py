"""The panels: of each operation with its view provider, of checks, simulation, reports and playing.

SPDX-License-Identifier: LGPL-2.1-or-later
"""
