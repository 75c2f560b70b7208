"""The strategies that keep the phase.

SPDX-License-Identifier: LGPL-2.1-or-later
"""
