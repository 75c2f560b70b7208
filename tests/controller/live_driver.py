#!/usr/bin/python3
"""LinuxCNC's "display" for the live session: sends batches as they are made, changes conditions half-way, and
records what moved. Runs inside the work folder of one run, beside base.py (harness/driver.py) and live.json.

Leaves samples.txt, verdict.txt and sent.json: the moves that were sent, with the conditions of each.
SPDX-License-Identifier: LGPL-2.1-or-later
"""
import json
import signal
import subprocess
import sys
import time

import base
import linuxcnc

GIVEN = json.load(open('live.json', encoding='utf-8'))
sys.path.insert(0, GIVEN['module'])
import _patchmill as core  # noqa: E402
from patchmill.verify import live as words  # noqa: E402


def session():
    """A LiveSession over a block with a hill, coarse enough to be short."""
    low, high = (0, 0, 0), (24, 24, 12)
    part = core.Solid.box((4, 4, 0), (20, 20, 8))
    grid = core.voxelise(core.Solid.box(low, high), part, 1.0)
    tool, spindle = core.BallEndMill(3.0, 2), core.Spindle(100.0, 'M3')
    options = core.CopyOptions('Scanning', tool, spindle, 20.0, 6.0, 2.0, 0.02, 0.0, low, high, 3.0)
    return core.LiveSession(part, grid, options, *GIVEN['feeds'][0])


class Sender:
    """Sends MDI commands, no more than `ahead` of them before the one that the machine is at."""

    def __init__(self, status, command, channel, ahead):
        self.status, self.command, self.channel, self.ahead = status, command, channel, ahead
        self.sent = []

    def send(self, text):
        while True:
            self.status.poll()
            base.raise_errors(self.channel)
            if self.status.queued_mdi_commands + self.status.queue < self.ahead:
                break
            time.sleep(0.002)
        self.command.mdi(text)
        deadline = time.monotonic() + base.START_SECONDS
        while self.status.echo_serial_number < self.command.serial:
            if time.monotonic() > deadline:
                base.leave('error: %s was not taken' % text)
            time.sleep(0.0005)
            self.status.poll()


def cut(sender):
    """The whole session; conditions change when a third and two thirds of it are sent."""
    live = session()
    changed = 0
    while not live.done:
        batch = live.next(GIVEN['batch_seconds'])
        for text in words.lines(batch):
            sender.send(text)
            value = {word[0]: float(word[1:]) for word in text.split()}
            feed = value['F'] / 60.0 if 'F' in value else None
            tip = [value[letter] for letter in 'XYZ']
            row = {'tip': tip, 'feed': feed, 'conditions': changed, 'level': live.level}
            sender.sent.append(row)
        if changed < 2 and len(sender.sent) >= GIVEN['change_at'][changed]:
            changed += 1
            low, high = GIVEN['feeds'][changed]
            live.change(low=low, high=high, axial_depth=GIVEN['axial'][changed])
    return live


def finish(sender):
    calm = 0
    while calm < 5:
        time.sleep(0.02)
        sender.status.poll()
        base.raise_errors(sender.channel)
        busy = sender.status.queue or sender.status.queued_mdi_commands or not sender.status.inpos
        calm = 0 if busy else calm + 1


def main():
    status, command, channel = base.connect()
    base.order(command, channel, command.state, linuxcnc.STATE_ESTOP_RESET)
    base.order(command, channel, command.state, linuxcnc.STATE_ON)
    base.order(command, channel, command.mode, linuxcnc.MODE_MDI)
    sender = Sender(status, command, channel, GIVEN['ahead'])
    for text in ('G21 G90 G94 G17', 'G64 P0.02 Q0', 'S6000 M3', 'G0 Z30'):
        sender.send(text)
    finish(sender)
    recorder = subprocess.Popen(['halsampler', '-t', 'samples.txt'])
    time.sleep(0.2)
    subprocess.run(['halcmd', 'setp', 'sampler.0.enable', '1'], check=True)
    try:
        cut(sender)
        finish(sender)
    finally:
        subprocess.run(['halcmd', 'setp', 'sampler.0.enable', '0'], check=True)
        time.sleep(0.2)
        recorder.send_signal(signal.SIGINT)
        recorder.wait(10)
    with open('sent.json', 'w', encoding='utf-8') as file:
        json.dump(sender.sent, file)
    base.leave('ok')


if __name__ == '__main__':
    main()
