"""What FreeCAD 26.3 changes where PatchMill meets it, after its source of 2026: add-ons register their posts,
a post's objects come wrapped, and a job that names a machine is posted in another way. Stand-ins are as that
source is; it has not run here.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import pathlib
import sys
import types
import unittest
from unittest import mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

from parts import WithDocuments  # noqa: E402
from patchmill import posting  # noqa: E402
from patchmill.freecad import host  # noqa: E402
from roof_job import ARGUMENTS, roof_job  # noqa: E402

POST = "patchmill_linuxcnc"


class Postable:
    """As FreeCAD 26.3 wraps what it posts (Path/Post/PostList.py): a copy of its path, all else as it is."""

    def __init__(self, source, kind="operation"):
        self.item_type, self.source = kind, source if hasattr(source, "Proxy") else None
        self.Label, self.Path = source.Label, host.Path.Path(source.Path.Commands)

    def __getattr__(self, name):
        source = self.__dict__.get("source")
        if source is None:
            raise AttributeError(name)
        return getattr(source, name)


class PostProcessor:
    """The base class of posts. `export2` is its own way to a program, which knows nothing of words like K."""

    def __init__(self, job, tooltip, tooltipargs, units):
        self._job, self.wrapped = job, []

    def _buildPostList(self):
        return [("allitems", self.wrapped)]

    def export2(self):
        return [("allitems", "by FreeCAD")]


class Posts(WithDocuments):
    def setUp(self):
        self.job, self.textures = roof_job("Spindle-locked", "Constant feed")
        (self.objects,) = host.post_objects(self.job, POST)
        with mock.patch.object(host, "post_processor_class", return_value=PostProcessor):
            self.post = posting.own_dialect(POST).processor()(self.job)
        self.post.wrapped = [Postable(obj) for obj in self.objects]

    def test_objects_are_those_of_the_document(self):
        ((name, objects),) = host.files_of_post(self.post)
        self.assertEqual(name, "allitems")
        self.assertEqual([o for o in objects if hasattr(o, "Proxy")],
                         [o for o in self.objects if hasattr(o, "Proxy")])
        self.assertEqual([o.Label for o in objects], [o.Label for o in self.objects])

    def test_own_posts_write_the_same_either_way(self):
        self.job.PostProcessorArgs = ARGUMENTS
        wanted = posting.own_dialect(POST).compared(self.objects, ARGUMENTS)
        self.assertIn("G33", wanted)
        for way in (self.post.export, self.post.export2):
            self.assertEqual(way(), [("allitems", wanted)])

    def test_a_job_with_a_machine_is_posted_in_freecads_new_way(self):
        new = [("a", "new"), ("b", None)]
        made = types.SimpleNamespace(export=lambda: [("a", "old")], export2=lambda: new)
        module = types.ModuleType("Path.Post.Processor")
        module.PostProcessorFactory = types.SimpleNamespace(get_post_processor=lambda job, name: made)
        job = types.SimpleNamespace(PostProcessorArgs="")
        later = mock.patch.object(host, "VERSION", (26, 3))
        with later, mock.patch.dict(sys.modules, {module.__name__: module}):
            self.assertEqual(host.post_parts(job, "linuxcnc", ARGUMENTS), ["old"])
            self.assertEqual(job.PostProcessorArgs, ARGUMENTS)
            job.Machine = ""
            self.assertEqual(host.post_parts(job, "linuxcnc", ARGUMENTS), ["old"])
            job.Machine = "Generic LinuxCNC"
            self.assertEqual(host.post_parts(job, "linuxcnc", ARGUMENTS), ["new", ""])


class Places(unittest.TestCase):
    def places(self, **more):
        preferences = types.SimpleNamespace(searchPathsPost=lambda: ["FreeCAD's"], **more)
        with mock.patch.object(host, "PathPreferences", preferences):
            host._list_own_posts()
        return preferences.searchPathsPost()

    def test_posts_are_registered_where_freecad_has_a_way_for_it(self):
        told = []
        self.assertEqual(self.places(addAddonPostPath=told.append), ["FreeCAD's"])
        first, *others = self.places()
        self.assertEqual((first, others), ("FreeCAD's", told))
        self.assertTrue(any(pathlib.Path(folder, POST + "_post.py").is_file() for folder in told), told)


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
