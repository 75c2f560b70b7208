"""The relief of the flattest place is seen while the worst one is still looked for, in the panel and after
OK; once the worst is known, it is not replaced any more.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import threading

import driver
from patchmill_gui.panels import texture_advising, texture_view


class FirstRelief(driver.BlockTest):
    def hold(self, module, name):
        """Lets a function of a module wait; the event that lets it go on."""
        function, free = getattr(module, name), threading.Event()

        def late(*arguments):
            free.wait(200)
            return function(*arguments)

        setattr(module, name, late)
        self.addCleanup(setattr, module, name, function)
        self.addCleanup(free.set)
        return free

    def shown(self, panel):
        """Signals of reliefs from now on."""
        found = []
        panel.advising.relief.connect(found.append)
        return found

    def test_it_is_there_before_the_whole_is_known(self):
        free = self.hold(texture_advising, "assess_and_draw")
        _, panel = driver.begin_texture(self.part)
        self.assertTrue(driver.wait(lambda: panel.scene.filled("relief") and panel.scene.complete, 120))
        self.assertTrue(driver.wait(lambda: panel.advising.assessing.busy, 120))
        self.assertEqual(panel.advising.drawn, (None, {}))
        found = self.shown(panel)
        driver.set_quantity(panel, "Spacing", 0.6)  # and so after each value
        self.assertTrue(driver.wait(lambda: found, 120))
        self.assertTrue(panel.scene.filled("relief"))
        free.set()
        self.assertTrue(driver.wait(lambda: panel.advising.drawn[1], 200))
        self.assertIs(found[-1], panel.advising.drawn[1])
        panel.reject()

    def test_it_does_not_replace_the_worst(self):
        free = self.hold(texture_advising, "first_relief")
        _, panel = driver.begin_texture(self.part)
        found = self.shown(panel)
        self.assertTrue(driver.wait(lambda: panel.advising.drawn[1], 200))
        free.set()
        driver.rest(3.0)
        self.assertEqual(found, [panel.advising.drawn[1]])
        panel.reject()

    def test_it_is_there_after_ok_too(self):
        panels = self.hold(texture_advising, "assess_and_draw")
        free = self.hold(texture_view, "relief_displays")
        operation, panel = driver.begin_texture(self.part)
        driver.accept(panel)
        panels.set()
        view = operation.ViewObject.Proxy
        self.assertTrue(driver.wait(lambda: view.scene.filled("relief") and view.scene.complete, 120))
        self.assertEqual(view.known_relief, (None, {}))
        free.set()
        self.assertTrue(driver.wait(lambda: view.known_relief[1], 200))
        self.assertTrue(view.scene.filled("relief"))


def main():
    return driver.run_tests(FirstRelief)
