#!/usr/bin/env python3
"""Whatever comes into the planner's services: a status, a message, and an unchanged pallet."""
import math
import random
import sys

import rospy
import rostest
from geometry_msgs.msg import Point, Pose, Quaternion, Vector3
from mixed_palletizing.msg import OrderLine
from mixed_palletizing.srv import (ChooseNextPickRequest as Choose, ChooseNextPickResponse as Choice,
                                   ReportPickRequest as Report, ReportPickResponse as Reported, StartPalletRequest,
                                   StartPalletResponse as Started)

from cell_client import order_line
from planner_client import PlannerClient, detected, start_request

NAN, INF = float('nan'), float('inf')
ABSURD = 1e12  # mm
SEED = 5


def lines(*values):
    return {'lines': [values]}


def bad_starts():
    """(name, fields of StartPallet), each to be refused while another pallet is open and is to be closed."""
    good = ('a', (300, 400, 100), 1)
    for value in (NAN, INF, -INF, 0, -300, ABSURD):
        for axis in range(3):
            size = [300, 400, 100]
            size[axis] = value
            yield 'size %s of axis %d' % (value, axis), lines('a', size, 1)
        yield 'pallet %s' % value, {'size': Vector3(value / 1e3, 0.4, 0.2)}
    yield 'no id', {'pallet_id': ''}
    yield 'no lines', {'lines': []}
    yield 'no count', lines('a', (300, 400, 100), 0)
    yield 'absurd count', lines('a', (300, 400, 100), 4000000000)
    yield 'no name', lines('', (300, 400, 100), 1)
    yield 'name twice', {'lines': [good, good]}
    yield 'rotations', lines('a', (300, 400, 100), 1, 9)
    for value in (NAN, INF, -0.01, 1e9):
        yield 'gap %s' % value, {'gap': value}
    for value in (NAN, INF, -0.5, 1.5):
        yield 'support %s' % value, {'min_support_ratio': value}
    for field in ('weight', 'max_load'):
        for value in (NAN, INF, -1.0):
            line = order_line(*good)
            setattr(line, field, value)
            yield '%s %s' % (field, value), {'order': [line]}
    yield 'knowledge', {'knowledge': 9}
    yield 'forecast of a set', {'expected': [1.0, 1.0]}
    for expected in ([], [1.0], [NAN, 1.0], [-1.0, 1.0], [1e9, 1.0], [1.0, 1.0, 1.0]):
        yield 'forecast %s' % expected, {'knowledge': StartPalletRequest.FORECAST, 'expected': expected}
    yield 'types with counts', {'knowledge': StartPalletRequest.TYPES}


def bad_choices():
    """(name, request, status)"""
    for value in (NAN, INF, -300, 0, ABSURD):
        yield 'size %s' % value, Choose(boxes=[detected((value, value, value))]), None
        yield 'height %s' % value, Choose(boxes=[detected((400, 300, value))]), None
        if value != 0:  # exactly known
            yield 'stddev %s' % value, Choose(boxes=[detected((400, 300, 200), value)]), None
    for value in (NAN, INF, -1.0, 1e9):
        yield 'budget %s' % value, Choose(type_ids=['flat'], time_budget=value), Choice.BAD_REQUEST
    yield 'nothing available', Choose(), Choice.BAD_REQUEST
    yield 'boxes and types', Choose(boxes=[detected((300, 400, 200))], type_ids=['flat']), Choice.BAD_REQUEST
    yield 'too many', Choose(type_ids=['flat'] * 10001), Choice.BAD_REQUEST
    yield 'another size', Choose(boxes=[detected((123, 77, 50))]), Choice.UNKNOWN_BOX
    yield 'no such type', Choose(type_ids=['none such', '']), Choice.UNKNOWN_BOX
    yield 'none left of it', Choose(type_ids=['big']), Choice.UNKNOWN_BOX
    yield 'the same id, another content', Choose(request_id='r', type_ids=['flat', 'flat']), Choice.CONFLICT


def bad_reports(stale, reported, pending):
    """(name, request, status)"""
    yield 'no decision', Report(decision_id=0), Reported.UNKNOWN_DECISION
    yield 'never made', Report(decision_id=2 ** 63), Reported.UNKNOWN_DECISION
    yield 'stale', Report(decision_id=stale), Reported.UNKNOWN_DECISION
    yield 'reported otherwise', Report(decision_id=reported, outcome=Report.DISCARDED), Reported.CONFLICT
    yield 'outcome', Report(decision_id=pending, outcome=77), Reported.BAD_REQUEST
    yield 'discarded, yet placed', Report(decision_id=pending, discarded=[0]), Reported.BAD_REQUEST
    for discarded in ([99], [0, 0], [4294967295]):
        yield 'discarded %s' % discarded, Report(decision_id=pending, outcome=Report.DISCARDED,
                                                 discarded=discarded), Reported.BAD_REQUEST
    upright = Quaternion(w=1.0)
    for value in (NAN, INF, -5.0, 1e9):
        pose = Pose(position=Point(value, 0.2, 0.05), orientation=upright)
        yield 'pose %s' % value, Report(decision_id=pending, has_actual_pose=True,
                                        actual_pose=pose), Reported.INVALID_PLACEMENT
    for quaternion in (Quaternion(), Quaternion(w=NAN), Quaternion(w=INF), Quaternion(z=0.38, w=0.92)):
        pose = Pose(position=Point(0.15, 0.2, 0.05), orientation=quaternion)
        yield 'turn %s' % quaternion.w, Report(decision_id=pending, has_actual_pose=True,
                                               actual_pose=pose), Reported.INVALID_PLACEMENT


