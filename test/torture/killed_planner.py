"""The planner as a robot's executive uses it, while it is killed at random instants."""
import os
import random
import signal
import subprocess
import threading
import time

import rospy
from geometry_msgs.msg import Vector3
from mixed_palletizing.msg import OrderLine
from mixed_palletizing.srv import (ChooseNextPick, ChooseNextPickRequest, ChooseNextPickResponse, ClosePallet,
                                   GetPalletState, ReportPick, ReportPickRequest, StartPallet, StartPalletRequest,
                                   UndoLast)

NAME = 'pick_planner'
LINES = [('a', (0.3, 0.2, 0.1), 12), ('b', (0.4, 0.3, 0.2), 6), ('c', (0.25, 0.2, 0.15), 8)]
VISIBLE = 3
LONGEST_LIFE_S = 0.4  # from the moment the node answers to its death
START_TIMEOUT_S = 30.0
POLL_S = 0.005


class PlannerDied(Exception):
    """The call was not answered."""


class Lost(AssertionError):
    """The planner is not where it was acknowledged to be."""


class PlannerProcess:
    """The node on a journal; it can be killed by another thread."""

    def __init__(self, journal, log, arguments=()):
        self._command = [self._program(), '__name:=' + NAME, '_journal/file:=' + journal, *arguments]
        self._log = log
        self._process = None

    @staticmethod
    def _program():
        found = subprocess.run(['rosrun', '--prefix', 'echo', 'mixed_palletizing', 'pick_planner'],
                               stdout=subprocess.PIPE, universal_newlines=True, check=True)
        return found.stdout.strip().splitlines()[-1]

    def start(self):
        """Seconds until it answers."""
        begin = time.monotonic()
        self._process = subprocess.Popen(self._command, stdout=self._log, stderr=self._log)
        while True:
            if self._process.poll() is not None:
                raise Lost('the planner ended by itself with code %d' % self._process.returncode)
            try:
                call('get_pallet_state', GetPalletState)
                return time.monotonic() - begin
            except PlannerDied:
                if time.monotonic() - begin > START_TIMEOUT_S:
                    raise Lost('the planner does not answer after %.0f s' % START_TIMEOUT_S) from None
                time.sleep(POLL_S)

    def kill(self):
        if self._process is not None:
            os.kill(self._process.pid, signal.SIGKILL)
            self._process.wait()
            self._process = None


def call(name, kind, *request):
    try:
        return rospy.ServiceProxy('%s/%s' % (NAME, name), kind)(*request)
    except (rospy.ServiceException, rospy.ROSException, OSError) as error:
        raise PlannerDied(name) from error


class State:
    """What must survive, as the planner tells it."""

    def __init__(self, message):
        self.pallet = message.pallet_id if message.is_open else None
        self.revision = message.revision
        self.placed = [(p.type_id, p.origin.x, p.origin.y, p.origin.z) for p in message.placements]
        self.remaining = list(message.remaining)
        self.discarded = list(message.discarded)
        self.pending = message.pending_decision_id if message.has_pending else 0

    def __repr__(self):
        return str(self.__dict__)

    def same(self, other, pending=True):
        return (self.pallet, self.revision, self.placed, self.remaining, self.discarded) == (
            other.pallet, other.revision, other.placed, other.remaining, other.discarded) and (
                not pending or self.pending == other.pending)


