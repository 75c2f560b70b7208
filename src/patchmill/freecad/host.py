"""The only file that knows one FreeCAD version from another.

0.20 keeps its CAM module in Mod/Path as PathScripts.*; from 0.21 on it is Path.*. Everything else in
PatchMill takes what differs from here.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import contextlib
import os
import tempfile
import typing

import FreeCAD
import Path

VERSION = tuple(int(v) for v in FreeCAD.Version()[:2])

from patchmill.freecad import hooks  # noqa: E402
from patchmill.geometry import shapes  # noqa: E402
import PathScripts.PathUtils as PathUtils  # noqa: E402  the same name in all versions

if VERSION >= (0, 21):
    import Path.Main.Job as PathJob
    import Path.Op.Base as PathOp
    import Path.Preferences as PathPreferences
    import Path.Tool.Controller as PathToolController
    import Path.Base.SetupSheet as SetupSheet
    import Path.Base.Util as PathUtil
else:
    import PathScripts.PathJob as PathJob
    import PathScripts.PathOp as PathOp
    import PathScripts.PathPreferences as PathPreferences
    import PathScripts.PathToolController as PathToolController
    import PathScripts.PathSetupSheet as SetupSheet
    import PathScripts.PathUtil as PathUtil

register_operation = SetupSheet.RegisterOperation

# FreeCAD's own GUI modules and commands, by what they are for; only the GUI imports them.
if VERSION >= (0, 21):
    GUI_MODULES = {
        "startup": "Path.GuiInit",
        "operation": "Path.Op.Gui.Base",
        "selection": "Path.Op.Gui.Selection",
        "widgets": "Path.Base.Gui.Util",
        "job": "Path.Main.Gui.Job",
    }
    NATIVE_COMMANDS = {"job": "CAM_Job", "post": "CAM_Post"}
    NATIVE_WORKBENCH = "CAMWorkbench"
else:
    GUI_MODULES = {
        "startup": "PathScripts.PathGuiInit",
        "operation": "PathScripts.PathOpGui",
        "selection": "PathScripts.PathSelection",
        "widgets": "PathScripts.PathGui",
        "job": "PathScripts.PathJobGui",
    }
    NATIVE_COMMANDS = {"job": "Path_Job", "post": "Path_Post"}
    NATIVE_WORKBENCH = "PathWorkbench"

__all__ = [
    "GUI_MODULES",
    "NATIVE_COMMANDS",
    "NATIVE_WORKBENCH",
    "VERSION",
    "Path",
    "PathOp",
    "PathUtils",
    "SetupSheet",
    "register_operation",
]


@contextlib.contextmanager
def active_document(document=None):
    """`document` as the active one, for FreeCAD's functions that make objects there or look for jobs by name;
    None: the one that is active."""
    before = FreeCAD.ActiveDocument
    document = document or before
    if document is not before:
        FreeCAD.setActiveDocument(document.Name)
    try:
        yield document
    finally:
        if document is not before and before is not None:
            FreeCAD.setActiveDocument(before.Name)


def _list_own_posts():
    """FreeCAD lists and loads the posts of certain folders: PatchMill's, beside this package, becomes one of
    them; in a clone, the folder `posts` there. Before 26.3 nothing is made for adding one."""
    folder = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
    folders = [f for f in (folder, os.path.join(folder, "posts")) if os.path.isdir(f)]
    if hasattr(PathPreferences, "addAddonPostPath"):
        for each in folders:
            PathPreferences.addAddonPostPath(each)
    else:
        others = PathPreferences.searchPathsPost
        PathPreferences.searchPathsPost = lambda: others() + folders


_list_own_posts()


def create_job(name, models):
    """A Job over `models` (document objects) as the GUI would make it, with one tool controller."""
    with active_document(models[0].Document if models else None):
        return hooks.announce(PathJob.Create(name, models))


def is_active(obj):
    """Whether an operation, and all that it is a dressup on, is switched on."""
    return getattr(obj, "Active", True) and (not hasattr(obj, "Base") or is_active(obj.Base))


def coolant_of(obj):
    """The coolant of an operation, or of the one under dressups: Flood, Mist or None."""
    return PathUtil.opProperty(obj, "CoolantMode") or "None"


def tool_controllers(job):
    """The tool controllers of a job, a list of document objects."""
    return list(job.Tools.Group)


def make_ball_end_mill(diameter_mm, flutes, label="Ball end mill"):
    """A ball end mill tool bit in the active document, to be assigned to a tool controller's Tool."""
    shank = max(3.0, diameter_mm)
    parameters = {
        "CuttingEdgeHeight": "%g mm" % (10.0 * diameter_mm),
        "Diameter": "%g mm" % diameter_mm,
        "Length": "%g mm" % (20.0 * diameter_mm + 10.0),
        "ShankDiameter": "%g mm" % shank,
    }
    attributes = {
        "version": 2,
        "name": label,
        "shape": "ballend.fcstd",
        "parameter": parameters,
        "attribute": {"Flutes": str(flutes)},
    }
    if VERSION >= (1, 1):
        from Path.Tool.toolbit import ToolBit

        bit = ToolBit.from_dict(attributes).attach_to_doc(doc=FreeCAD.ActiveDocument)
    else:
        if VERSION >= (0, 21):
            import Path.Tool.Bit as PathToolBit
        else:
            import PathScripts.PathToolBit as PathToolBit
        bit = PathToolBit.Factory.CreateFromAttrs(attributes, "ToolBit")
    bit.Flutes = flutes
    if bit.ViewObject:
        bit.ViewObject.Visibility = False  # it would stand at the origin, in the part
    return bit


