"""What a texture is made from, without a document.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

from dataclasses import dataclass, field

import _patchmill as core

from patchmill.textures import masks
from patchmill.textures.order import rows
from patchmill.textures.strategy import table


@dataclass
class TextureInput:
    """What a texture is made from. Lengths in mm, angles in degrees, feed in mm/s."""

    breps: list  # BREP texts of faces; those in one text share their edges; none on a mesh
    tool: core.BallEndMill
    spindle: core.Spindle
    feed: float
    safe_height: float
    clearance_height: float
    mesh: core.MeshSurface = field(default=None, kw_only=True)  # in the place of faces
    heights_follow: bool = field(default=False, kw_only=True)  # they are not the user's own: see heights
    surface: core.PatchSurface = field(default_factory=lambda: core.PatchSurface("Curved"))
    # sizes: give what is known, 0 for the rest; in a plan `spacing` is the one that was found
    spacing: float = 0.5
    texture_kind: str = "Overlapping"
    depth: float = 0.0
    dimple_diameter: float = 0.0
    area_share: float = 0.0
    ridge_height: float = 0.0
    mapping: str = "Projected"
    ball_lattice: str = field(default="Icosahedral", kw_only=True)  # of mapping Ball, with the next two
    ball_dimples: int = field(default=0, kw_only=True)  # on the whole ball; 0: by the spacing
    ball_setups: str = field(default="One", kw_only=True)
    patch_shape: str = "Square"
    patch_side: int = 14
    patch_side_across: int = field(default=0, kw_only=True)  # of rectangles; 0: as patch_side
    patches_x: int = 0  # 0 with patches_y: as many as cover the faces
    patches_y: int = 0
    helix_order: str = "Inward"
    helix_start: str = "Same corner"
    order: str = "Helix"  # or Thread, or Rows; then the next three count (see textures.order.rows)
    row_extent: str = "Whole face"
    row_direction: str = "Least time"
    rows_one_way: bool = False
    direction: tuple = (0.0, 0.0, -1.0)
    auto_direction: bool = False  # from where the faces look largest; `direction` is not used
    rotation: float = 0.0
    origin: tuple = None  # None: the middle of the faces as seen along the direction
    steepest_slope: float = 80.0
    minimum_tilt: float = 1.0
    avoid_rubbing: bool = False
    margin: float = 0.0
    minimum_dimples: int = 0
    mask: masks.MaskInput = None
    same_flute: bool = True
    extra_turns: float = 5.0
    phase_step: float = 0.0
    decimals: int = 3
    strategy: str = table.NAMES[0]
    machine: str = ""  # key of a machine file; '' for none
    lift: float = 0.1  # clearance of paced paths between rows [mm]
    tool_axis_mode: str = "Fixed"  # see patchmill.tool_posture
    fixed_axis: tuple = (0.0, 0.0, 1.0)
    lead: float = 15.0
    tilt: float = 0.0
    minimum_lead: float = 10.0
    lead_towards: tuple = (0.0, 0.0, 0.0)  # zero: the feed
    axis_smoothing: float = 0.0
    widest_tilt: float = 180.0
    row_tolerance: float = 10.0
    posture_field: object = None  # positions, normals -> (n, 3) axes; an axis_field.AxisField, for one
    program_form: str = "As the machine"
    gauge_length: float = 0.0  # to the tip, for heads without TCP [mm]
    form: str = "Lattice"  # or Matsuda's "Free"; then these count, and feed_per_tooth 0 is that of the feed
    free_side: float = 7.0
    cross_feed: float = 0.5
    feed_per_tooth: float = 0.0
    plane_fit: str = "Best fit"
    first_patch: int = field(default=1, kw_only=True)  # of those in milling order, from 1
    last_patch: int = field(default=0, kw_only=True)  # 0: to the end
    patch_stops: bool = field(default=False, kw_only=True)  # M1 before each
    rapids: tuple = field(default=(0.0, 0.0), kw_only=True)  # across, and up or down [mm/s]
    patch_comments: bool = field(default=False, kw_only=True)
    calibrating: bool = False  # the machine's start phase is being looked for, not applied

    @property
    def rows_across_patches(self):
        """Whether rows go on from patch to patch."""
        return rows.across_patches(self)

    @property
    def keeps_phase(self):
        """The Strategy of its name. Raises InputError naming Strategy."""
        return table.of(self.strategy)
