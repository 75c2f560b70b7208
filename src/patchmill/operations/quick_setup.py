"""From selected faces to a job that can mill them: what one click makes where it is missing.

Job, stock and tool are FreeCAD's own. Nothing that exists is changed: a job that has the part is used as
it is, and a ball end mill is added to it only if it has none.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from _patchmill import InputError

from patchmill.freecad import host, kinds, preferences

# Of the ball's diameter: light cuts, and then ridges of one per cent of it on a flat
DEPTHS = {"RadialDepth": 0.5, "AxialDepth": 0.5, "FinishingRadialDepth": 0.2}


def job_for(part):
    """(job, model): a job over the document object `part` and the object of its model that stands for it.
    `part` may itself be of a job's model. Makes a job with FreeCAD's default stock if there is none."""
    for job in host.jobs():
        for model in job.Model.Group:
            if part is model or host.base_of(job, model) is part:
                return job, model
    if not getattr(part, "Shape", None) or not part.Shape.Faces:
        raise InputError("Selection", part.Label, "select a face of a solid or surface.")
    job = host.create_job("Job", [part])
    if not host.preferred_post():
        job.PostProcessor = preferences.post()
        job.PostProcessorArgs = "--no-header --no-show-editor"
    return job, job.Model.Group[0]


def ball_end_controller(job):
    """The job's first tool controller with a ball end mill; one made from the preferences if none."""
    controllers = host.tool_controllers(job)
    for controller in controllers:
        if host.tool_kind(controller.Tool) == "ballend":
            return controller
    fresh = len(controllers) == 1 and not job.Operations.Group and _untouched(controllers[0])
    tool = preferences.tool()
    return host.add_ball_end_controller(
        job,
        tool.diameter,
        tool.flutes,
        tool.feed,
        tool.speed,
        controller=controllers[0] if fresh else host.append_controller(job),
    )


def _untouched(controller):
    """Whether a controller is the one that FreeCAD gives every new job: it has no spindle speed yet."""
    return controller.SpindleSpeed == 0.0


def machine_for(job):
    """Name of the machine file that a new operation or modifier of `job` takes: the one that the job or the
    first of its operations names, else the user's own, which the first choice in a panel makes, or ''."""
    named = [getattr(job, "PatchMillMachine", "")]
    named += [getattr(op, "Machine", "") for op in job.Operations.Group if kinds.kind_of(op)]
    return next(filter(None, named), preferences.operation_defaults()["Machine"])


def texture(proxy_module, name, part, faces):
    """A texture operation called `name` on `faces` (names) of `part`, with all that it needs.

    `proxy_module` is patchmill.CurvedTexture or one of its sisters. The user's preferences give its first
    values. Returns the operation, not recomputed."""
    job, model = job_for(part)
    controller, machine = ball_end_controller(job), machine_for(job)
    operation = proxy_module.Create(name, parentJob=job)
    operation.ToolController = controller
    operation.Base = [(model, list(faces))]
    for key, value in dict(preferences.operation_defaults(), Machine=machine).items():
        setattr(operation, key, value)
    operation.Proxy.refresh_heights(operation)
    return operation


def copy_milling(name, part, faces=()):
    """A CopyMilling operation called `name` on the whole of `part`, or on its `faces` (names), with all that
    it needs. Returns the operation, not recomputed."""
    from patchmill import CopyMilling

    job, model = job_for(part)
    controller, machine = ball_end_controller(job), machine_for(job)
    operation = CopyMilling.Create(name, parentJob=job)
    operation.ToolController, operation.Machine = controller, machine
    operation.Base = [(model, list(faces))] if faces else []
    for name, share in DEPTHS.items():
        setattr(operation, name, share * float(controller.Tool.Diameter))
    operation.Proxy.refresh_heights(operation)
    return operation


def dcm_modifier(name, base):
    """A DressupDCM called `name` on `base`, an operation or modifier of a job, with the job's machine, not
    recomputed. Raises InputError naming Base."""
    from patchmill import DressupDCM

    job = host.PathUtils.findParentJob(base)
    machine = machine_for(job) if job is not None else ""
    dressup = DressupDCM.Create(name, base)
    dressup.Machine = machine
    return dressup