def tool_kind(bit):
    """Kind of cutter in lower case ('ballend', 'endmill', ...), also by its shape; '' if nothing says."""
    kind = getattr(bit, "ShapeName", "") or getattr(bit, "ShapeType", "")
    if not kind:
        kind = os.path.splitext(os.path.basename(getattr(bit, "BitShape", "")))[0]
    return shapes.kind_of_bit(kind.lower(), bit)


def preferred_post():
    """The post-processor set as FreeCAD's default, else '': the first of the list is nobody's choice."""
    return PathPreferences.defaultPostProcessor()


def takes_ball_end(obj, tool):
    """Whether an operation for ball end mills supports a tool bit: one of those, if its job has any. A new
    operation, which has no controller yet, takes the first that fits: FreeCAD would ask with a dialog, and
    fail where there is no GUI."""
    tools = [c.Tool for c in tool_controllers(PathUtils.findParentJob(obj))]
    fitting = [t for t in tools if tool_kind(t) == "ballend"] or tools
    return tool in (fitting if obj.ToolController else fitting[:1])


def append_controller(job):
    """A further tool controller of the job, with the next free tool number."""
    number = 1 + max((c.ToolNumber for c in tool_controllers(job)), default=0)
    controller = PathToolController.Create("TC: Ball end mill", toolNumber=number)
    job.Proxy.addToolController(controller)
    return controller


def base_of(job, model):
    """The document object that a job's model object stands for."""
    return job.Proxy.baseObject(job, model)


def jobs():
    """All jobs of the active document."""
    return list(PathUtils.GetJobs())


