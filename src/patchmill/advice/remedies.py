"""What helps where a texture cannot be good: each remedy is tried before it is offered.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from dataclasses import dataclass, field, replace
from functools import partial

from _patchmill import InputError

from patchmill.advice import orientation, room, sides
from patchmill.advice.choice import POLYGONS, first_ways
from patchmill.advice.found import (
    GOOD_FRACTION, MIN_GAIN, Assessment, is_better, is_enough, largest_good_run, leaves_good,
)  # fmt: skip
from patchmill.machine import machines
from patchmill.system.stops import stoppable
from patchmill.textures import tool_posture
from patchmill.textures.plan import plan_texture

LEAD = 20.0  # of a tool that follows the normals [degrees]
FINER = (0.6, 0.4)  # of the spacing
WORTH_TRYING = 0.75  # of what one setup reaches of the faces, at good tilts by their normals
UPRIGHT = (0.0, 0.0, 1.0)
LAID = {"mapping": "On surface", "steepest_slope": orientation.LAID_STEEP}
MOST = 0.75  # of what the best makes good: what leaves only good dimples is better even if that is less
ENOUGH = 2  # good remedies, after which dearer ones are not tried


@dataclass
class Remedy:
    """`kind`: values, incline, lean, along, finer, lay, leave out, sides, ball (a smaller one, with values
    that suit). `fields`: of a TextureInput; `axis` and `angle` [degrees]: how the part is turned about its
    middle, or the tool the other way; `others`: sides.Side of the textures that share the faces; `walled`: a
    wider margin, and rows in the direction that does, keep the tool off walls."""

    kind: str
    fields: dict
    assessment: Assessment
    axis: tuple = None
    angle: float = 0.0
    others: list = field(default_factory=list)
    walled: bool = False


class Finder:
    """Looks for remedies. `assess`: see assessment.with_simulation; `choose`: choice.choose with it.
    `free`, `can_incline`: the tool controller, and how the part lies, may be changed, too; `chosen`: fields
    that choose() gave the texture, if it still has them, else None; `before`: feed and spindle that the tool
    controller had before them, from which every remedy chooses its own; `model`: BREP texts of all that is
    turned when the part is, for it may be higher than the faces (apply.model_of)."""

    def __init__(self, assess, choose, free=False, can_incline=True, chosen=None, before=None, model=()):
        self.assess, self.choose, self.free = assess, choose, free
        self.can_incline, self.chosen, self.model = can_incline, chosen, model
        self.before = dict(before or {}) if chosen and free else {}
        self.walls = False  # whether a tool would have run into the part

    @stoppable
    def find(self, given, progress=None):
        """The Remedies that were tried and help, the best first; None if `progress` (fraction -> bool)
        returned False."""
        normals, areas = orientation.face_normals(given)
        if not len(normals):
            return []
        now, reached = self._assessed(given), orientation.reached_fraction(normals, areas)
        found = self._found(given, (normals, areas, reached), now, progress)
        if found is None or any(remedy.assessment.good for remedy in found):
            return found and self._in_order(given, found)
        for fields in room.smaller_balls(given, self.walls) if self.free else ():
            asked = replace(given, **fields)
            more = self._found(asked, (normals, areas, reached), now, progress, another_ball=True)
            if more is None:
                return None
            found += [replace(remedy, fields={**fields, **remedy.fields}) for remedy in more]
            if any(remedy.assessment.good for remedy in more):
                break
        return self._in_order(given, found)

    def _found(self, given, faces, now, progress, another_ball=False):
        """Remedies for a TextureInput that help beside the Assessment `now`; None if `progress` returned
        False. `faces`: normals, areas, and what one setup reaches; `another_ball`: the user's has another."""
        normals, areas, reached = faces
        first, last = self._tries(given, normals, areas, WORTH_TRYING * reached)
        if reached < GOOD_FRACTION:
            first.insert(0, lambda: self._by_sides(given))
        if another_ball:
            first.insert(0, lambda: self._chosen_for(given, "ball", {}))
        elif now is not None and now.touches:
            first.insert(0, lambda: self._beside_walls(given, Remedy("values", {}, now)))
        found: list[Remedy] = []
        slow = self._slow_strategies(given)
        for number, attempt in enumerate(first + last):
            if not progress(number / len(first + last)):
                return None
            enough = ENOUGH if number < len(first) else 1
            good = (one for one in found if is_enough(one.assessment, reached))
            if sum(one.fields.get("strategy", given.strategy) not in slow for one in good) >= enough:
                break
            try:
                remedy = attempt()
            except InputError:
                continue
            if remedy is not None and is_better(remedy.assessment, now):
                found.append(remedy)
        return found

    def _in_order(self, given, found):
        """Remedies, the best first."""
        slow = self._slow_strategies(given)
        most = max((remedy.assessment.good_fraction for remedy in found), default=0.0)

        def rank(remedy):
            made = remedy.assessment
            leaves_good = made.remains_good and made.good_fraction >= MOST * most
            is_slow = remedy.fields.get("strategy", given.strategy) in slow
            return not made.good, is_slow, not leaves_good, -round(made.good_fraction, 2)

        return sorted(found, key=rank)

    @staticmethod
    def _slow_strategies(given):
        """Strategies that end no search: polygons, on a machine that can lock its path to the spindle. Each
        dimple takes many times as long there, and another inclination may let the path lock."""
        lock = bool(given.machine) and machines.load(given.machine).model.spindle_lock
        return POLYGONS if lock else ()

    def _tries(self, given, normals, areas, worth):
        """Two lists of functions that make a Remedy or None: those that keep the dimples as they were asked
        for, and those that are tried while none is good and fast, if by their normals more than `worth` of
        the faces lies well."""
        machine = machines.load(given.machine) if given.machine else None
        leanings = orientation.leanings(normals, areas)
        best, other = leanings[0], orientation.apart(leanings)
        whole = given
        if self.chosen and "margin" in self.chosen:
            given = replace(given, margin=0.0)  # each has one of its own
        given = replace(given, **self.before)
        first = [] if self.chosen else [lambda: self._chosen_for(given, "values", {})]
        last = []
        if machine is not None and machine.rotary_letters:
            first.append(lambda: self._lean(given, best, normals, areas))
            first.append(lambda: self._along(given, normals, areas))
        if self.can_incline:
            first.append(lambda: self._incline(given, best))
        first.append(lambda: self._left_out(whole))
        last.extend(self._laid_tries(given, normals, areas, machine, worth))
        for part in FINER if given.spacing and given.texture_kind == "Overlapping" else ():
            flattest = part * orientation.BEST_TILTS[0]
            if orientation.good_fraction(normals, areas, UPRIGHT, flattest) > worth:
                last.append(partial(self._finer, given, part))
            lean = orientation.leanings(normals, areas, flattest=flattest)[0]
            if self.can_incline and lean[0] > max(worth, best[0] + MIN_GAIN):
                last.append(partial(self._incline, given, lean, part))
            elif self.can_incline and best[0] > worth and room.too_narrow(given):
                last.append(partial(self._incline, given, best, part))
        if self.can_incline:
            worth = min(worth, WORTH_TRYING * best[0])
            last.extend(partial(self._incline, given, one) for one in other if one[0] > worth)
        return first, last

    def _laid_tries(self, given, normals, areas, machine, worth):
        """Functions that make a Remedy or None: the lattice laid on the faces, where it is not stretched
        however steep they are; as the part lies, and leant so that few faces are flat or look away."""
        if given.mapping != "Projected":
            return
        upright = orientation.good_fraction(normals, areas, UPRIGHT, laid=True)
        leaning = orientation.leanings(normals, areas, laid=True)[0]
        if upright > worth:
            yield partial(self._lay, given)
        if leaning[0] > upright + MIN_GAIN and self.can_incline:
            yield partial(self._incline, given, leaning, laid=True)
        elif leaning[0] > upright + MIN_GAIN and machine is not None and machine.rotary_letters:
            laid = replace(given, **LAID)
            yield partial(self._lean, laid, leaning, normals, areas, LAID)

    def _assessed(self, given):
        """Assessment of the texture as it is; None where it cannot be made."""
        try:
            plan = plan_texture(given, slower=False)
            return room.held_against(self.assess(given, 3, whole=True), plan, self.model)
        except InputError:
            return None

    def _chosen_for(self, given, kind, fields, axis=None, angle=0.0):
        """The Remedy with values that suit `given`, whose `fields` are new; what is too flat or too steep
        left out besides, where that makes more of it good, or all that remains; None where the tool would run
        into the part."""
        choice = self.choose(given, self.free)
        if choice is None:
            return None
        found, fields = choice.assessment, {**self.before, **fields, **choice.fields}
        given = replace(given, **choice.fields)
        if not found.remains_good:
            try:
                rest = self.leave_out(given)
            except InputError:
                rest = None
            if rest is not None and (
                rest.assessment.good_fraction > found.good_fraction or leaves_good(rest.assessment, found)
            ):
                fields.update(rest.fields)
                found, given = rest.assessment, replace(given, **rest.fields)
        return self._beside_walls(given, Remedy(kind, fields, found, axis, angle))

    def _beside_walls(self, given, remedy):
        """The Remedy, of which `given` comes, with a margin that keeps the tool off the part's walls where
        that is needed, the first that leaves what is good; what it leaves out is not. None if none does."""
        incline = remedy.kind == "incline"
        model = orientation.turned_texts(self.model, remedy.axis, remedy.angle) if incline else self.model
        if not room.touches(given, model):
            return remedy
        self.walls = True
        first = None
        for beside in room.beside_walls(given):
            asked = replace(given, **beside)
            try:
                if room.touches(asked, model):
                    continue
                made = self.assess(asked, 3, whole=True)
            except InputError:
                continue  # nothing is left within so wide a margin: what a narrower one gave remains
            part = made.dimples / max(1, remedy.assessment.dimples)
            made.milled_fraction = min(made.milled_fraction, part * remedy.assessment.milled_fraction)
            walled = replace(remedy, fields={**remedy.fields, **beside}, assessment=made, walled=True)
            if made.remains_good:
                return walled
            first = first or walled
        return first

    def _incline(self, given, leaning, finer=None, laid=False):
        _, angle, axis = leaning
        fields = {} if finer is None else {"spacing": round(finer * given.spacing, 3)}
        fields.update(LAID if laid else {})
        asked = orientation.turned(replace(given, **fields), axis, angle, self.model)
        return self._chosen_for(asked, "incline", fields, axis, angle)

    def _lean(self, given, leaning, normals, areas, others=None):
        """The tool leant as the part would be, the other way round; `others`: fields that `given` has new."""
        _, angle, axis = leaning
        fields = {"tool_axis_mode": "Fixed", "fixed_axis": orientation.up_of(axis, angle), **(others or {})}
        fields.update(orientation.seen_from(normals, areas))
        return self._chosen_for(replace(given, **fields), "lean", fields, axis, angle)

    def _along(self, given, normals, areas):
        """The tool follows the normals, at an angle to them."""
        seen = orientation.seen_from(normals, areas)
        fields = {"tool_axis_mode": "Normal", "lead": LEAD, "tilt": 0.0, **seen}
        return self._chosen_for(replace(given, **fields), "along", fields, angle=LEAD)

    def _by_sides(self, given):
        """The Remedy by which several textures share the faces and make them good; None if none does."""
        own = {"margin": 0.0} if self.chosen and "margin" in self.chosen else {}
        asked = replace(given, **own, **self.before)
        functions = self.assess, self.choose, room.touches, first_ways
        made, together = sides.find(functions, asked, self.free, self.can_incline, self.model)
        if not made:
            return None
        first, fields = made[0], {**self.before, **made[0].fields}
        return Remedy("sides", fields, together, first.axis, first.angle, made[1:])

    def _lay(self, given):
        return self._chosen_for(replace(given, **LAID), "lay", dict(LAID))

    def _finer(self, given, part):
        fields = {"spacing": round(part * given.spacing, 3)}  # smaller dimples need less tilt
        return self._chosen_for(replace(given, **fields), "finer", fields)

    def _left_out(self, given):
        rest = self.leave_out(given)
        return rest and self._beside_walls(replace(given, **rest.fields), rest)

    def leave_out(self, given):
        """Remedy that leaves out what is flatter, and under an upright tool what is steeper, than the largest
        part whose patches are all good; None where there is none, or nothing else."""
        patches = self.assess(given, 5).patches
        upright = tool_posture.is_vertical(given) and not given.auto_direction  # then slopes are tilts
        run = largest_good_run(patches, ends_anywhere=upright)
        if run is None or run == (0, len(patches)):
            return None
        first, end = run
        fields = {}
        if first > 0:
            fields["minimum_tilt"] = round(0.5 * (patches[first - 1].tilt + patches[first].tilt), 1)
        if end < len(patches):
            fields["steepest_slope"] = round(0.5 * (patches[end - 1].tilt + patches[end].tilt), 1)
        asked = replace(given, **fields)
        plan_texture(asked, slower=False)
        return Remedy("leave out", fields, self.assess(asked, 3, whole=True))
