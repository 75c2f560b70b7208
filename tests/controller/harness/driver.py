#!/usr/bin/python3
"""LinuxCNC's "display" without a display: switches on, runs program.ngc, records it, leaves.

Runs inside the work folder of one run. Leaves samples.txt (halsampler's lines) and verdict.txt,
whose first word is "ok", "error", or "unknown" if the machine was too busy to tell.
SPDX-License-Identifier: LGPL-2.1-or-later
"""
import signal
import subprocess
import sys
import time

import linuxcnc

START_SECONDS = 30
ERRORS = (linuxcnc.NML_ERROR, linuxcnc.OPERATOR_ERROR)


def leave(verdict):
    with open('verdict.txt', 'w', encoding='utf-8') as file:
        file.write(verdict + '\n')
    sys.exit(0 if verdict.startswith('ok') else 1)


def connect():
    """Channels to task, once it answers."""
    deadline = time.monotonic() + START_SECONDS
    while time.monotonic() < deadline:
        try:
            status = linuxcnc.stat()
            status.poll()
            if status.task_state:
                return status, linuxcnc.command(), linuxcnc.error_channel()
        except linuxcnc.error:
            pass
        time.sleep(0.02)
    leave('unknown: task did not start')


def raise_errors(channel):
    while True:
        message = channel.poll()
        if not message:
            return
        if message[0] in ERRORS:
            leave('error: ' + message[1])


def order(command, channel, call, *values):
    call(*values)
    answer = command.wait_complete(START_SECONDS)
    if answer != linuxcnc.RCS_DONE:
        raise_errors(channel)
        what = 'error: %s%r was refused' if answer == linuxcnc.RCS_ERROR else 'unknown: no answer to %s%r'
        leave(what % (call.__name__, values))


def run(status, command, channel):
    """Starts the program and waits until the interpreter and the motion queue are both done."""
    command.auto(linuxcnc.AUTO_RUN, 0)
    deadline = time.monotonic() + START_SECONDS
    calm, begun = 0, False
    while calm < 4:
        time.sleep(0.02)
        status.poll()
        raise_errors(channel)
        idle = status.interp_state == linuxcnc.INTERP_IDLE and status.inpos and not status.queue
        # a program that has not begun looks idle as well
        begun = begun or status.motion_line > 0 or status.interp_state != linuxcnc.INTERP_IDLE
        if not begun and time.monotonic() > deadline:
            leave('unknown: the program never began')
        if idle and status.state == linuxcnc.RCS_ERROR:  # without a message: motion did not answer in time
            leave('unknown: task gave up at line %d' % status.motion_line)
        calm = calm + 1 if idle and begun else 0


def switch_on(status, command, channel):
    """Out of the emergency stop and on. On a busy computer the stop is still there when it has been reset."""
    deadline = time.monotonic() + START_SECONDS
    while status.task_state != linuxcnc.STATE_ON:
        if time.monotonic() > deadline:
            leave('unknown: the machine did not switch on')
        order(command, channel, command.state, linuxcnc.STATE_ESTOP_RESET)
        order(command, channel, command.state, linuxcnc.STATE_ON)
        time.sleep(0.05)
        status.poll()


def home(status, command, channel):
    """Kinematics other than the identity want homed joints."""
    order(command, channel, command.mode, linuxcnc.MODE_MANUAL)
    command.teleop_enable(0)
    command.wait_complete()
    for joint in range(status.joints):
        command.home(joint)
    deadline = time.monotonic() + START_SECONDS
    while not all(status.homed[:status.joints]):
        if time.monotonic() > deadline:
            leave('unknown: homing took too long')
        time.sleep(0.02)
        status.poll()
        raise_errors(channel)


def main():
    status, command, channel = connect()
    switch_on(status, command, channel)
    if status.joints > 3:
        home(status, command, channel)
    order(command, channel, command.mode, linuxcnc.MODE_AUTO)
    order(command, channel, command.program_open, 'program.ngc')
    recorder = subprocess.Popen(['halsampler', '-t', 'samples.txt'])
    time.sleep(0.2)
    subprocess.run(['halcmd', 'setp', 'sampler.0.enable', '1'], check=True)
    try:
        run(status, command, channel)
    finally:
        subprocess.run(['halcmd', 'setp', 'sampler.0.enable', '0'], check=True)
        time.sleep(0.2)
        recorder.send_signal(signal.SIGINT)
        recorder.wait(10)
    leave('ok')


if __name__ == '__main__':
    main()