class PlannerInput(PlannerClient):
    def same_state(self, before, name):
        after = self.state().state
        self.assertEqual(after, before, name)

    def test_nothing_bad_changes_a_pallet(self):
        """With a box on the pallet, one decision reported, one pending, and an older one stale."""
        self.assertEqual(self.start().status, Started.OK)
        stale = self.choose('flat', request_id='mine').decision_id
        reported = self.choose('big', request_id='yours').decision_id
        self.assertEqual(self.report(reported).status, Reported.OK)
        pending = self.choose('flat', request_id='r').decision_id
        before = self.state().state
        for name, fields in bad_starts():
            fields = dict(fields)
            answer = self.services['start_pallet'](start_request(close_open=True, **fields))
            self.assertEqual(answer.status, Started.BAD_REQUEST, name)
            self.assertTrue(answer.message, name)
            self.same_state(before, name)
        for name, request, status in bad_choices():
            answer = self.services['choose_next_pick'](request)
            allowed = (Choice.BAD_REQUEST, Choice.UNKNOWN_BOX) if status is None else (status,)
            self.assertIn(answer.status, allowed, name)
            self.assertTrue(answer.message, name)
            self.assertEqual((answer.chosen_index, answer.decision_id), (-1, 0), name)
            self.same_state(before, name)
        for name, request, status in bad_reports(stale, reported, pending):
            answer = self.services['report_pick'](request)
            self.assertEqual(answer.status, status, '%s: %s' % (name, answer.message))
            self.assertTrue(answer.message, name)
            self.assertEqual(answer.revision, before.revision, name)
            self.same_state(before, name)
        self.assertEqual(self.report(pending).status, Reported.OK)

    def test_ten_thousand_boxes(self):
        self.start(lines=[('a', (100, 100, 50), 6000), ('b', (150, 100, 50), 6000)])
        answer = self.choose(*['a', 'b'] * 5000, time_budget=0.2)
        self.assertEqual(answer.status, Choice.PICK, answer.message)
        self.assertEqual(len(answer.options), 10000)
        again = self.report(answer.decision_id)
        self.assertEqual(again.status, Reported.OK)

    def test_deviating_poses(self):
        """0 to 50 mm and 0 to 10 degrees off: accepted where it is valid, with the measured place, or told why not."""
        rng = random.Random(SEED)
        accepted = refused = 0
        self.start(size=Vector3(1.2, 0.8, 0.4),
                   order=[OrderLine(type_id='a', size=Vector3(0.3, 0.2, 0.1), count=40, rotations=OrderLine.YAW)])
        for trial in range(60):
            choice = self.choose('a')
            self.assertEqual(choice.status, Choice.PICK, choice.message)
            far, angle = rng.uniform(0.0, 0.05), math.radians(rng.uniform(0.0, 10.0))
            heading = rng.uniform(-math.pi, math.pi)
            position = choice.placement.pose.position
            pose = Pose(position=Point(position.x + far * math.cos(heading), position.y + far * math.sin(heading),
                                       position.z),
                        orientation=Quaternion(z=math.sin(angle / 2), w=math.cos(angle / 2)))
            before = self.state().state
            answer = self.report(choice.decision_id, has_actual_pose=True, actual_pose=pose)
            name = 'seed %d, trial %d: %s' % (SEED, trial, answer.message)
            if answer.status == Reported.OK:
                accepted += 1
                stands = self.state().state.placements[-1].pose.position
                planned = max(abs(pose.position.x - position.x), abs(pose.position.y - position.y)) <= 0.005
                expected = position if planned else pose.position
                self.assertLess(abs(stands.x - expected.x) + abs(stands.y - expected.y), 2.1e-3, name)
                self.assertEqual(self.services['undo_last']().status, Reported.OK, name)
            else:
                refused += 1
                self.assertEqual(answer.status, Reported.INVALID_PLACEMENT, name)
                self.assertTrue(answer.message, name)
                self.assertEqual(self.state().state, before, name)
                self.assertEqual(self.report(choice.decision_id, Report.FAILED).status, Reported.OK, name)
        self.assertGreater(accepted, 0)
        self.assertGreater(refused, 0)


if __name__ == '__main__':
    rospy.init_node('test_planner_input')
    rostest.rosrun('mixed_palletizing', 'planner_input', PlannerInput, sys.argv)
