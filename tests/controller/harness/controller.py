"""Runs a G-code program through LinuxCNC (task, motion, simulated spindle) and returns what moved.

    from harness.controller import Machine, run
    log = run('program.ngc', Machine(acceleration=2000, velocity=100))

No display, no real-time kernel, no privileges: LinuxCNC lives in process, message, network and
mount namespaces of its own, so that runs do not meet and the kernel ends everything with the first
process.
SPDX-License-Identifier: LGPL-2.1-or-later
"""
import dataclasses
import os
import pathlib
import re
import shutil
import signal
import subprocess
import tempfile

import numpy

from . import load, table

HERE = pathlib.Path(__file__).resolve().parent
NOBODY = 65534
MOVE = re.compile(r'\s*(N\d+\s*)?(G0?[0-3]|G33)\b.*[XYZ]', re.ASCII)
PATIENCE = 400  # of task with motion, in seconds of their fast clock: 4 s end programs on a busy computer
TOOLS = 3  # in the tool table, each without a length: programs have tool tips
SHORT = 10  # lines at a program's end that may be too short for a log


class ControllerError(RuntimeError):
    """LinuxCNC refused the program."""


class TooFast(load.Unknown):
    """The log has a gap or the motion queue ran empty: the wall's clock could not keep up. Or LinuxCNC did
    not start, or did not end in time."""


@dataclasses.dataclass
class Machine:
    """A mill. Limits hold for each linear axis, and for each rotary one if it has them."""
    acceleration: float = 2000.0  # mm/s²
    velocity: float = 100.0       # mm/s
    period: float = 1e-3          # servo period, s
    speed_ratio: float = 1.0      # true spindle speed / commanded speed
    travel: float = 1000.0        # ± mm
    kinematics: str = 'xyz'       # or xyza; or xyzac, xyzbc: tables, which start without TCP
    rotary_acceleration: float = 20000.0  # degrees/s²
    rotary_velocity: float = 1000.0       # degrees/s
    rotary_travel: float = 1e5            # ± degrees
    offsets: dict = dataclasses.field(default_factory=dict)  # {'G55': (x, y, z)}, mm; others are zero

    @property
    def letters(self):
        return self.kinematics.upper()


@dataclasses.dataclass
class Log:
    """One entry for each servo period."""
    time: numpy.ndarray   # s, counted in servo periods
    tip: numpy.ndarray    # (n, 3) tool tip from the joints, mm
    turns: numpy.ndarray  # spindle revolutions; their fraction is the angle from the index
    line: numpy.ndarray   # program line
    starved: int          # how often the motion queue ran empty
    joints: numpy.ndarray = None  # (n, 3) linear joints, mm: the tip itself on three axes
    rotary: numpy.ndarray = None  # (n, 1 or 2) rotary joints, degrees; None on three axes

    def save(self, path):
        columns = numpy.column_stack([self.time, self.tip, self.turns, self.line])
        numpy.savetxt(path, columns, delimiter=',', comments='', fmt='%.7f',
                      header='time_s,x_mm,y_mm,z_mm,turns,line')


