"""Machines: axes, joints, motion, programs that are written and read.

Made by tools/stubs from the compiled module.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import typing

import numpy
import numpy.typing
import _patchmill.patch
import _patchmill.path
import _patchmill.sync

class Kinematics:
    """Rotary axes in chain order, from the work to the tool."""
    def __init__(self, lowest: numpy.typing.ArrayLike, highest: numpy.typing.ArrayLike, work_zero: numpy.typing.ArrayLike) -> None:
        """Limits of X Y Z and the work zero, in the machine [mm]. Raises nothing: require_valid refuses it."""
        ...
    def add_rotary(self, letter: str, side: str, direction: numpy.typing.ArrayLike, point: numpy.typing.ArrayLike, lowest: float, highest: float, rate: float, acceleration: float) -> None:
        """The next axis on the way from the work to the tool: A, B or C on the table or the head; its direction and a point on it [mm], limits [rad], rate [rad/s] and acceleration [rad/s2]. Raises InputError naming letter or side. The rest is for require_valid."""
        ...
    def contact_azimuth(self, joints: list[list[float]], normal: numpy.typing.ArrayLike) -> float:
        """Azimuth [rad] of the contact point as seen from the housing; `normal` in the work frame. Raises InputError naming Joints or normal."""
        ...
    def in_work_frame(self, linear: numpy.typing.ArrayLike, joints: list[list[float]]) -> numpy.typing.NDArray[numpy.float64]:
        """The inverse of pivot_referred [mm]. Raises InputError naming Point or Joints."""
        ...
    @property
    def letters(self) -> str:
        ...
    def pivot_referred(self, point: numpy.typing.ArrayLike, joints: list[list[float]]) -> numpy.typing.NDArray[numpy.float64]:
        """What X Y Z are told without TCP for a programmed point of the work frame [mm]. Raises InputError naming Point or Joints."""
        ...
    def require_valid(self) -> None:
        """Refuses a machine that there cannot be. Raises InputError naming the place in the machine file: rotary_axes/0/direction, linear_limits_mm, work_zero_mm and so on."""
        ...
    def solve_axis(self, axis: numpy.typing.ArrayLike) -> list[list[list[float]]]:
        """Both ways to point the tool along `axis`, without limits and turns. Raises InputError naming axis."""
        ...
    def tool_axis(self, joints: list[list[float]]) -> numpy.typing.NDArray[numpy.float64]:
        """Unit tool axis in the work frame, from tip to holder. Raises InputError naming Joints."""
        ...

class MotionModel:
    """What a controller makes of a path. mm, s."""
    def __init__(self, velocity: float, acceleration: float, jerk: float = ..., period: float = 0.001, tolerance: float = 0.0, spindle_lock: bool = False) -> None:
        """Limits [mm/s], [mm/s2] and [mm/s3], servo period [s], tolerance of corners [mm]; `spindle_lock`: it has G33. Raises InputError naming MaxVelocity, MaxAcceleration, MaxJerk, ServoPeriod or PathTolerance."""
        ...
    @property
    def acceleration(self) -> float:
        ...
    @property
    def spindle_lock(self) -> bool:
        ...
    @property
    def velocity(self) -> float:
        ...

class PacedRule:
    """Spindle-locked or feed-paced, with lift and heights [mm]."""
    def __init__(self, locked: bool, phase: _patchmill.sync.PhaseRule, lift: float, safe_height: float, clearance_height: float, turning: list[float] = ..., rows: bool = False) -> None:
        """`turning` [s] at each dimple, for rotary axes; heights and `lift` in mm. Raises nothing: paced_path refuses what cannot be planned."""
        ...

class PathText:
    """Lines for Path.Path(), in parts; str() gives the whole."""
    def __getitem__(self, arg0: int) -> str:
        """A part of the text. Raises IndexError beyond the last."""
        ...
    def __len__(self) -> int:
        """How many parts it is in. Raises nothing."""
        ...
    def __str__(self) -> str:
        """All parts, one after the other. Raises nothing."""
        ...

class PlanMatch:
    """How a path read back compares with its plan."""
    @property
    def complete(self) -> bool:
        ...
    @property
    def extra_moves(self) -> int:
        ...
    @property
    def found(self) -> int:
        ...
    @property
    def largest_miss(self) -> float:
        ...
    @property
    def lost_moves(self) -> int:
        ...

class PosturePath:
    """A path with the angles of its rotary axes."""
    @property
    def joints(self) -> numpy.typing.NDArray[numpy.float64]:
        """At the start and at the end of each move, (n + 1, 2)."""
        ...
    @property
    def path(self) -> _patchmill.path.ToolPath:
        ...

class ProgramForm:
    """With TCP or without; programmed point; chords [mm]."""
    def __init__(self, tcp: bool = True, reference: str = 'tip', chord: float = 0.001, chord_clear: float = 0.0) -> None:
        """`reference`: tip or ball centre; chords [mm]. Raises InputError naming reference. `programmed` refuses Chord and ChordClear."""
        ...
    @property
    def tcp(self) -> bool:
        ...

class ProgramSection:
    """One tool, spindle speed and sense of a program."""
    @property
    def angles(self) -> numpy.typing.NDArray[numpy.float64]:
        """A, B and C at the start and at the end of each move [rad], (n + 1, 3)."""
        ...
    @property
    def feeds(self) -> numpy.typing.NDArray[numpy.float64]:
        """F of each move [mm/min, or 1/min where `inverse`]; nan for rapids, dwells and G33."""
        ...
    @property
    def inverse(self) -> numpy.typing.NDArray[numpy.bool_]:
        ...
    @property
    def lines(self) -> list[int]:
        ...
    @property
    def offset(self) -> str:
        """Work offset in force: 'G55', 'G54.1 P3'; '' while the program has named none."""
        ...
    def part(self, first: int, end: int, tool: _patchmill.path.Tool) -> ProgramSection:
        """The moves from `first` to before `end` alone, of `tool`. Raises InputError naming first."""
        ...
    @property
    def path(self) -> _patchmill.path.ToolPath:
        ...
    @property
    def tcp(self) -> numpy.typing.NDArray[numpy.bool_]:
        ...
    @property
    def tool_number(self) -> int:
        ...
    @property
    def unplaced(self) -> int:
        """Moves at the beginning that start nobody knows where."""
        ...

class Verdict:
    """Whether a machine can hold a plan."""
    @property
    def holding(self) -> str:
        ...
    @property
    def largest(self) -> float:
        ...
    @property
    def rms(self) -> float:
        ...
    @property
    def sentence(self) -> str:
        ...
    @property
    def speed(self) -> float:
        """Up to which it holds [revolutions per second]."""
        ...

def axis_load(machine: Kinematics, posture: PosturePath) -> dict[str, typing.Any]:
    """What a path asks of the axes, as shares of limits. Raises nothing."""
    ...
def calibration_side(period: float, step: float) -> int:
    """Dimples along the side of the calibration patch. Raises InputError naming PhasePeriod or PhaseStep. Angles in rad."""
    ...
def controls() -> list[dict]:
    """What each control can do, as dicts: name, title, file_ending, max_decimals, tcp, inverse_time, spindle_lock, cycles, offsets. Raises nothing."""
    ...
def feeds_of(text: str) -> list[float]:
    """The values of all F words of a path's text, in their order. Raises nothing."""
    ...
