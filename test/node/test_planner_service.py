#!/usr/bin/env python3
"""What the planner does beside answering: thinks ahead, plans with partly known orders, comes from the free side."""
import sys
import threading
import time

import rospy
import rostest
from geometry_msgs.msg import Vector3
from mixed_palletizing.msg import OrderLine
from mixed_palletizing.srv import (ChooseNextPickResponse as Choice, ReportPickRequest, ReportPickResponse as Report,
                                   StartPalletRequest, StartPalletResponse as Started)

from planner_client import PlannerClient

BUDGET_S = 0.2  # of planner_service.test
LINES = [('a', (300, 200, 100), 4, OrderLine.YAW), ('b', (400, 200, 100), 4, OrderLine.YAW),
         ('c', (200, 200, 150), 4, OrderLine.YAW)]
SIZE = Vector3(0.8, 0.6, 0.5)


class PlannerService(PlannerClient):
    def test_thinks_ahead(self):
        self.start(lines=LINES, size=SIZE)
        here = ['a', 'b', 'c']
        first = self.choose(*here)
        self.assertFalse(first.pondered)
        time.sleep(BUDGET_S * (len(LINES) + 3))  # the robot moves; it thinks of every type that may come
        self.assertEqual(self.report(first.decision_id).status, Report.OK)
        del here[first.chosen_index]
        second = self.choose(*here, 'b')
        self.assertEqual(second.status, Choice.PICK, second.message)
        self.assertTrue(second.pondered)
        self.assertLess(second.decision_ms, BUDGET_S * 1e3)
        self.assertEqual(self.report(second.decision_id, ReportPickRequest.FAILED).status, Report.OK)
        time.sleep(BUDGET_S * 0.5)
        unforeseen = self.choose('a')
        self.assertEqual(unforeseen.status, Choice.PICK)
        self.assertFalse(unforeseen.pondered)

    def test_thinking_delays_nothing(self):
        self.start(lines=LINES, size=SIZE)
        for _ in range(5):
            choice = self.choose('a', 'b', 'c', time_budget=5.0 * BUDGET_S)
            begin = time.monotonic()
            self.assertEqual(self.report(choice.decision_id).status, Report.OK)
            self.assertEqual(self.services['undo_last']().status, Report.OK)
            self.assertLess(time.monotonic() - begin, 4.0 * BUDGET_S)

    def test_what_is_known_of_the_order(self):
        lines = [(name, size, 0 if name == 'c' else count, turn) for name, size, count, turn in LINES]
        for knowledge, counted, expected, words in (
                (StartPalletRequest.SET, LINES, [], '9 more boxes come'),
                (StartPalletRequest.FORECAST, lines, [0.0, 1.0, 2.5], '3.5 are expected'),
                (StartPalletRequest.TYPES, [line[:2] + (0,) + line[3:] for line in LINES], [], 'nothing is known')):
            answer = self.start(lines=counted, size=SIZE, knowledge=knowledge, expected=expected, close_open=True)
            self.assertEqual(answer.status, Started.OK, answer.message)
            self.assertIn('as likely as another', answer.message)
            for visible in (['a'], ['b', 'c'], ['a', 'b', 'c'], ['a', 'a', 'b', 'b', 'c'], ['a', 'b'] * 4 + ['c'] * 2):
                choice = self.choose(*visible)
                self.assertEqual(choice.status, Choice.PICK, choice.message)
                self.assertIn('%d ' % len(visible), choice.assumed)
                self.assertIn(words if len(visible) == 3 and words[0] != '3' else '', choice.assumed)
            done = self.report(choice.decision_id)
            self.assertEqual(done.status, Report.OK, done.message)
            state = self.state().state
            self.assertEqual(state.knowledge, knowledge)
            self.assertEqual(len(state.expected), 0 if knowledge == StartPalletRequest.SET else 3)
        for _ in range(60):  # more than expected, until the pallet is full: never complete
            choice = self.choose('b')
            if choice.status == Choice.NONE_FITS:
                break
            self.assertEqual(choice.status, Choice.PICK, choice.message)
            self.assertEqual(self.report(choice.decision_id).status, Report.OK)
        self.assertEqual(choice.status, Choice.NONE_FITS)
        self.assertTrue(all(option.reason for option in choice.options))

    def test_comes_from_the_free_side(self):
        self.start(lines=[('a', (400, 600, 100), 2)], size=Vector3(0.8, 0.6, 0.1))
        first = self.choose('a')
        self.assertEqual((first.placement.approach.z, first.placement.approach_distance), (-1.0, 0.0))
        self.report(first.decision_id)
        second = self.choose('a')
        self.assertLess(second.placement.approach.x, 0.0)
        self.assertLess(second.placement.approach.z, second.placement.approach.x)
        self.assertAlmostEqual(second.placement.approach_distance, (0.02 ** 2 + 0.05 ** 2) ** 0.5)
        pending = self.state().state.pending
        self.assertEqual(pending.approach, second.placement.approach)

    def test_two_executives_at_once(self):
        """Both ask and report at will: every box is placed once, whoever came late is told so."""
        self.start(lines=[('a', (200, 200, 100), 30)], size=SIZE)
        accepted = []

        def work(name):
            for i in range(12):
                choice = self.choose('a', request_id='%s %d' % (name, i), time_budget=0.01)
                if choice.status != Choice.PICK:
                    continue
                answer = self.report(choice.decision_id)
                self.assertIn(answer.status, (Report.OK, Report.UNKNOWN_DECISION), answer.message)
                if answer.status == Report.OK:
                    accepted.append(choice.decision_id)

        threads = [threading.Thread(target=work, args=(name,)) for name in 'xy']
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        state = self.state().state
        self.assertEqual(len(state.placements), len(accepted))
        self.assertEqual(len(set(accepted)), len(accepted))
        self.assertEqual(list(state.remaining), [30 - len(accepted)])


if __name__ == '__main__':
    rospy.init_node('test_planner_service')
    rostest.rosrun('mixed_palletizing', 'planner_service', PlannerService, sys.argv)
