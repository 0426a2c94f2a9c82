#!/usr/bin/env python3
"""Clocks that jump, stand still or never start, bags in a loop, a camera that hangs, and transforms that are missing, late,
stale, wrong or of another parent: every call is answered in time with boxes or a named reason, and the next good one with
boxes. Parameters: ~rounds, ~seed, ~table."""
import os
import random
import signal
import sys
import tempfile
import threading
import time
import unittest

import rospy
import rostest
from geometry_msgs.msg import PointStamped
from mixed_palletizing.msg import BoxArray, PlanPalletActionGoal, PlanPalletActionResult
from mixed_palletizing.srv import (Calibrate, CalibrateRequest, ChooseNextPick, ChooseNextPickRequest, DetectBoxes,
                                   DetectBoxesRequest, DetectBoxesResponse, StartPallet, TakeBox)
from sensor_msgs.msg import PointCloud2

from bad_clouds import replaced
from bad_transforms import BASE, CAMERA, NO_FRAME, OK, BadTransforms
from cell_client import Latest, answer_to_cloud, capture
from counts import Counts
from planner_client import start_request
from processes import pid_of
from simulated_time import LoopedBag, SimulatedClock, Transforms

HOUR_S = 3600.0
TIMEOUT_S = 3.0   # of a call of `detect`
PATIENCE_S = 8.0  # beyond the time a call may take: longer is a hang
BUDGET_S = 0.3


