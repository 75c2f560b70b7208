"""What the panel of a texture does beside its preview: it chooses values for a new texture, says how good the
texture will be, and offers what helps, all in the background.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from dataclasses import replace
from functools import partial

from _patchmill import InputError
from patchmill.advice import apply, assessment, choice, companions, remedies, room, sides
from patchmill.geometry.shapes import BrepTexts
from patchmill.textures import strategies
from patchmill.textures.ball.laying import is_ball
from patchmill.textures.order.rows import THREAD
from PySide import QtCore

from patchmill_gui.fields import unit_text
from patchmill_gui.fields.known_sentences import translated_error
from patchmill_gui.forms.widgets import one_shot, translate
from patchmill_gui.panels.texture_head import Head
from patchmill_gui.views.worst_relief import assess_and_draw, first_relief, once
from patchmill_gui.work.background import Background

LOOK_AFTER_MS = 40  # the dimples are to be painted first

assess = assessment.with_simulation(once)
choose = partial(choice.choose, assess)


def _assess_and_draw(planned, others, model, progress):
    """(Assessment of a PlannedTexture, displays of the relief of the worst place) or None if cancelled.
    `others`: TextureInputs that share the faces; `model`: apply.model_of."""
    made = assess_and_draw(planned.asked, progress)
    if made is None:
        return None
    found, displays = room.held_against(made[0], planned, model), made[1]
    return sides.with_others(assess, found, planned.asked, others), displays


def _find_help(finder, given, progress):
    """(Remedies, (least radius of the faces' hollows, that of the ball) [mm] if it does not fit or None,
    room.too_narrow where nothing helps at this spacing or None, whether walls are in the way,
    room.short_reach where no remedy is good), or None if cancelled."""
    found = finder.find(given, progress)
    if found is None:
        return None
    radius = room.ball_too_large(given)
    helped = any(remedy.assessment.good and "spacing" not in remedy.fields for remedy in found)
    strip = None if helped else room.too_narrow(given)
    reach = []
    if (radius or finder.walls) and not any(remedy.assessment.good for remedy in found):
        reach = room.short_reach(given, finder.walls, finder.model)
    return found, radius and (radius, given.tool.radius), strip, finder.walls, reach


class Advising(QtCore.QObject):
    """`chosen` when a new texture has its values, or will have none; `relief` with the displays of the
    flattest place, soon, and of the worst that was looked at, when all were."""

    chosen, relief = QtCore.Signal(), QtCore.Signal(object)
    drawn: tuple = (None, {})  # displays of that relief, after the TextureInput that it is of

    def __init__(self, obj, show_properties):
        super().__init__()
        self.obj, self.show_properties = obj, show_properties
        self.head = Head()
        self.head.taken.connect(self._take)
        self.choosing, self.looking, self.assessing, self.helping = (
            Background(brief=True) for _ in range(4)
        )
        self.choosing.finished.connect(self._chosen)
        # a method: PySide would hold a function, and by it this object, for good
        self.choosing.failed.connect(self._not_chosen)
        self.look_timer = one_shot(self._look)
        self.looking.finished.connect(self.relief)
        self.looking.failed.connect(self._failed)
        self.assessing.finished.connect(self._assessed)
        self.assessing.failed.connect(self._failed)
        self.helping.finished.connect(self._helped)
        self.notes = list(getattr(obj.Proxy, "notes", ()))
        self._placed = self._planned = self._before = self._choice = self._chosen_for = None
        self.following = False  # the values of a new texture follow the others until the user edits them
        self.applying = False  # its own values are being shown: no edit of the user's
        self._model_texts = BrepTexts()
        self._controller, self._cutting = None, {}  # feed and spindle of a controller before a choice

    def follow(self):
        """From now on the values are chosen for what the others are."""
        self.following = True

    def own_values(self):
        """Those that are chosen, as they are."""
        obj = self.obj
        return obj.Strategy, obj.SameFlute, obj.ExtraTurns, obj.Order, obj.RowDirection, obj.Margin.Value

    def choose(self):
        """Begins to look for the values that suit, unless they are those of the last choice, or the user's.
        Returns whether it does; `chosen` comes at the end."""
        if not self.following:
            return False
        try:
            given = replace(self.obj.Proxy.texture_input(self.obj), margin=0.0, **self._as_before())
        except InputError:
            return False  # planning says it
        if given.form == "Free" or given.order == THREAD or is_ball(given):
            return False
        self._cutting = {"feed": given.feed, "spindle": given.spindle}
        key = replace(given, strategy="", same_flute=False, extra_turns=0.0, order="", row_direction="")
        if key == self._chosen_for:
            return False
        self._chosen_for = key
        self.head.busy(translate("PatchMill", "Looking for good values …"))
        free = apply.controller_is_free(self.obj)
        self.choosing.start(lambda progress: choose(given, free, progress))
        return True

    def _as_before(self):
        """Feed and spindle of the tool controller before a choice changed them; none of another
        controller."""
        if self._controller is not self.obj.ToolController:
            self._controller, self._cutting = self.obj.ToolController, {}
        return self._cutting

    def _chosen(self, found):
        self._choice = found = found if self.following else None  # the user's own came meanwhile
        if found is not None:
            apply.set_fields(self.obj, {**self._cutting, **found.fields})
            self.applying = True
            self.show_properties()
            self.applying = False
        self.chosen.emit()

    def _not_chosen(self, _):
        self._chosen(None)

    def outdate(self):
        """What the head says is no longer so."""
        self._stop_looking()
        for work in (self.assessing, self.helping):
            work.cancel()
        if not self.choosing.busy:
            self.head.busy(translate("PatchMill", "Computing …"))

    def look(self, placed):
        """Draws the relief of the flattest place of a PlacedTexture, soon."""
        self._placed = placed
        self.look_timer.start(LOOK_AFTER_MS)

    def _look(self):
        placed = self._placed
        self.looking.start(lambda progress: first_relief(placed.asked, progress, placed))

    def _stop_looking(self):
        self.look_timer.stop()
        self.looking.cancel()

    def assess(self, planned):
        """Begins to find out how good a PlannedTexture is."""
        self._planned = planned
        others, model = self._others(), apply.model_of(self.obj, self._model_texts)
        self.helping.cancel()
        self.assessing.start(lambda progress: _assess_and_draw(planned, others, model, progress))

    def _others(self):
        """TextureInputs of those that share the faces."""
        try:
            return companions.inputs(self.obj)
        except InputError:  # their own panels say it
            return []

    def _assessed(self, made):
        found, displays = made or (None, {})
        if found is None or self._planned is None:
            return
        self._stop_looking()  # the worst place is known
        self.drawn = (self._planned.asked, displays)
        self.relief.emit(displays)
        seconds = self._planned.seconds
        self.head.show_found(found, seconds, self._planned.pacing.verdict, self.notes)
        if not found.good:
            self._look_for_help()

    def _failed(self, error):
        self.head.show_error(translated_error(error))

    def explain(self, error):
        """Shows why there is no texture, and looks for what helps."""
        self.assessing.cancel()
        self.head.show_error(translated_error(error))
        self._look_for_help()

    def _look_for_help(self):
        try:
            given = self.obj.Proxy.texture_input(self.obj)
        except InputError:
            return
        if given.form == "Free" or given.order == THREAD:
            return
        free, can_incline = apply.controller_is_free(self.obj), apply.can_incline(self.obj)
        chosen = self._choice.fields if self._choice is not None else {}
        if any(getattr(given, name) != value for name, value in chosen.items()):
            chosen = None
        self.head.note(translate("PatchMill", "Looking for what helps …"))
        before, model = self._as_before(), apply.model_of(self.obj, self._model_texts)
        finder = remedies.Finder(assess, choose, free, can_incline, chosen or None, before, model)
        self.helping.start(lambda progress: _find_help(finder, given, progress))

    def _helped(self, made):
        found, radii, strip, walls, reach = made or (None, None, None, False, [])
        said = [] if found else [translate("PatchMill", "Nothing that was tried makes it better.")]
        if radii is not None:
            bends = translate(
                "PatchMill", "The faces bend in to a radius of {}; the ball of {} does not fit there."
            )
            said.append(bends.format(*(unit_text.text_of(radius, "mm") for radius in radii)))
        elif strip is not None:
            wide = translate(
                "PatchMill", "The faces are about {} wide: {:.0f} dimples side by side are too few."
            )
            said.append(wide.format(unit_text.text_of(strip[0], "mm"), strip[1]))
        elif walls:
            said.append(translate("PatchMill", "Walls of the part beside the faces are in the tool's way."))
        for across, part in reach:
            tool = translate("PatchMill", "A ball of diameter {} reaches {:.0f} % of the faces.")
            said.append(tool.format(unit_text.text_of(across, "mm"), 100.0 * part))
        self.head.note(" ".join(said))
        self.head.offer(found or [])

    def _take(self, remedy):
        self.following = False
        apply.take(self.obj, remedy)
        self.show_properties()

    def follow_strategy(self, before):
        """After an edit of Strategy: on a paced path every flute mills and nothing is added between dimples.
        Sets that, and takes it back when the strategy is changed back; returns whether anything was set."""
        obj = self.obj
        if obj.Strategy == before:
            return False
        self.notes = []
        polygons, before_polygons = (strategies.of(name).polygons for name in (obj.Strategy, before))
        if before_polygons and not polygons:
            self._before = (obj.SameFlute, obj.ExtraTurns)
            if not obj.SameFlute and obj.ExtraTurns == 0.0:
                return False
            obj.SameFlute, obj.ExtraTurns = False, 0.0
            self.notes = [translate("PatchMill", "Set for this strategy: any flute, no extra turns.")]
            return True
        if polygons and not before_polygons:
            same, turns = self._before or (obj.ToolController.Tool.Flutes < 2, 1.0)
            obj.SameFlute, obj.ExtraTurns = same, turns or 1.0
            return True
        return False

    def stop(self):
        self._stop_looking()
        for work in (self.choosing, self.assessing, self.helping):
            work.cancel()
        self.head.unpin()