class Executive:
    """Starts pallets, asks, reports, takes back; knows what was acknowledged. One step at a time; step() raises
    PlannerDied when a call was not answered, go_on() then finds out what became of it, as a robot would."""

    def __init__(self, seed):
        self._rng = random.Random(seed)
        self._count = 0
        self.steps = 0
        self.served_again = 0  # decisions that were asked for again after a restart
        self._known = None     # the last acknowledged State
        self._asked = None     # the last request of choose_next_pick and its answer, not yet reported
        self._step = None      # what was begun, until all of it is acknowledged
        self._acknowledged = False

    def look(self):
        self._known = State(call('get_pallet_state', GetPalletState).state)

    def step(self):
        if self._rng.random() < 0.2:
            time.sleep(self._rng.uniform(0.0, 0.02))  # the robot moves
        self._step = self._next_step()
        self._acknowledged = False
        self._do()
        self.look()  # when this is not answered the step stays open
        self._step = None
        self.steps += 1

    def _do(self):
        action, argument = self._step
        action(argument)
        self._acknowledged = True

    def _next_step(self):
        if self._known.pallet is None:
            self._count += 1
            return self._start, 'pallet %d' % self._count
        left = [line[0] for line, count in zip(LINES, self._known.remaining) for _ in range(count)]
        chance = self._rng.random()
        if chance < 0.05 and (self._known.placed or sum(self._known.discarded)):
            return self._undo, None
        if not left or chance < 0.06:
            return self._close, None
        if self._asked is None:
            self._count += 1
            return self._choose, ('request %d' % self._count, self._rng.sample(left, min(VISIBLE, len(left))))
        answer = self._asked[1]
        if answer.status == ChooseNextPickResponse.NONE_FITS or chance < 0.15:
            return self._report, (answer.decision_id, ReportPickRequest.DISCARDED)
        outcome = ReportPickRequest.FAILED if chance < 0.25 else ReportPickRequest.PLACED
        return self._report, (answer.decision_id, outcome)

    def _start(self, pallet):
        order = [OrderLine(type_id=n, size=Vector3(*s), count=c, rotations=OrderLine.YAW) for n, s, c in LINES]
        answer = call('start_pallet', StartPallet,
                      StartPalletRequest(pallet_id=pallet, size=Vector3(0.8, 0.6, 0.5), order=order))
        demand(answer.status == 0, answer.message)
        self._asked = None

    def _choose(self, argument):
        request, types = argument
        answer = call('choose_next_pick', ChooseNextPick, ChooseNextPickRequest(request_id=request, type_ids=types))
        demand(answer.status in (ChooseNextPickResponse.PICK, ChooseNextPickResponse.NONE_FITS), answer.message)
        self._asked = (argument, answer)

    def _report(self, argument):
        decision, outcome = argument
        answer = call('report_pick', ReportPick, ReportPickRequest(decision_id=decision, outcome=outcome))
        demand(answer.status == 0, answer.message)
        self._asked = None

    def _undo(self, _):
        answer = call('undo_last', UndoLast)
        demand(answer.status == 0, answer.message)
        self._asked = None

    def _close(self, _):
        answer = call('close_pallet', ClosePallet)
        demand(answer.status == 0, answer.message)
        self._asked = None

    def go_on(self):
        """After a restart. The pallet is the one that was acknowledged, or, if a call was not answered, what that call
        makes of it; then the call is repeated where that is harmless, or where it was not done."""
        before, now = self._known, State(call('get_pallet_state', GetPalletState).state)
        if self._step is None:
            demand(now.same(before), 'was %s, is %s' % (before, now))
        elif self._acknowledged:
            demand(self._is_result(before, now), '%s of %s was acknowledged, is %s' % (self._name(), before, now))
        else:
            done = not now.same(before, pending=False)
            demand(not done or self._is_result(before, now), '%s of %s gave %s' % (self._name(), before, now))
            if not done or self._step[0] in (self._choose, self._report):
                self._do()
            else:
                self._asked = None
        self.look()
        if self._step is not None:
            demand(self._is_result(before, self._known), '%s twice: %s' % (self._name(), self._known))
        self._step = None
        self._ask_again()

    def _ask_again(self):
        """The decision that was not reported yet is served again."""
        if self._asked is None:
            return
        argument, before = self._asked
        self._choose(argument)
        answer = self._asked[1]
        demand((answer.status, answer.decision_id, answer.chosen_index, answer.placement) ==
               (before.status, before.decision_id, before.chosen_index, before.placement),
               'another decision for request %s' % argument[0])
        self.look()
        self.served_again += 1

    def _name(self):
        return self._step[0].__name__.strip('_')

    def _is_result(self, before, now):
        """`now` may come of the open step, done once."""
        action, argument = self._step
        if action == self._choose or (action == self._report and argument[1] == ReportPickRequest.FAILED):
            return now.same(before, pending=False)
        if now.revision != before.revision + 1:
            return False
        if action == self._start:
            return now.pallet == argument and not now.placed
        if action == self._close:
            return now.pallet is None
        if action == self._undo:
            unplaced = bool(before.placed) and now.placed == before.placed[:-1] and now.discarded == before.discarded
            undiscarded = now.placed == before.placed and sum(now.discarded) < sum(before.discarded)
            return unplaced or undiscarded
        placed = 1 if argument[1] == ReportPickRequest.PLACED else 0
        return (now.placed[:len(before.placed)] == before.placed and
                len(now.placed) == len(before.placed) + placed and
                (sum(now.discarded) > sum(before.discarded)) == (placed == 0))


def demand(holds, what):
    if not holds:
        raise Lost(what)


class Killings:
    """Lets an executive work, kills the planner at a random instant and looks what it comes back with."""

    def __init__(self, journal, log, seed, arguments=('_time_budget_s:=0.02',)):
        self._rng = random.Random(seed)
        self._planner = PlannerProcess(journal, log, arguments)
        self._executive = Executive(seed + 1)
        self.recovery_s = []
        self.tried = 0

    def run(self, kills, on_kill=lambda tried: None):
        """Raises Lost at the first fault."""
        self._planner.start()
        try:
            self._executive.look()
            for _ in range(kills):
                self._work_until_killed()
                self.recovery_s.append(self._planner.start())
                self.tried += 1
                self._executive.go_on()
                on_kill(self.tried)
        finally:
            self._planner.kill()

    def _work_until_killed(self):
        killer = threading.Timer(self._rng.uniform(0.0, LONGEST_LIFE_S), self._planner.kill)
        killer.start()
        try:
            while True:
                self._executive.step()
        except PlannerDied:
            pass
        finally:
            killer.join()

    @property
    def steps(self):
        return self._executive.steps

    @property
    def served_again(self):
        return self._executive.served_again


def percentile(values, share):
    return sorted(values)[min(len(values) - 1, int(share * len(values)))]
