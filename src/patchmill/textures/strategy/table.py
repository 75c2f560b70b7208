"""The strategies that keep the phase: a table of objects, each with all its answers. Another one is another
class and a row of the table.

    Constant feed                 Xu & Sasahara 2016: polygons of a length (docs/constant-feed.md)
    Constant feed, fitted stops   the same, with legs fitted to the machine's stops
    Feed per move                 straight on, F = d / T
    Spindle-locked                straight on, K = d / Lambda: G33 (docs/synchronisation.md)

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from math import radians

import _patchmill as core
from _patchmill import InputError


class Strategy:
    """From dimples to a ToolPath that keeps the phase, and to the words of FreeCAD's Path. `given` is a
    TextureInput, `machine` a machines.Machine or None."""

    name = ""  # as documents save it
    needs_machine = True
    locked = False  # feeds are in turns of the spindle, which the control follows
    polygons = False  # turns are spent on polygons of a length: ExtraTurns counts, else Lift
    phase_in_text = False  # the posted words alone say the phase; else the machine's motion does

    def require(self, machine):
        """Raises InputError naming Machine or Strategy if it cannot be used on `machine`."""
        if self.needs_machine and machine is None:
            raise InputError("Machine", "''", "the strategy '%s' needs a machine file." % self.name)
        if self.locked and not machine.model.spindle_lock:
            remedy = "the machine %s says that its controller cannot follow the spindle: use feed per move or"
            raise InputError("Strategy", self.name, remedy % machine.key + " constant feed.")

    def path(self, given, dimples, rule, machine, spindle, turning):
        """(ToolPath of the ball centre, clearance of _patchmill.paced_path or None). `rule`: a
        _patchmill.PhaseRule; `turning`: see turning_seconds. Raises InputError as the core names."""
        raise NotImplementedError

    def text(self, given, path, feed, machine):
        """_patchmill.PathText of the path for Path.Path(); `feed` [mm/s] as it is posted."""
        raise NotImplementedError

    def tool_axes(self, given, dimples, axes):
        """The (n, 3) unit tool axes that it can follow, near to those asked for."""
        return axes

    def turning_seconds(self, kinematics, dimples, postures, given, machine, form):
        """What the rotary axes take before each dimple that must wait for them [s]; [] where none does."""
        return []


class ConstantFeed(Strategy):
    name = "Constant feed"
    needs_machine = False
    polygons = phase_in_text = True

    def path(self, given, dimples, rule, machine, spindle, turning):
        heights = {"safe_height": given.safe_height, "clearance_height": given.clearance_height}
        path = core.constant_feed_path(
            dimples, given.tool, spindle, given.feed, rule, decimals=given.decimals, **heights
        )
        return path, None

    def text(self, given, path, feed, machine):
        # the motion model of a machine without a path tolerance counts on a stop at every vertex
        stops = machine is not None and machine.data["path_tolerance_mm"] == 0.0
        return core.freecad_text(path, feed, given.decimals, exact_stop=stops)


class FittedStops(ConstantFeed):
    name = "Constant feed, fitted stops"
    needs_machine = True
    phase_in_text = False

    def path(self, given, dimples, rule, machine, spindle, turning):
        path, clearance = super().path(given, dimples, rule, machine, spindle, turning)
        feed = core.posted_feed(given.feed, given.decimals)
        return core.fit_to_stops(path, machine.model, feed, rule, given.decimals), clearance


class FeedPerMove(Strategy):
    name = "Feed per move"

    def path(self, given, dimples, rule, machine, spindle, turning):
        paced = core.PacedRule(
            self.locked,
            rule,
            given.lift,
            safe_height=given.safe_height,
            clearance_height=given.clearance_height,
            turning=turning,
            rows=given.rows_across_patches,
        )
        return core.paced_path(dimples, given.tool, spindle, paced, machine.model, given.decimals)

    def text(self, given, path, feed, machine):
        return core.freecad_paced_text(path, machine.model, given.decimals)


class SpindleLocked(FeedPerMove):
    name = "Spindle-locked"
    locked = True

    def tool_axes(self, given, dimples, axes):
        """In a locked row the rotary axes stand."""
        return core.axes_by_row(dimples, axes, radians(given.row_tolerance))

    def turning_seconds(self, kinematics, dimples, postures, given, machine, form):
        return core.turning_seconds(kinematics, dimples, postures, given.tool, machine.model, form)


STRATEGIES = {one.name: one for one in (ConstantFeed(), FittedStops(), FeedPerMove(), SpindleLocked())}
NAMES = tuple(STRATEGIES)


def of(name):
    """The Strategy of a name. Raises InputError naming Strategy."""
    if name not in STRATEGIES:
        raise InputError("Strategy", name, "give one of: %s." % "; ".join(NAMES))
    return STRATEGIES[name]
