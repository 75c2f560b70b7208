"""The controller harness: run a program through LinuxCNC and measure what moved.

SPDX-License-Identifier: LGPL-2.1-or-later
"""