class TimeAndTf(BadTransforms, unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.counts = Counts('clock jumps or stands still, bad transforms, bag in a loop, camera hangs')
        cls.clock = SimulatedClock()
        cls.points = rospy.Publisher('test/points', PointCloud2, queue_size=1)
        cls.goals = rospy.Publisher('pick_planner/plan_pallet/goal', PlanPalletActionGoal, queue_size=1)
        cls.results = Latest('pick_planner/plan_pallet/result', PlanPalletActionResult)
        for name, service, kind in [('detect', 'box_detector/detect', DetectBoxes),
                                    ('detect_calibrated', 'calibrated/detect', DetectBoxes),
                                    ('calibrate', 'calibrated/calibrate', Calibrate),
                                    ('take', 'zivid_camera/take_box', TakeBox),
                                    ('start', 'pick_planner/start_pallet', StartPallet),
                                    ('choose', 'pick_planner/choose_next_pick', ChooseNextPick)]:
            rospy.wait_for_service(service, 30.0)
            setattr(cls, name, staticmethod(rospy.ServiceProxy(service, kind)))
        cls.start(start_request())
        cls.before_the_first_tick()
        cls.clock.run()
        cls.cloud = capture()
        cls.tf = Transforms(BASE, CAMERA, cls.pose)

    @classmethod
    def before_the_first_tick(cls):
        """Time is zero: the nodes have come up, calibrate and decide."""
        answer = cls.calibrate(CalibrateRequest(cloud_count=1, timeout=20.0))
        assert answer.success, answer.message
        cls.pose = answer.pose.pose
        assert cls.choose(ChooseNextPickRequest(type_ids=['big'])).decision_id > 0

    @classmethod
    def tearDownClass(cls):
        cls.counts.write(rospy.get_param('~table', ''))

    def timed(self, call, longest_s):
        start = time.monotonic()
        answer = call()
        self.assertLess(time.monotonic() - start, longest_s + PATIENCE_S, 'a hang')
        return answer

    def boxes_of(self, stamp, frame=CAMERA):
        """Answer of the detector that asks tf."""
        cloud = replaced(self.cloud)
        cloud.header.stamp, cloud.header.frame_id = stamp, frame
        if abs((stamp - self.clock.now()).to_sec()) > 1.0:  # an older answer may serve the stamp, a later cloud is none
            call = lambda: self.detect(DetectBoxesRequest(timeout=TIMEOUT_S))
            return self.timed(lambda: answer_to_cloud(call, self.points, cloud), TIMEOUT_S)
        self.points.publish(cloud)
        return self.timed(lambda: self.detect(DetectBoxesRequest(timeout=TIMEOUT_S, not_before=stamp)), TIMEOUT_S)

    def check_good(self, after):
        start = time.monotonic()
        now = self.clock.now()
        self.tf.send(now)
        answer = self.boxes_of(now)
        self.assertEqual(answer.status, OK, f'after {after}: {answer.message}')
        self.assertTrue(answer.boxes.boxes, f'after {after}')
        self.counts.recovery_s.append(time.monotonic() - start)

    def jump(self, seconds):
        def check():
            before = self.clock.now()
            self.clock.jump(seconds)
            self.check_decision()
            self.check_calibrated()
            answer = self.boxes_of(self.clock.now())
            self.assertIn(answer.status, (OK, NO_FRAME), answer.message)
            self.assertNotEqual(answer.boxes.header.stamp, before)
        return check

    def jump_while_deciding(self, seconds):
        def check():
            timer = threading.Timer(BUDGET_S / 3, lambda: self.clock.jump(seconds))
            timer.start()
            self.check_decision()
            timer.join()
        return check

    def old_cloud_after_the_clock_went_back(self):
        """The cloud from before has a later stamp than all that is asked for: it is no answer."""
        self.check_good('nothing')
        self.clock.jump(-HOUR_S)
        answer = self.timed(lambda: self.detect(DetectBoxesRequest(timeout=0.5, not_before=self.clock.now())), 0.5)
        self.assertEqual(answer.status, DetectBoxesResponse.TIMEOUT, answer.message)

    def stands_still(self):
        self.clock.pause()
        try:
            self.check_standing()
        finally:
            self.clock.run()

    def check_standing(self):
        self.check_decision()
        self.check_calibrated()
        self.check_no_frame(self.clock.now(), 'never heard of')
        self.clock.jump(0.1)  # two clouds of one stamp cannot be told apart
        self.check_good('a standing clock')
        point = PointStamped()
        point.header.frame_id = 'never heard of'
        taken = self.timed(lambda: self.take(point, False), 0.5)
        self.assertFalse(taken.success)
        self.assertIn('never heard of', taken.message)
        self.check_plan()

    def looped_bag(self):
        self.clock.pause()
        self.clock.be_quiet()
        try:
            self.check_loops()
        finally:
            self.clock.run()

    def check_loops(self):
        came = []
        listener = rospy.Subscriber('boxes', BoxArray, came.append)
        with tempfile.TemporaryDirectory() as folder, LoopedBag(
                os.path.join(folder, 'loop.bag'), self.clock.now(), self.cloud, '/test/points', self.tf):
            loops = lambda: sum(1 for a, b in zip(came, came[1:]) if b.header.stamp < a.header.stamp)
            end = time.monotonic() + 10 * PATIENCE_S
            while loops() < 3:
                self.assertLess(time.monotonic(), end, 'the detector does not follow the bag')
                time.sleep(0.05)
        listener.unregister()
        self.assertTrue(all(message.boxes for message in came))

    def camera_hangs(self):
        """More calls than the detector has threads for them."""
        camera = pid_of('/zivid_camera/camera')
        os.kill(camera, signal.SIGSTOP)
        try:
            for _ in range(5):
                answer = self.timed(lambda: self.detect_calibrated(DetectBoxesRequest(timeout=0.2)), 0.2)
                self.assertEqual(answer.status, DetectBoxesResponse.TIMEOUT, answer.message)
                self.assertIn('capture_service /zivid_camera/capture does not answer', answer.message)
        finally:
            os.kill(camera, signal.SIGCONT)
        self.check_calibrated()

    def check_decision(self):
        answer = self.timed(lambda: self.choose(ChooseNextPickRequest(type_ids=['big', 'flat'], time_budget=BUDGET_S)),
                            BUDGET_S)
        self.assertEqual(answer.status, 0, answer.message)
        self.assertLess(answer.decision_ms, 1000.0 * (BUDGET_S + PATIENCE_S))

    def check_plan(self):
        goal = PlanPalletActionGoal()
        goal.goal_id.id = 'plan %d' % self.results.count()
        goal.goal.time_budget = BUDGET_S
        self.goals.publish(goal)
        self.assertIsNotNone(self.results.wait_for(lambda m: m.status.goal_id.id == goal.goal_id.id,
                                                   BUDGET_S + PATIENCE_S), 'plan_pallet hangs')

    def check_calibrated(self):
        """A capture on request; its stamp is of now."""
        now = self.clock.now()
        answer = self.timed(lambda: self.detect_calibrated(DetectBoxesRequest(timeout=TIMEOUT_S, not_before=now)), TIMEOUT_S)
        self.assertEqual(answer.status, OK, answer.message)
        self.assertTrue(answer.boxes.boxes)
        self.assertLess(abs((answer.boxes.header.stamp - now).to_sec()), HOUR_S / 2)

    def situations(self):
        return {
            **self.bad_transforms(),
            'an hour forward': self.jump(HOUR_S), 'an hour back': self.jump(-HOUR_S),
            'forward while deciding': self.jump_while_deciding(HOUR_S),
            'back while deciding': self.jump_while_deciding(-HOUR_S),
            'old cloud after the clock went back': self.old_cloud_after_the_clock_went_back,
            'clock stands still': self.stands_still, 'looped bag': self.looped_bag, 'camera hangs': self.camera_hangs}

    def test_situations(self):
        rng = random.Random(rospy.get_param('~seed', 1))
        for _ in range(rospy.get_param('~rounds', 1)):
            situations = list(self.situations().items())
            rng.shuffle(situations)
            for name, check in situations:
                with self.counts.attempt(name):
                    check()
                    self.check_good(name)
        self.assertEqual(self.counts.lost, [])


if __name__ == '__main__':
    rospy.init_node('test_time_and_tf')
    rostest.rosrun('mixed_palletizing', 'time_and_tf', TimeAndTf, sys.argv)
