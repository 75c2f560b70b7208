"""Whether a path can be and was milled as planned: clearance, simulation, motion, read-back, live sessions.

SPDX-License-Identifier: LGPL-2.1-or-later
"""
