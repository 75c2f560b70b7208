"""Tool axes of a texture from the posture over the removal volume: the voxel model of a DressupDCM, or one of
the texture's own (Kobayashi & Shirase 2014, section 3.3; docs/dcm-fields.md). Only the axis comes from there;
a texture's feed is its timing.

The axis of a dimple is the field's at the ball centre c = p + R n, where the dressup reads it too: at the
surface itself the field is the normal, and the tip of the ball would rub.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from dataclasses import dataclass, field

import _patchmill as core
from _patchmill import InputError

from patchmill.freecad import host
from patchmill.voxels import removal_model

DEFLECTION, MEMORY_LIMIT = 0.05, 4096.0  # mm, MiB: of a model of the texture's own


@dataclass
class AxisField:
    """Callable: (positions, normals) of dimples, both (n, 3) -> (n, 3) unit axes, zero inside the part.
    `source`: label of the DressupDCM, '' for a model of the texture's own; `radius` of the ball [mm]."""

    given: removal_model.ModelInput
    file: str
    source: str
    radius: float
    model: removal_model.RemovalModel = field(default=None, compare=False, repr=False)

    def prepare(self, progress=None):
        """Makes or loads the voxel model; False if `progress` (share -> bool) returned False. Raises
        InputError naming PostureField, FieldVoxelSize, Stock or Model."""
        if self.model is None:
            try:
                self.model = removal_model.make(self.given, self.file, progress)
            except InputError as error:
                raise self._named(error) from error
        return self.model is not None

    def _named(self, error):
        """The error with the name of the texture's own property."""
        if self.source and error.property not in ("Stock", "Model"):
            told = "%s %s: %s" % (error.property, error.value, error.remedy)
            return InputError("PostureField", self.source, told)
        return InputError(
            {"VoxelSize": "FieldVoxelSize"}.get(error.property, error.property), error.value, error.remedy
        )

    def __call__(self, positions, normals):
        self.prepare()
        return core.axes_at(self.model.grid, self.model.posture, positions + self.radius * normals)


def of(obj, radius):
    """AxisField of a texture operation whose ToolAxisMode is Field, else None. `radius` of its ball [mm].
    Raises InputError naming PostureField, Stock or Model."""
    if obj.ToolAxisMode != "Field":
        return None
    job = host.PathUtils.findParentJob(obj)
    if job is None:
        raise InputError("PostureField", "none", "the texture belongs to no job with a stock and a model.")
    dressup = obj.PostureField
    if dressup is None:
        stock, part = removal_model.job_shapes(job)
        given = removal_model.ModelInput(
            stock, part, obj.FieldVoxelSize.Value, DEFLECTION, MEMORY_LIMIT, True
        )
        return AxisField(given, removal_model.file_beside(obj.Document, obj.Name), "", radius)
    if not gives_field(dressup):
        raise InputError("PostureField", dressup.Label, "choose a DCM modifier, or none.")
    keeper = obj if dressup.Controls == "Feed" else dressup  # whose file has the posture in it
    given = removal_model.input_of(dressup, job, True)
    file = removal_model.file_beside(obj.Document, keeper.Name)
    return AxisField(given, file, dressup.Label, radius)


def gives_field(obj):
    """Whether a document object can be a texture's PostureField."""
    return all(hasattr(obj, name) for name in ("VoxelSize", "PostureForm", "TiltLimit", "Controls"))