def fit_to_stops(path: _patchmill.path.ToolPath, model: MotionModel, feed: float, rule: _patchmill.sync.PhaseRule, decimals: int) -> _patchmill.path.ToolPath:
    """A constant-feed path with its legs fitted to the machine's stops; `feed` [mm/s]. Raises InputError naming Feed or Decimals."""
    ...
def freecad_paced_text(path: _patchmill.path.ToolPath, model: MotionModel, decimals: int) -> PathText:
    """A paced path as text for Path.Path(text): G0, G1, G33, G61, G64. Raises InputError naming Decimals."""
    ...
def freecad_text(path: _patchmill.path.ToolPath, feed: typing.Optional[float], decimals: int, exact_stop: bool = False) -> PathText:
    """A constant-feed path as text for Path.Path(text); `feed` [mm/s], or None for a path whose moves have their own. `exact_stop`: G61 first. Raises InputError naming Feed or Decimals."""
    ...
def judge_plan(plan: typing.Callable[[_patchmill.path.Spindle], _patchmill.path.ToolPath], dimples: _patchmill.patch.Dimples, tool: _patchmill.path.Tool, spindle: _patchmill.path.Spindle, rule: _patchmill.sync.PhaseRule, model: MotionModel, slower: bool = True) -> Verdict:
    """`plan`: a function from Spindle to ToolPath, tried at several speeds, or, without `slower`, at the spindle's own only. Raises InputError naming Plan. What `plan` raises is raised."""
    ...
def match_plan(read: _patchmill.path.ToolPath, plan: _patchmill.path.ToolPath, tolerance: float) -> PlanMatch:
    """Gives the moves of `read` the kinds and dimple numbers of `plan`, in place. Raises InputError naming Tolerance."""
    ...
def own_start_phase(path: _patchmill.path.ToolPath, dimples: _patchmill.patch.Dimples, rule: _patchmill.sync.PhaseRule, model: MotionModel, from_index: bool) -> float:
    """The start phase [rad] that a locked path has of itself, counted from the spindle's index; `from_index`: the controller counts a lock's turns from there, not from where the axes are at speed. Raises nothing."""
    ...
