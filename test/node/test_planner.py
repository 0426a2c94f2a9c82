#!/usr/bin/env python3
"""The planner through its services, topics and action: every status of the dialogue."""
import sys
import threading

import actionlib
import rospy
import rostest
from geometry_msgs.msg import Point, Pose, Vector3
from mixed_palletizing.msg import PickDecision, PickOption, PlanPalletAction, PlanPalletGoal, PlanPalletResult
from mixed_palletizing.srv import (ChooseNextPickRequest, ChooseNextPickResponse as Choice, ClosePalletResponse,
                                   GetPalletStateResponse, ReportPickRequest, ReportPickResponse as Report,
                                   StartPalletResponse as Start, UndoLastResponse)

from cell_client import Latest, order_line
from planner_client import LINES, PlannerClient, detected

class Planner(PlannerClient):
    def test_without_a_pallet(self):
        self.assertEqual(self.choose('big').status, Choice.NO_PALLET)
        self.assertEqual(self.report(1).status, Report.NO_PALLET)
        self.assertEqual(self.services['undo_last']().status, UndoLastResponse.NO_PALLET)
        self.assertEqual(self.state().status, GetPalletStateResponse.NO_PALLET)
        self.assertEqual(self.services['close_pallet']().status, ClosePalletResponse.NO_PALLET)

    def test_bad_orders_are_refused(self):
        nan = float('nan')
        for name, values in {
                'no id': {'pallet_id': ''},
                'no lines': {'lines': []},
                'zero size': {'lines': [('a', (0, 400, 100), 1)]},
                'negative size': {'lines': [('a', (-300, 400, 100), 1)]},
                'NaN size': {'lines': [('a', (nan, 400, 100), 1)]},
                'huge size': {'lines': [('a', (1e12, 400, 100), 1)]},
                'no count': {'lines': [('a', (300, 400, 100), 0)]},
                'same name twice': {'lines': [('a', (300, 400, 100), 1), ('a', (300, 400, 200), 1)]},
                'unknown rotations': {'lines': [('a', (300, 400, 100), 1, 9)]},
                'negative gap': {'gap': -0.01},
                'support': {'min_support_ratio': 1.5},
                'NaN pallet': {'size': Vector3(nan, 0.4, 0.2)},
        }.items():
            answer = self.start(**values)
            self.assertEqual(answer.status, Start.BAD_REQUEST, name)
            self.assertTrue(answer.message, name)
            self.assertEqual(self.state().status, GetPalletStateResponse.NO_PALLET, name)

    def test_one_pallet_at_a_time(self):
        self.assertEqual(self.start().status, Start.OK)
        self.assertEqual(self.start(pallet_id='q').status, Start.PALLET_OPEN)
        self.assertEqual(self.state().state.pallet_id, 'p')
        self.assertEqual(self.start(pallet_id='q', close_open=True).status, Start.OK)
        self.assertEqual(self.state().state.pallet_id, 'q')

    def test_whole_dialogue(self):
        revision = self.start().revision
        here = ['big', 'flat', 'flat']
        while here:
            choice = self.choose(*here)
            self.assertEqual(choice.status, Choice.PICK, choice.message)
            self.assertEqual(choice.header.frame_id, 'pallet')
            self.assertEqual(here[choice.chosen_index], choice.type_id)
            self.assertEqual(len(choice.options), len(here))
            self.assertTrue(choice.options[choice.chosen_index].feasible)
            self.assertEqual(choice.placement.approach.z, -1.0)
            pending = self.state().state
            self.assertTrue(pending.has_pending)
            self.assertEqual(pending.revision, revision, 'a choice must change nothing')
            done = self.report(choice.decision_id)
            self.assertEqual(done.status, Report.OK, done.message)
            self.assertGreater(done.revision, revision)
            again = self.report(choice.decision_id)
            self.assertEqual((again.status, again.revision), (Report.OK, done.revision))
            revision = done.revision
            del here[choice.chosen_index]
        self.assertEqual(self.choose('big').status, Choice.ORDER_COMPLETE)
        state = self.states.wait_for(lambda m: m.revision == revision and m.is_open, 5.0)
        self.assertIsNotNone(state, 'the latched state does not follow')
        self.assertAlmostEqual(state.utilization, 1.0)
        self.assertEqual(len(state.placements), 3)
        self.assertEqual(list(state.remaining), [0, 0])
        self.assertGreater(self.markers.count(), 0)
        summary = self.services['close_pallet']().summary
        self.assertEqual((summary.placed, summary.discarded, summary.remaining), (3, 0, 0))
        self.assertEqual((summary.unpacked_ratio, summary.min_support_ratio), (0.0, 1.0))
        self.assertAlmostEqual(summary.gravity_margin, 0.2)
        self.assertAlmostEqual(summary.utilization, 1.0)
        self.assertEqual(summary.decisions, 3)

    def test_same_request_same_answer(self):
        self.start()
        first = self.choose('big', 'flat', request_id='r')
        second = self.choose('big', 'flat', request_id='r')
        self.assertEqual((first.decision_id, first.chosen_index, first.placement),
                         (second.decision_id, second.chosen_index, second.placement))
        self.assertEqual(self.choose('flat', request_id='r').status, Choice.CONFLICT)

    def test_detected_boxes(self):
        self.start()
        request = ChooseNextPickRequest(boxes=[detected((303, 398, 201)), detected((123, 77, 50))])
        choice = self.services['choose_next_pick'](request)
        self.assertEqual(choice.status, Choice.PICK, choice.message)
        self.assertEqual((choice.chosen_index, choice.type_id), (0, 'big'))
        self.assertEqual(choice.options[1].status, PickOption.UNKNOWN_BOX)
        self.assertTrue(choice.options[1].reason)
        unknown = self.services['choose_next_pick'](ChooseNextPickRequest(boxes=[detected((123, 77, 50))]))
        self.assertEqual(unknown.status, Choice.UNKNOWN_BOX)

    def test_who_watches_sees_the_last_decision(self):
        self.start()
        choice = self.choose('flat', 'big', request_id='seen')
        self.services['close_pallet']()
        self.assertEqual(self.choose('big').status, Choice.NO_PALLET)  # says nothing of boxes
        decision = Latest('pick_planner/last_decision', PickDecision).wait_for(lambda m: True, 10.0)  # latched
        self.assertIsNotNone(decision)
        self.assertEqual((decision.request_id, decision.decision_id, decision.chosen_index, decision.options, decision.message),
                         ('seen', choice.decision_id, choice.chosen_index, choice.options, choice.message))

    def test_ambiguous_box(self):
        self.start(lines=[('a', (300, 200, 100), 1), ('b', (306, 200, 100), 1)])
        answer = self.services['choose_next_pick'](ChooseNextPickRequest(boxes=[detected((303, 200, 100), 3.0)]))
        self.assertEqual(answer.status, Choice.AMBIGUOUS_BOX)
        self.assertEqual(answer.options[0].status, PickOption.AMBIGUOUS_BOX)

    def test_bad_choices(self):
        self.start()
        nan = float('nan')
        for name, request in {
                'nothing available': ChooseNextPickRequest(),
                'boxes and types': ChooseNextPickRequest(boxes=[detected((300, 400, 200))], type_ids=['big']),
                'NaN size': ChooseNextPickRequest(boxes=[detected((nan, nan, nan))]),
                'negative size': ChooseNextPickRequest(boxes=[detected((-300, -400, 200))]),
                'NaN budget': ChooseNextPickRequest(type_ids=['big'], time_budget=nan),
                'negative budget': ChooseNextPickRequest(type_ids=['big'], time_budget=-1.0),
                'ten thousand': ChooseNextPickRequest(type_ids=['flat'] * 10000),
        }.items():
            revision = self.state().state.revision
            answer = self.services['choose_next_pick'](request)
            self.assertIn(answer.status, (Choice.BAD_REQUEST, Choice.UNKNOWN_BOX), name)
            self.assertTrue(answer.message, name)
            self.assertEqual(answer.chosen_index, -1, name)
            self.assertEqual(self.state().state.revision, revision, name)
        self.assertEqual(self.choose('none such').status, Choice.UNKNOWN_BOX)
        surplus = self.choose('big', 'big')
        self.assertEqual(surplus.status, Choice.PICK)
        self.assertEqual(surplus.options[1].status, PickOption.UNKNOWN_BOX, 'the order has one of these')

    def test_reports(self):
        self.start()
        self.assertEqual(self.report(987654).status, Report.UNKNOWN_DECISION)
        choice = self.choose('big')
        self.assertEqual(self.report(choice.decision_id, 77).status, Report.BAD_REQUEST)
        failed = self.report(choice.decision_id, ReportPickRequest.FAILED)
        self.assertEqual(failed.status, Report.OK)
        self.assertEqual(len(self.state().state.placements), 0)
        choice = self.choose('big')
        self.assertEqual(self.report(choice.decision_id, ReportPickRequest.DISCARDED).status, Report.OK)
        self.assertEqual(list(self.state().state.discarded), [1, 0])
        self.assertEqual(self.report(choice.decision_id).status, Report.CONFLICT)

    def test_two_executives(self):
        self.start()
        mine, yours = self.choose('big', request_id='mine'), self.choose('flat', request_id='yours')
        self.assertNotEqual(mine.decision_id, yours.decision_id)
        self.assertEqual(self.report(mine.decision_id).status, Report.OK)
        revision = self.state().state.revision
        late = self.report(yours.decision_id)
        self.assertEqual((late.status, late.revision), (Report.UNKNOWN_DECISION, revision))
        self.assertIn('out of date', late.message)
        self.assertEqual(len(self.state().state.placements), 1)
        statuses = []
        choice = self.choose('flat')
        threads = [threading.Thread(target=lambda: statuses.append(self.report(choice.decision_id).status))
                   for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(statuses, [Report.OK] * 4)
        self.assertEqual(len(self.state().state.placements), 2)

    def test_measured_pose(self):
        self.start()
        choice = self.choose('flat')
        pose = Pose(position=Point(5.0, 5.0, 0.05), orientation=choice.placement.pose.orientation)
        refused = self.report(choice.decision_id, has_actual_pose=True, actual_pose=pose)
        self.assertEqual(refused.status, Report.INVALID_PLACEMENT)
        self.assertTrue(refused.message)
        self.assertEqual(len(self.state().state.placements), 0)
        pose.position = Point(choice.placement.pose.position.x, choice.placement.pose.position.y,
                              choice.placement.pose.position.z)
        self.assertEqual(self.report(choice.decision_id, has_actual_pose=True, actual_pose=pose).status, Report.OK)

    def test_nothing_fits(self):
        self.start(lines=[('full', (600, 400, 150), 1), ('tall', (300, 400, 100), 2)])
        choice = self.choose('full')
        self.report(choice.decision_id)
        none = self.choose('tall', 'tall')
        self.assertEqual(none.status, Choice.NONE_FITS)
        self.assertTrue(all(option.reason for option in none.options))
        self.assertEqual(self.report(none.decision_id, ReportPickRequest.DISCARDED).status, Report.OK)
        self.assertEqual(self.choose('tall').status, Choice.ORDER_COMPLETE)
        self.assertEqual(self.services['close_pallet']().summary.discarded, 2)

    def test_undo(self):
        self.start()
        self.assertEqual(self.services['undo_last']().status, UndoLastResponse.NOTHING_TO_UNDO)
        self.report(self.choose('big').decision_id)
        self.assertEqual(len(self.state().state.placements), 1)
        self.assertEqual(self.services['undo_last']().status, UndoLastResponse.OK)
        state = self.state().state
        self.assertEqual((len(state.placements), list(state.remaining)), (0, [1, 2]))

    def test_plan_whole_order(self):
        client = actionlib.SimpleActionClient('pick_planner/plan_pallet', PlanPalletAction)
        self.assertTrue(client.wait_for_server(rospy.Duration(20.0)))
        goal = PlanPalletGoal(size=Vector3(0.6, 0.4, 0.2), order=[order_line(*line) for line in LINES], time_budget=5.0)
        client.send_goal_and_wait(goal, rospy.Duration(30.0))
        result = client.get_result()
        self.assertEqual(result.status, PlanPalletResult.OK, result.message)
        self.assertAlmostEqual(result.utilization, 1.0)
        self.assertEqual(len(result.placements), 3)
        goal.order = []
        client.send_goal_and_wait(goal, rospy.Duration(30.0))
        self.assertEqual(client.get_result().status, PlanPalletResult.NO_PALLET)

    def test_plan_is_preempted_with_its_best(self):
        client = actionlib.SimpleActionClient('pick_planner/plan_pallet', PlanPalletAction)
        self.assertTrue(client.wait_for_server(rospy.Duration(20.0)))
        # More than the pallet holds, so that the search does not end by itself.
        lines = [('a%d' % i, (197 + 3 * i, 161 + 5 * i, 143 + 7 * i), 5) for i in range(8)]
        reports, arrived = [], threading.Event()
        client.send_goal(PlanPalletGoal(size=Vector3(0.6, 0.4, 0.6), order=[order_line(*line) for line in lines],
                                        time_budget=60.0),
                         feedback_cb=lambda f: (reports.append(f), arrived.set()))
        self.assertTrue(arrived.wait(20.0), 'no feedback')
        client.cancel_goal()
        self.assertTrue(client.wait_for_result(rospy.Duration(10.0)))
        result = client.get_result()
        self.assertEqual(result.status, PlanPalletResult.OK)
        self.assertGreater(len(result.placements), 0)
        self.assertGreaterEqual(result.utilization, reports[0].best_utilization - 1e-9)


if __name__ == '__main__':
    rospy.init_node('test_planner')
    rostest.rosrun('mixed_palletizing', 'planner', Planner, sys.argv)
