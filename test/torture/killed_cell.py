"""A cell at work whose processes are killed: camera, the detector's manager and its loader, planner, executive, master."""
import json
import os
import random
import signal
import subprocess
import sys
import time
import xmlrpc.client

import rospy
from mixed_palletizing.srv import GetPalletState

from robot_executive import line

HERE = os.path.dirname(os.path.realpath(__file__))
sys.path.insert(0, os.path.join(HERE, '..', 'node'))

from processes import pid_of  # noqa: E402

NODES = {'camera': '/zivid_camera/camera', 'manager': '/camera_manager', 'loader': '/box_detector', 'planner': '/pick_planner'}
VICTIMS = ['executive', 'manager', 'camera', 'master', 'executive', 'planner', 'loader']
BOXES = 40           # of a pallet
LONGEST_LIFE_S = 3.0  # from the recovery to the next kill
BOND_S = 6.0  # until the manager notices that the loader is gone, and unloads the detector
GOES_ON_S = 90.0
STOPS_S = 60.0
POLL_S = 0.02


class Lost(AssertionError):
    """The cell is not where it was acknowledged to be, or does not go on."""


def demand(holds, what):
    if not holds:
        raise Lost(what)


def write_orders(path, pallets, count):
    item = {'type': 'a', 'size_mm': [300, 200, 150], 'count': count, 'rotations': 'yaw'}
    with open(path, 'w', encoding='utf-8') as file:
        for i in range(pallets):
            order = {'name': 'pallet %d' % i, 'pallet_mm': [1200, 800, 750], 'n_pick': 3, 'items': [item]}
            file.write(json.dumps(order) + '\n')


class Cell:
    """roslaunch with a master of its own, as a supervisor (systemd, say) would run it: started again when it ends."""

    def __init__(self, folder, port, log):
        self._folder, self._port, self._log = folder, port, log
        self._boxes = os.path.join(folder, 'boxes.jsonl')
        write_orders(self._boxes, 1, 1000)  # more than the orders want: what a killed gripper drops is gone
        self._launch = None

    def start(self):
        self._launch = subprocess.Popen(
            ['roslaunch', '--no-summary', '-p', str(self._port), os.path.join(HERE, '..', 'node', 'small_cell.launch'),
             'boxes:=' + self._boxes, 'journal:=' + os.path.join(self._folder, 'p.journal'),
             'calibration_file:=' + os.path.join(self._folder, 'calibration.yaml'), 'respawn:=true',
             'time_budget_s:=0.05'], stdout=self._log, stderr=self._log)

    def ended(self):
        return self._launch.poll() is not None

    def kill(self, victim):
        """False when there is no such process just now."""
        try:
            os.kill(self._pid(victim), signal.SIGKILL)
        except (OSError, xmlrpc.client.Error):
            return False
        return True

    def _pid(self, victim):
        uri = 'http://localhost:%d' % self._port
        if victim == 'master':
            return xmlrpc.client.ServerProxy(uri).getPid('/kill_cell')[2]
        return pid_of(NODES[victim], uri)

    def stop(self):
        if self._launch is not None and not self.ended():
            self._launch.send_signal(signal.SIGINT)
            self._launch.wait(STOPS_S)