def paced_path(dimples: _patchmill.patch.Dimples, tool: _patchmill.path.Tool, spindle: _patchmill.path.Spindle, rule: PacedRule, model: MotionModel, decimals: int) -> tuple[_patchmill.path.ToolPath, float]:
    """(path, least height of the ball between rows when a tooth passes [mm]). Raises InputError naming Lift, SafeHeight, ClearanceHeight, Turning, ToolAxis, Spacing, MaxVelocity or Decimals."""
    ...
def phase_period(flutes: int, rule: _patchmill.sync.PhaseRule) -> float:
    """The spindle angle [rad] after which a flute is where one was. Raises InputError naming Flutes."""
    ...
def plan_joints(machine: Kinematics, axes: numpy.typing.ArrayLike, clear: numpy.typing.ArrayLike, pole_tolerance: float = 1e-09) -> dict[str, typing.Any]:
    """Joints along axes (n, 3) by least travel within limits; unwinding only where `clear`. Raises InputError naming clear, axes or PoleTolerance."""
    ...
def plan_path_joints(machine: Kinematics, path: _patchmill.path.ToolPath, pole_tolerance: float = 1e-09, decimals: typing.Optional[int] = None) -> PosturePath:
    """Any ToolPath with angles, put on decimals of a degree if given. Raises InputError naming ToolAxis, PoleTolerance or Decimals."""
    ...
def predicted_phase(path: _patchmill.path.ToolPath, model: MotionModel, dimples: _patchmill.patch.Dimples, rule: _patchmill.sync.PhaseRule) -> dict[str, typing.Any]:
    """The motion model's phase error at each dimple, start phase taken away. Raises nothing."""
    ...
def program_lines(text: str, dialect: str = 'linuxcnc') -> list[tuple[int, list[tuple[str, float]]]]:
    """[(line, [(letter, value), ...]), ...] of every line that has words, in the common tongue: G4 P in seconds, offsets as G54 to G59.3, TCP as G43.4 and G49. Raises InputError for a word that the control would refuse."""
    ...
def programmed(posture: PosturePath, machine: Kinematics, form: ProgramForm, decimals: int) -> PosturePath:
    """What X Y Z are told, on the decimals; without TCP moves may be split. Raises InputError naming Chord, ChordClear or Decimals."""
    ...
def read_gcode(text: str, tool: _patchmill.path.Tool, dialect: str = 'linuxcnc', rotary: bool = False, tcp_on: str = '', tcp_off: str = '') -> list[ProgramSection]:
    """The sections of a program; with `rotary` its points as programmed, and the angles beside them. Raises InputError for anything not understood."""
    ...
def safe_comment(dialect: str, text: str) -> str:
    """`text` as a comment that the control never acts on. Raises InputError naming Dialect."""
    ...
def start_phase(best_dimple: int, step: float, period: float) -> float:
    """The start phase [rad] that the best dimple of a calibration patch says, counted from 0; `step` per dimple and `period` [rad]. Raises InputError naming BestDimple, PhaseStep or PhasePeriod."""
    ...
def with_decimal_points(call: function) -> typing.Any:
    """call() with decimal points in this thread, whatever locale the process has. Raises what call() does."""
    ...
def with_feeds(text: str, feeds: list[float]) -> str:
    """A path's text with its F words replaced by `feeds`, where they are the same but for FreeCAD's six decimals. Raises InputError naming feeds."""
    ...
def with_start_phase(path: _patchmill.path.ToolPath, start_phase: float, period: float, decimals: int) -> _patchmill.path.ToolPath:
    """The path with the spindle turned on by period less `start_phase` [rad] before its first dimple. Raises InputError naming StartPhase, PhasePeriod, Path or Decimals."""
    ...
def with_tool(machine: Kinematics, tool_length: float, form: ProgramForm, tool: _patchmill.path.Tool) -> Kinematics:
    """`machine` with the tool length that the form's programmed point has. Raises InputError naming ToolLength."""
    ...
def write_program(texts: list[str], dialect: str, *, precision: int = 3, line_numbers: bool = False, comments: bool = True, modal: bool = False, axis_modal: bool = False, tool_length: bool = True, name: str = 'PATCHMILL', header: list[str] = ..., preamble: str = '', postamble: str = '', smoothing_on: str = '', smoothing_off: str = '', tcp_on: str = '', tcp_off: str = '', number: int = 1, retract: list[tuple[str, float]] = ..., stock: typing.Optional[tuple[numpy.typing.ArrayLike, numpy.typing.ArrayLike]] = None, own: list[bool] = ...) -> str:
    """The program of FreeCAD's path texts (Path.toGCode()) for a control. Raises InputError naming Dialect, PostProcessorArgs, Strategy, ProgramForm, Machine or Path."""
    ...