def ini(machine):
    """The text of machine.ini."""
    axis = {'MIN_LIMIT': -machine.travel, 'MAX_LIMIT': machine.travel,
            'MAX_VELOCITY': machine.velocity, 'MAX_ACCELERATION': machine.acceleration}
    joint = dict(axis, TYPE='LINEAR', FERROR=1000, MIN_FERROR=1000, HOME_SEARCH_VEL=0,
                 HOME_LATCH_VEL=0, HOME_SEQUENCE=0)
    # the limits of the path are above those of any axis, so that the axes decide
    sections = {
        'EMC': {'VERSION': '1.1', 'MACHINE': 'patchmill', 'DEBUG': 0},
        'DISPLAY': {'DISPLAY': './driver.py', 'CYCLE_TIME': 0.1},
        'TASK': {'TASK': 'milltask', 'CYCLE_TIME': 0.001},
        'RS274NGC': {'PARAMETER_FILE': 'machine.var'},
        'EMCMOT': {'EMCMOT': 'motmod', 'COMM_TIMEOUT': PATIENCE,
                   'SERVO_PERIOD': round(machine.period * 1e9)},
        'EMCIO': {'EMCIO': 'io', 'CYCLE_TIME': 0.01, 'TOOL_TABLE': 'machine.tbl'},
        'HAL': {'HALFILE': 'machine.hal'},
        'KINS': {'KINEMATICS': 'trivkins coordinates=XYZ', 'JOINTS': 3},
        'SAMPLER': {'CFG': 'ffffsb'},
        'TRAJ': {'COORDINATES': ' '.join(machine.letters), 'LINEAR_UNITS': 'mm', 'ANGULAR_UNITS': 'deg',
                 'DEFAULT_LINEAR_VELOCITY': machine.velocity,
                 'MAX_LINEAR_VELOCITY': 2 * machine.velocity,
                 'DEFAULT_LINEAR_ACCELERATION': 2 * machine.acceleration,
                 'MAX_LINEAR_ACCELERATION': 2 * machine.acceleration, 'NO_FORCE_HOMING': 1},
        'SPINDLE_0': {'RPM_PER_SECOND': 5000, 'SPEED_RATIO': machine.speed_ratio},
    }
    rotary = {'MIN_LIMIT': -machine.rotary_travel, 'MAX_LIMIT': machine.rotary_travel,
              'MAX_VELOCITY': machine.rotary_velocity, 'MAX_ACCELERATION': machine.rotary_acceleration}
    for number, letter in enumerate(machine.letters):
        sections['AXIS_' + letter] = axis if letter in 'XYZ' else rotary
        sections['JOINT_%d' % number] = joint if letter in 'XYZ' else dict(joint, **rotary, TYPE='ANGULAR')
    extra = {}
    if machine.kinematics == 'xyza':
        sections['KINS'] = {'KINEMATICS': 'trivkins coordinates=XYZA', 'JOINTS': 4}
        extra = {'HAL': ['HALFILE = rotary_a.hal']}
    elif machine.kinematics != 'xyz':
        sections.update(table.sections(machine.kinematics))
        extra = {'HAL': ['HALFILE = rotary.hal'], 'RS274NGC': table.REMAPS}
    if machine.kinematics != 'xyz':
        sections['SAMPLER']['CFG'] += 'f' * (len(machine.letters) - 3)
        sections['TRAJ'].update(MAX_ANGULAR_VELOCITY=2 * machine.rotary_velocity,
                                DEFAULT_ANGULAR_VELOCITY=machine.rotary_velocity,
                                MAX_ANGULAR_ACCELERATION=2 * machine.rotary_acceleration)
    lines = []
    for name, entries in sections.items():
        lines += ['[%s]' % name] + ['%s = %s' % entry for entry in entries.items()]
        lines += extra.get(name, [])
    return '\n'.join(lines) + '\n'


def parameters(offsets):
    """The text of machine.var: places of the work offsets, G54 at 5221 and each other 20 further."""
    lines = []
    for name, place in sorted(offsets.items()):
        first = 5221 + 20 * (int(name[1:]) - 54)
        lines += ['%d\t%.6f' % (first + k, value) for k, value in enumerate(place)]
    return '\n'.join(lines) + '\n' if lines else ''


def prepare(folder, program, machine):
    """Fills the work folder of one run."""
    (folder / 'machine.ini').write_text(ini(machine), encoding='utf-8')
    tools = ''.join('T%d P%d D2\n' % (number, number) for number in range(1, TOOLS + 1))
    (folder / 'machine.tbl').write_text(tools, encoding='utf-8')
    (folder / 'machine.var').write_text(parameters(machine.offsets), encoding='utf-8')
    table.write_subroutines(folder)
    for name in ('machine.hal', 'rotary.hal', 'rotary_a.hal', 'driver.py'):
        shutil.copy(HERE / name, folder / name)
    (folder / 'driver.py').chmod(0o755)
    shutil.copy(program, folder / 'program.ngc')
    subprocess.run(['gcc', '-O2', '-shared', '-fPIC', '-o', folder / 'virtual_clock.so',
                    HERE / 'virtual_clock.c'], check=True)
    for path in [folder, *folder.rglob('*')]:
        path.chmod(path.stat().st_mode | 0o666 | (0o111 if path.is_dir() else 0))


def command_line(folder, rate):
    """unshare … linuxcnc. An ordinary user gets namespaces through a user namespace of his own."""
    inside = 'ip link set lo up; mount -t tmpfs tmpfs /dev/shm; cd "$1"; shift; exec "$@"'
    first, user = [], ['--user', '--map-current-user', '--keep-caps']
    become = ['setpriv', '--no-new-privs']
    if os.getuid() == 0:
        # before others: a task that is kept waiting keeps the motion queue short, and the planner brakes
        first, user = ['nice', '-n', '-10'], []
        become += ['--reuid=%d' % NOBODY, '--regid=%d' % NOBODY, '--clear-groups']
    return [*first, 'unshare', *user, '--fork', '--pid', '--mount-proc', '--ipc', '--net', '--kill-child',
            'bash', '-c', inside, 'bash', folder, *become,
            'env', '-i', 'PATH=/usr/bin:/bin', 'HOME=%s' % folder, 'LANG=C',
            'CLOCK_RATE=%g' % rate, 'LD_PRELOAD=%s' % (folder / 'virtual_clock.so'),
            'linuxcnc', folder / 'machine.ini']