class Work:
    """The executive and the pallet before it. Whoever starts it again looks at the pallet first."""

    def __init__(self, folder, log, pallets):
        self._folder, self._log = folder, log
        self._orders = os.path.join(folder, 'orders.jsonl')
        write_orders(self._orders, pallets, BOXES)
        self._index = 0
        self._process = None
        self.placed_before = 0  # on pallets that are complete
        self.starts = 0
        self.pending = {'placed': 0, 'failed': 0}  # picks in the middle of which the executive ended

    def on_pallet(self):
        """What stands there, box by box."""
        try:
            with open(self._placed(), encoding='ascii') as file:
                return file.read().splitlines()
        except FileNotFoundError:
            return []

    def count(self):
        return self.placed_before + len(self.on_pallet())

    def start(self):
        """Does nothing while the planner does not answer."""
        state = self._state()
        if state is None:
            return
        if not state.is_open and self.on_pallet():  # it ended between closing the pallet and saying so
            self._next_pallet()
        words = [sys.executable, os.path.join(HERE, 'robot_executive.py'), '_order:=' + self._orders,
                 '_index:=%d' % self._index, '_placed:=' + self._placed()]
        if state.has_pending:
            outcome = self._look_at_pallet(state)
            self.pending[outcome] += 1
            words.append('_pending:=' + outcome)
        self._process = subprocess.Popen(words, stdout=self._log, stderr=self._log)
        self.starts += 1

    def _look_at_pallet(self, state):
        on_pallet = self.on_pallet()
        if len(on_pallet) == len(state.placements):
            return 'failed'
        demand(on_pallet[len(state.placements):] == [line(state.pending.pose.position)],
               '%d boxes stand there, the planner knows %d' % (len(on_pallet), len(state.placements)))
        return 'placed'

    def kill(self):
        if self._process is None or self._process.poll() is not None:
            return False
        self._process.kill()
        self._process.wait()
        return True

    def keep_going(self):
        """Starts the executive again when it ended; the next pallet when one is complete."""
        if self._process is not None:
            if self._process.poll() is None:
                return
            if self._process.returncode == 0:
                self._next_pallet()
            self._process = None
        self.start()

    def _next_pallet(self):
        demand(len(self.on_pallet()) == BOXES, 'complete with %d boxes' % len(self.on_pallet()))
        self.placed_before += BOXES
        self._index += 1

    def check(self):
        """The planner's pallet is the one that stands there, but for a box whose report is under way."""
        before = self.on_pallet()
        state = self._state()
        if state is None or not state.is_open or state.pallet_id != 'pallet %d' % self._index:
            return
        known = [line(p.pose.position) for p in state.placements]
        after = self.on_pallet()
        demand(len(before) <= len(known) + 1 and after[:len(known)] == known,
               'on the pallet %s, the planner knows %s' % (after, known))
        demand(len(set(after)) == len(after), 'a place twice: %s' % after)

    def _placed(self):
        return os.path.join(self._folder, 'placed %d' % self._index)

    @staticmethod
    def _state():
        try:
            return rospy.ServiceProxy('/pick_planner/get_pallet_state', GetPalletState)().state
        except (rospy.ServiceException, rospy.ROSException, OSError):
            return None


class CellKillings:
    """Kills one process after the other while boxes are packed; how long until the next boxes stand on the pallet."""

    def __init__(self, folder, port, log, seed, kills):
        self._rng = random.Random(seed)
        self._cell = Cell(folder, port, log)
        self._work = Work(folder, log, kills)
        self._kills = kills
        self.recovery_s = {victim: [] for victim in sorted(set(VICTIMS))}
        self.tried = 0

    def run(self, on_kill=lambda tried: None):
        """Raises Lost at the first fault."""
        self._cell.start()
        try:
            self._goes_on(time.monotonic(), 0, False)
            for i in range(self._kills):
                victim = VICTIMS[i % len(VICTIMS)]
                self._work_on(self._rng.uniform(0.0, LONGEST_LIFE_S))
                begin, before = self._kill(victim)
                self.tried += 1
                self.recovery_s[victim].append(self._goes_on(begin, before, victim == 'master'))
                self._work.check()
                on_kill(self.tried)
        finally:
            self._work.kill()
            self._cell.stop()

    def _kill(self, victim):
        end = time.monotonic() + GOES_ON_S
        while not (self._work.kill() if victim == 'executive' else self._cell.kill(victim)):
            demand(time.monotonic() < end, 'there is no %s to kill' % victim)
            self._work_on(POLL_S)
        begin = time.monotonic()
        if victim == 'loader':
            self._work_on(BOND_S)
        return begin, self._work.count()

    def _work_on(self, seconds):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            self._work.keep_going()
            time.sleep(POLL_S)

    def _goes_on(self, begin, count, may_end):
        """Seconds from `begin` until two more boxes stand on the pallet: the first may have been on its way."""
        while self._work.count() < count + 2:
            demand(time.monotonic() - begin < GOES_ON_S, 'no box for %.0f s' % GOES_ON_S)
            if self._cell.ended():
                demand(may_end, 'roslaunch ended by itself')
                self._cell.start()
                may_end = False
            self._work.keep_going()
            time.sleep(POLL_S)
        return time.monotonic() - begin

    @property
    def boxes(self):
        return self._work.count()

    @property
    def starts(self):
        return self._work.starts

    @property
    def pending(self):
        return self._work.pending
