"""PatchMill's core, a submodule for each subject. mm, s, radians, revolutions per second.

Made by tools/stubs from the compiled module.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import typing

import numpy
import numpy.typing

from _patchmill import brep as brep
from _patchmill import collision as collision
from _patchmill import dcm as dcm
from _patchmill import machine as machine
from _patchmill import marks as marks
from _patchmill import patch as patch
from _patchmill import path as path
from _patchmill import scene as scene
from _patchmill import sync as sync
from _patchmill import voxel as voxel
from _patchmill.brep import FaceSampler as FaceSampler
from _patchmill.brep import LaidOnFaces as LaidOnFaces
from _patchmill.brep import facing as facing
from _patchmill.brep import keep_apart as keep_apart
from _patchmill.brep import keep_off_borders as keep_off_borders
from _patchmill.brep import lay_on_faces as lay_on_faces
from _patchmill.brep import nearest_distances as nearest_distances
from _patchmill.brep import seen_best as seen_best
from _patchmill.collision import PartModel as PartModel
from _patchmill.collision import Tessellation as Tessellation
from _patchmill.collision import check_clearance as check_clearance
from _patchmill.collision import part_model as part_model
from _patchmill.collision import part_model_of_mesh as part_model_of_mesh
from _patchmill.collision import tessellate as tessellate
from _patchmill.dcm import CopyOptions as CopyOptions
from _patchmill.dcm import FeedField as FeedField
from _patchmill.dcm import LiveSession as LiveSession
from _patchmill.dcm import PostureField as PostureField
from _patchmill.dcm import Solid as Solid
from _patchmill.dcm import VoxelGrid as VoxelGrid
from _patchmill.dcm import apply_dcm as apply_dcm
from _patchmill.dcm import copy_mill as copy_mill
from _patchmill.dcm import diffuse_feed as diffuse_feed
from _patchmill.dcm import estimate_voxels as estimate_voxels
from _patchmill.dcm import holder_clearance as holder_clearance
from _patchmill.dcm import hurry_in_air as hurry_in_air
from _patchmill.dcm import joined as joined
from _patchmill.dcm import limit_load as limit_load
from _patchmill.dcm import load_along as load_along
from _patchmill.dcm import load_voxels as load_voxels
from _patchmill.dcm import over_faces as over_faces
from _patchmill.dcm import path_steps as path_steps
from _patchmill.dcm import save_voxels as save_voxels
from _patchmill.dcm import scallop_height as scallop_height
from _patchmill.dcm import solid_of_brep as solid_of_brep
from _patchmill.dcm import steady_feed as steady_feed
from _patchmill.dcm import steady_posture as steady_posture
from _patchmill.dcm import voxelise as voxelise
from _patchmill.dcm import with_plunge_feed as with_plunge_feed
from _patchmill.machine import Kinematics as Kinematics
from _patchmill.machine import MotionModel as MotionModel
from _patchmill.machine import PacedRule as PacedRule
from _patchmill.machine import PathText as PathText
from _patchmill.machine import PlanMatch as PlanMatch
from _patchmill.machine import PosturePath as PosturePath
from _patchmill.machine import ProgramForm as ProgramForm
from _patchmill.machine import ProgramSection as ProgramSection
from _patchmill.machine import Verdict as Verdict
from _patchmill.machine import axis_load as axis_load
from _patchmill.machine import calibration_side as calibration_side
from _patchmill.machine import controls as controls
from _patchmill.machine import feeds_of as feeds_of
from _patchmill.machine import fit_to_stops as fit_to_stops
from _patchmill.machine import freecad_paced_text as freecad_paced_text
from _patchmill.machine import freecad_text as freecad_text
from _patchmill.machine import judge_plan as judge_plan
from _patchmill.machine import match_plan as match_plan
from _patchmill.machine import own_start_phase as own_start_phase
from _patchmill.machine import paced_path as paced_path
from _patchmill.machine import phase_period as phase_period
from _patchmill.machine import plan_joints as plan_joints
from _patchmill.machine import plan_path_joints as plan_path_joints
from _patchmill.machine import predicted_phase as predicted_phase
from _patchmill.machine import program_lines as program_lines
from _patchmill.machine import programmed as programmed
from _patchmill.machine import read_gcode as read_gcode
from _patchmill.machine import safe_comment as safe_comment
from _patchmill.machine import start_phase as start_phase
from _patchmill.machine import with_decimal_points as with_decimal_points
from _patchmill.machine import with_feeds as with_feeds
from _patchmill.machine import with_start_phase as with_start_phase
from _patchmill.machine import with_tool as with_tool
from _patchmill.machine import write_program as write_program
from _patchmill.marks import TextureMarks as TextureMarks
from _patchmill.marks import ToolMotion as ToolMotion
from _patchmill.marks import best_start_phase as best_start_phase
from _patchmill.marks import classify_alignment as classify_alignment
from _patchmill.marks import compare_window as compare_window
from _patchmill.marks import dales as dales
from _patchmill.marks import housing_x as housing_x
from _patchmill.marks import motion_of_path as motion_of_path
from _patchmill.marks import motion_of_samples as motion_of_samples
from _patchmill.marks import path_on_machine as path_on_machine
from _patchmill.marks import simulate_texture as simulate_texture
from _patchmill.patch import DimpleState as DimpleState
from _patchmill.patch import Dimples as Dimples
from _patchmill.patch import Mask as Mask
from _patchmill.patch import MeshSampler as MeshSampler
from _patchmill.patch import MeshSurface as MeshSurface
from _patchmill.patch import PatchDivision as PatchDivision
from _patchmill.patch import PatchPattern as PatchPattern
from _patchmill.patch import PatchSurface as PatchSurface
from _patchmill.patch import ProjectedSurface as ProjectedSurface
from _patchmill.patch import SurfaceLattice as SurfaceLattice
from _patchmill.patch import TexturePlane as TexturePlane
from _patchmill.patch import TriangleMesh as TriangleMesh
from _patchmill.patch import cover as cover
from _patchmill.patch import cover_lattice as cover_lattice
from _patchmill.patch import curve_mask as curve_mask
from _patchmill.patch import dimples_at as dimples_at
from _patchmill.patch import drop_slivers as drop_slivers
from _patchmill.patch import flattest_row_direction as flattest_row_direction
from _patchmill.patch import from_patch as from_patch
from _patchmill.patch import image_mask as image_mask
from _patchmill.patch import in_rows as in_rows
from _patchmill.patch import keep_where as keep_where
from _patchmill.patch import lay_lattice as lay_lattice
from _patchmill.patch import least_patch_side as least_patch_side
from _patchmill.patch import milled_patches as milled_patches
from _patchmill.patch import nearest_row_direction as nearest_row_direction
from _patchmill.patch import nearest_start as nearest_start
from _patchmill.patch import patch_block as patch_block
from _patchmill.patch import patch_shapes as patch_shapes
from _patchmill.patch import row_directions as row_directions
from _patchmill.patch import row_pitch as row_pitch
from _patchmill.patch import set_depth as set_depth
from _patchmill.patch import sink as sink
from _patchmill.patch import spacing_spread as spacing_spread
from _patchmill.patch import state_names as state_names
from _patchmill.patch import texture_plane as texture_plane
from _patchmill.patch import texture_size as texture_size
from _patchmill.patch import thin_out as thin_out
from _patchmill.patch import two_sided as two_sided
from _patchmill.patch import up_to_patch as up_to_patch
from _patchmill.path import BallEndMill as BallEndMill
from _patchmill.path import MoveKind as MoveKind
from _patchmill.path import NO_DIMPLE as NO_DIMPLE
from _patchmill.path import Spindle as Spindle
from _patchmill.path import Tool as Tool
from _patchmill.path import ToolPath as ToolPath
from _patchmill.path import make_path as make_path
from _patchmill.path import with_dimples as with_dimples
from _patchmill.path import with_pacing_of as with_pacing_of
from _patchmill.path import with_turns as with_turns
from _patchmill.scene import Display as Display
from _patchmill.scene import arrow_display as arrow_display
from _patchmill.scene import dimple_display as dimple_display
from _patchmill.scene import grid_display as grid_display
from _patchmill.scene import order_display as order_display
from _patchmill.scene import outline_display as outline_display
from _patchmill.scene import path_axis_display as path_axis_display
from _patchmill.scene import path_display as path_display
from _patchmill.scene import scale_colour as scale_colour
from _patchmill.scene import slice_display as slice_display
from _patchmill.scene import state_colours as state_colours
from _patchmill.sync import FreePatch as FreePatch
from _patchmill.sync import FreeTexture as FreeTexture
from _patchmill.sync import MarkWish as MarkWish
from _patchmill.sync import PhaseRule as PhaseRule
from _patchmill.sync import Postures as Postures
from _patchmill.sync import advise as advise
from _patchmill.sync import axes_by_row as axes_by_row
from _patchmill.sync import constant_feed_path as constant_feed_path
from _patchmill.sync import free_form_path as free_form_path
from _patchmill.sync import free_form_phases as free_form_phases
from _patchmill.sync import freecad_rotary_text as freecad_rotary_text
from _patchmill.sync import mark_tool_tip as mark_tool_tip
from _patchmill.sync import mark_tool_tip_along as mark_tool_tip_along
from _patchmill.sync import phase_errors as phase_errors
from _patchmill.sync import place_free as place_free
from _patchmill.sync import plan_postures as plan_postures
from _patchmill.sync import posted_feed as posted_feed
from _patchmill.sync import section_in_work as section_in_work
from _patchmill.sync import tilts as tilts
from _patchmill.sync import tool_axes as tool_axes
from _patchmill.sync import turning_seconds as turning_seconds
from _patchmill.sync import with_azimuths as with_azimuths
from _patchmill.sync import with_postures as with_postures
from _patchmill.voxel import NO_MATERIAL as NO_MATERIAL
from _patchmill.voxel import STOCK_MATERIAL as STOCK_MATERIAL
from _patchmill.voxel import VoxelKind as VoxelKind
from _patchmill.voxel import VoxelMaterials as VoxelMaterials
from _patchmill.voxel import axes_at as axes_at
from _patchmill.voxel import feed_at as feed_at
from _patchmill.voxel import kinds_at as kinds_at
from _patchmill.voxel import materials_at as materials_at
from _patchmill.voxel import materials_of as materials_of
from _patchmill.voxel import scale_feed as scale_feed

__version__: str
class Cancelled:
    """Ends what is done within `with Watch(progress)` when `progress` returned False; goes no further. No fault, and
        so no Exception: nothing that handles faults on the way takes it for one."""

class InputError(ValueError):
    """Bad input: names the property, its value and the remedy."""
    property: str
    value: typing.Any
    remedy: str
    def __init__(self, property: str, value: object, remedy: str) -> None: ...

class ThreadLimit:
    """While it lives, no more threads than this are used."""
    def __init__(self, threads: int) -> None:
        """At most so many threads, 1 or more. Raises InputError naming Threads."""
        ...

class Watch:
    """with Watch(progress) as progress: all long calls within also ask `progress` (share -> bool), and the block ends where it returns False. Watch(None) asks the one around it, which ends then."""
    def __call__(self, share: float) -> bool:
        """Tells the share done, 0 to 1; whether to go on. Raises what the progress raises, and Cancelled where it is that of a Watch around this one that says no."""
        ...
    def __enter__(self) -> Watch:
        """Begins to be asked in this thread. Raises nothing."""
        ...
    def __exit__(self, arg0: object, arg1: object, arg2: object) -> bool:
        """Ends it, and Cancelled with it if its own progress said no. Raises nothing."""
        ...
    def __init__(self, progress: object = None) -> None:
        """Raises InputError naming Progress."""
        ...