def read_samples(path, machine):
    """halsampler's lines -> Log. Whole turns that an index reset took away are put back."""
    rows = []
    with open(path, encoding='ascii') as file:
        for text in file:
            if text.startswith('overrun'):
                raise TooFast('the log has a gap')
            row = text.split()
            if len(row) == 4 + len(machine.letters):
                rows.append(row)
    if len(rows) < 2:
        raise TooFast('nothing was logged')
    samples = numpy.array(rows, dtype=float)
    if numpy.any(numpy.diff(samples[:, 0]) != 1):
        raise TooFast('the log has a gap')
    turns = samples[:, 4]
    lost = numpy.where(numpy.diff(turns) < -0.5, numpy.ceil(-numpy.diff(turns)), 0.0)
    turns = turns + numpy.concatenate([[0.0], numpy.cumsum(lost)])
    settled = samples[:, 6]
    starved = int(numpy.sum(numpy.diff(settled) > 0))
    joints, rotary, tip = samples[:, 1:4], None, samples[:, 1:4]
    if machine.kinematics != 'xyz':
        rotary = samples[:, 7:]
        tip = table.tip_in_work(machine.kinematics, joints, rotary)
    time = (samples[:, 0] - samples[0, 0]) * machine.period
    return Log(time, tip, turns, samples[:, 5], starved, joints, rotary)


def last_move(program):
    """Number of the last line of a program that moves the tool, counted from 1; 0 if none does."""
    with open(program, encoding='utf-8') as file:
        return max((number for number, line in enumerate(file, 1) if MOVE.match(line)), default=0)


def require_whole(log, program):
    """Raises TooFast if the log ends before the program: a motion queue that runs empty in the middle, with
    the tool at rest, looks like the program's end."""
    last = last_move(program)
    if log.line.max() < last - SHORT:
        raise TooFast('it ended at line %d of %d' % (log.line.max(), last))


def end(child):
    """Kills the first process of the run's namespace; the kernel then ends the others. (The signal
    that unshare asks for at its own death is lost when setpriv changes the user.)"""
    if child.poll() is None:
        children = pathlib.Path('/proc/%d/task/%d/children' % (child.pid, child.pid))
        for pid in children.read_text(encoding='ascii').split():
            os.kill(int(pid), signal.SIGKILL)
        try:
            child.wait(5)
        except subprocess.TimeoutExpired:
            child.kill()
    child.wait()


def run_once(program, machine, rate, limit):
    """One run at one clock rate; see run()."""
    with tempfile.TemporaryDirectory(prefix=f'patchmill-controller-{os.getpid()}-') as name:
        folder = pathlib.Path(name)
        prepare(folder, program, machine)
        output = folder / 'output.txt'
        with open(output, 'wb') as sink:
            child = subprocess.Popen(command_line(folder, rate), stdout=sink,
                                     stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL)
            try:
                child.wait(limit)
            except subprocess.TimeoutExpired:
                raise TooFast('not done after %g s' % limit) from None
            finally:
                end(child)
        verdict = folder / 'verdict.txt'
        words = verdict.read_text(encoding='utf-8').strip() if verdict.exists() else 'no verdict'
        if words != 'ok':
            if 'waiting for index' in words:  # a chain of G33 waits once: the queue ran empty in it
                raise TooFast(words)
            tail = output.read_text(errors='replace')[-1500:]
            refused = words.startswith('error')
            raise (ControllerError if refused else TooFast)('%s\n%s' % (words, tail))
        log = read_samples(folder / 'samples.txt', machine)
        require_whole(log, program)
        return log


def run(program, machine=None, rate=20.0, limit=120.0, stops=1):
    """Runs the G-code file `program`. `rate`: simulated seconds in a second, lowered if the
    computer is too busy for it; `limit`: wall seconds for each attempt; `stops`: how often the
    motion queue runs empty in this program (at its end, and at each block that waits).

    Returns a Log; raises ControllerError with LinuxCNC's own words, TooFast if nothing can be said.
    """
    machine = machine or Machine()
    reason = ''
    for slower in (1, 3, 10):
        try:
            log = run_once(program, machine, rate / slower / load.slower(), limit)
        except TooFast as unknown:
            reason = str(unknown)
            continue
        if log.starved <= stops:
            load.note(log)
            return log
        reason = 'the motion queue ran empty'
    raise TooFast('%s, at every clock rate' % reason)