def add_ball_end_controller(
    job, diameter_mm, flutes, feed_mm_min, speed_rpm, direction="Forward", controller=None
):
    """Gives a tool controller, the job's first if None, a ball end mill; returns the controller."""
    controller = controller or tool_controllers(job)[0]
    replaced = controller.Tool
    with active_document(job.Document):
        controller.Tool = make_ball_end_mill(diameter_mm, flutes)
    if replaced and not replaced.InList:
        replaced.Proxy.onDelete(replaced)  # takes the body with it that shows the bit's shape
    controller.Label = "Ball end mill %g mm" % diameter_mm
    controller.HorizFeed = feed_mm_min / 60.0
    controller.VertFeed = feed_mm_min / 60.0
    for name in ("HorizRapid", "VertRapid"):
        controller.setExpression(name, None)  # of the setup sheet, whose rapids are 0 until they are told
        setattr(controller, name, 100.0)
    controller.SpindleSpeed = speed_rpm
    controller.SpindleDir = direction
    if hasattr(controller.Tool, "SpindleDirection"):
        controller.Tool.SpindleDirection = direction
    return controller


def posted_direction(controller):
    """The direction that FreeCAD posts for a tool controller: its own; from 1.1 on its tool bit's."""
    if VERSION >= (1, 1):
        return getattr(controller.Tool, "SpindleDirection", controller.SpindleDir)
    return controller.SpindleDir


def begin_upright(commands):
    """`commands` with a rapid straight to the height of their first rapid before it. FreeCAD 0.20 posts one
    with the work offset; later ones leave it to the operation, and the tool would come from the side."""
    for number, command in enumerate(commands):
        if command.Name == "G0" and "Z" in command.Parameters:
            first = Path.Command("G0", {"Z": command.Parameters["Z"]})
            return commands[:number] + [first] + commands[number:]
    return commands


def _post_0_20(job, post_name, arguments):
    import PathScripts.PathPost as PathPost
    from PathScripts.PathPostProcessor import PostProcessor

    parts: list = []
    with tempfile.TemporaryDirectory() as folder:
        for objects in PathPost.CommandPathPost().buildPostList(job):
            # several posts return nothing: what counts is the file
            name = os.path.join(folder, "part%d.ngc" % len(parts))
            PostProcessor.load(post_name).export(objects, name, arguments)
            with open(name, encoding="utf-8") as file:
                parts.append(file.read())
    return parts


def without_last_rapid(path):
    """`path` without the rapid to the clearance height that FreeCAD adds to every operation: with the work
    turned and TCP off, Z is not the height above it."""
    last = path.Commands[-1] if path.Size else None
    if last is not None and last.Name == "G0" and list(last.Parameters) == ["Z"]:
        path.deleteCommand()
    return path


def post_processor_class() -> typing.Any:
    """The base class of post-processors, from FreeCAD 1.0 on; None on older ones, which know functions."""
    try:
        from Path.Post.Processor import PostProcessor
    except ImportError:
        return None
    return PostProcessor


def post_objects(job, post_name):
    """What FreeCAD hands to the post-processor: a list for each file, without what is switched off, which
    FreeCAD 1.x leaves to the post. Work offsets are without a Proxy."""
    if VERSION < (0, 21):
        import PathScripts.PathPost as PathPost

        return PathPost.CommandPathPost().buildPostList(job)
    from Path.Post.Processor import PostProcessorFactory

    files = files_of_post(PostProcessorFactory.get_post_processor(job, post_name))
    return [[obj for obj in objects if is_active(obj)] for _, objects in files]


def files_of_post(post):
    """(name, document objects) for each file of a post-processor of FreeCAD 1.0 or later; 26.3 wraps them."""
    return [(name, [getattr(o, "source", None) or o for o in some]) for name, some in post._buildPostList()]


def post_parts(job, post_name, arguments):
    """What FreeCAD's post-processor `post_name` makes of the job: a list of texts, one per file."""
    if VERSION < (0, 21):
        return _post_0_20(job, post_name, arguments)
    from Path.Post.Processor import PostProcessorFactory

    job.PostProcessorArgs = arguments
    post = PostProcessorFactory.get_post_processor(job, post_name)
    # from 26.3 on a job may name a machine of FreeCAD's own: its posts then are asked in another way
    export = post.export2 if getattr(job, "Machine", "") else post.export
    return [text or "" for _, text in export()]  # some posts return None
