#!/usr/bin/env python3
"""The planner is killed again and again and serves the same pallet; two planners on one journal; a damaged journal."""
import json
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import rosgraph
import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from geometry_msgs.msg import Vector3
from mixed_palletizing.msg import OrderLine
from mixed_palletizing.srv import (ChooseNextPick, ChooseNextPickRequest, ChooseNextPickResponse, ClosePallet,
                                   GetPalletState, ReportPick, ReportPickRequest, StartPallet, StartPalletRequest)
from std_msgs.msg import String

from cell_client import Latest

SEED = 3
RESTART_S = 2.0


class Journal(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.file = os.path.join(self.folder, 'p.journal')
        self.node = None

    def tearDown(self):
        if self.node:
            self.kill()
        shutil.rmtree(self.folder)

    def command(self, name='pick_planner'):
        return ['rosrun', 'mixed_palletizing', 'pick_planner', '__name:=' + name, '_journal/file:=' + self.file,
                '_time_budget_s:=0.02']

    def begin(self):
        """Starts the node; seconds until it answers."""
        start = time.monotonic()
        self.node = subprocess.Popen(self.command())
        return self.wait_until_it_answers(start)

    def wait_until_it_answers(self, start):
        rospy.wait_for_service('pick_planner/close_pallet', 30.0)
        while True:  # the master may still name the killed one
            try:
                self.call('get_pallet_state', GetPalletState)
                return time.monotonic() - start
            except rospy.ServiceException:
                self.assertLess(time.monotonic() - start, 30.0)
                time.sleep(0.02)

    def kill(self):
        os.kill(self.node.pid, signal.SIGKILL)
        self.node.wait()
        self.node = None

    @staticmethod
    def call(name, kind, request=None):
        return rospy.ServiceProxy('pick_planner/' + name, kind)(*([] if request is None else [request]))

    def state(self):
        state = self.call('get_pallet_state', GetPalletState).state
        state.header.stamp = rospy.Time()
        state.header.seq = 0
        return state

    def start_pallet(self):
        lines = [OrderLine(type_id='a', size=Vector3(0.3, 0.2, 0.1), count=20, rotations=OrderLine.YAW),
                 OrderLine(type_id='b', size=Vector3(0.4, 0.3, 0.2), count=10, rotations=OrderLine.YAW)]
        answer = self.call('start_pallet', StartPallet,
                           StartPalletRequest(pallet_id='p', size=Vector3(1.2, 0.8, 0.6), order=lines))
        self.assertEqual(answer.status, 0, answer.message)

    def test_killed_and_restarted(self):
        rng = random.Random(SEED)
        self.begin()
        self.start_pallet()
        for _ in range(8):
            for _ in range(rng.randint(1, 3)):
                choice = self.call('choose_next_pick', ChooseNextPick, ChooseNextPickRequest(type_ids=['a', 'b', 'a']))
                self.assertEqual(choice.status, 0, choice.message)
                self.call('report_pick', ReportPick, ReportPickRequest(decision_id=choice.decision_id))
            asked = ChooseNextPickRequest(request_id='r', type_ids=['b', 'a'])
            choice = self.call('choose_next_pick', ChooseNextPick, asked)
            before = self.state()
            self.kill()
            taken = self.begin()
            self.assertLess(taken, RESTART_S)
            self.assertEqual(self.state(), before)
            again = self.call('choose_next_pick', ChooseNextPick, asked)
            self.assertEqual((again.decision_id, again.placement), (choice.decision_id, choice.placement))
            done = self.call('report_pick', ReportPick, ReportPickRequest(decision_id=choice.decision_id))
            self.assertEqual(done.status, 0, done.message)
        history = subprocess.run(['rosrun', 'mixed_palletizing', 'pallet_journal', '--journal', self.file],
                                 stdout=subprocess.PIPE, universal_newlines=True, check=True, timeout=30).stdout
        self.assertIn("started 'p' with 30 items", history)
        self.assertEqual(self.call('close_pallet', ClosePallet).status, 0)

    def listens(self, node, topic):
        """Waits until a node has subscribed to a latched topic, and a little for the message."""
        end = time.monotonic() + 30.0
        while node not in dict(rosgraph.Master('/test').getSystemState()[1]).get(topic, []):
            self.assertLess(time.monotonic(), end, f'{node} does not subscribe')
            time.sleep(0.1)
        time.sleep(1.0)

    def report(self, pallet_id, end):
        """The report that is written when `end` ends the pallet, and its page."""
        folder = os.path.join(self.folder, 'reports')
        node = subprocess.Popen(['rosrun', 'mixed_palletizing', 'pallet_reporter', '_folder:=' + folder])
        try:
            written = Latest('pallet_report', String)
            self.listens('/pallet_reporter', '/pick_planner/pallet_state')
            end()
            path = written.wait_for(lambda m: os.path.basename(m.data).startswith(pallet_id + '_'), 30.0)
            self.assertIsNotNone(path, 'no report')
        finally:
            node.terminate()
            node.wait(30)
        with open(path.data) as page, open(path.data.replace('.html', '.json')) as record:
            return json.load(record)['pallets'][0], page.read()

    def test_a_report_at_the_end(self):
        self.begin()
        self.start_pallet()
        for outcome in (0, 0, 1):
            choice = self.call('choose_next_pick', ChooseNextPick, ChooseNextPickRequest(type_ids=['a', 'b']))
            done = self.call('report_pick', ReportPick, ReportPickRequest(decision_id=choice.decision_id, outcome=outcome))
            self.assertEqual(done.status, 0, done.message)
        state = self.state()
        record, page = self.report('p', lambda: self.call('close_pallet', ClosePallet))
        self.assertEqual([p['type'] for p in record['placements']], [p.type_id for p in state.placements])
        self.assertAlmostEqual(record['utilization'], state.utilization)
        for axis, value in zip('xyz', record['center_of_gravity_mm']):
            self.assertAlmostEqual(value / 1000.0, getattr(state.center_of_gravity, axis), delta=1e-4)
        self.assertEqual(sum(u['count'] for u in record['unpacked']), 28)
        self.assertEqual(record['decision_ms']['count'], 3)
        self.assertIn('thrown out at the cell', page)

    def test_two_planners_and_a_damaged_journal(self):
        self.begin()
        self.start_pallet()
        second = subprocess.run(self.command('other'), stderr=subprocess.PIPE, universal_newlines=True, timeout=30)
        self.assertNotEqual(second.returncode, 0)
        self.assertIn('another planner', second.stderr)
        self.kill()
        with open(self.file, 'r+b') as file:
            file.truncate(os.path.getsize(self.file) // 2)
        third = subprocess.run(self.command('third'), stderr=subprocess.PIPE, universal_newlines=True, timeout=30)
        self.assertNotEqual(third.returncode, 0)
        self.assertIn('damaged', third.stderr)

    def test_a_full_disk(self):
        """No file may grow beyond a limit: refused and unchanged, then on as before where there is room."""
        limit = 48 * 1024
        start = time.monotonic()
        self.node = subprocess.Popen(
            self.command(), restore_signals=False,  # SIGXFSZ stays ignored, as Python has it: writing fails instead
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
        self.wait_until_it_answers(start)
        self.start_pallet()
        diagnostics = Latest('/diagnostics', DiagnosticArray)
        told = lambda level, name, words: lambda message: any(
            (status.level, status.name) == (level, 'pick_planner: ' + name) and words in status.message
            for status in message.status)
        good = diagnostics.wait_for(told(DiagnosticStatus.OK, 'pallet', ': 0 of '), 10.0)
        self.assertIsNotNone(good, diagnostics.all()[-1:])
        while True:
            before = self.state()
            choice = self.call('choose_next_pick', ChooseNextPick, ChooseNextPickRequest(type_ids=['a', 'b']))
            if choice.status != 0:
                break
            self.call('report_pick', ReportPick,
                      ReportPickRequest(decision_id=choice.decision_id, outcome=ReportPickRequest.FAILED))
            self.assertLess(time.monotonic() - start, 120.0, 'the disk does not fill')
        self.assertEqual(choice.status, ChooseNextPickResponse.FAILED)
        self.assertIn(self.file, choice.message)
        self.assertEqual(self.state(), before)
        bad = diagnostics.wait_for(told(DiagnosticStatus.ERROR, 'services', self.file), 10.0)
        self.assertIsNotNone(bad, diagnostics.all()[-1:])
        self.kill()
        self.begin()
        self.assertEqual(self.state().placements, before.placements)
        self.assertEqual(self.state().revision, before.revision)
        choice = self.call('choose_next_pick', ChooseNextPick, ChooseNextPickRequest(type_ids=['a', 'b']))
        self.assertEqual(choice.status, 0, choice.message)

    def test_a_read_only_journal(self):
        """A user who may read but not write it: the start is refused with what to do, the journal as it was."""
        # Root writes where no permission is given; without that power it is a user who owns the workspace as before.
        powerless = ['setpriv', '--inh-caps=-all', '--bounding-set=-dac_override,-dac_read_search']
        self.begin()
        self.start_pallet()
        before = self.state()
        self.kill()
        names = [os.path.join(self.folder, name) for name in os.listdir(self.folder)]
        for name, mode in [(name, 0o400) for name in names] + [(self.folder, 0o500)]:
            os.chmod(name, mode)
        refused = subprocess.run((powerless if os.geteuid() == 0 else []) + self.command(), stderr=subprocess.PIPE,
                                 universal_newlines=True, timeout=30)
        for name, mode in [(self.folder, 0o700)] + [(name, 0o600) for name in names]:
            os.chmod(name, mode)
        self.assertNotEqual(refused.returncode, 0)
        self.assertIn('may write there', refused.stderr)
        self.begin()
        self.assertEqual(self.state(), before)


if __name__ == '__main__':
    rospy.init_node('test_journal')
    rostest.rosrun('mixed_palletizing', 'journal', Journal, sys.argv)
