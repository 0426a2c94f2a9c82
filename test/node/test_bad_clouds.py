#!/usr/bin/env python3
"""Every bad cloud through the nodelet that shares its manager with the camera: refused for the right reason, and the next
good cloud answered as if nothing had been. Parameter ~layouts: the layouts to try; ~table: a file for the counts."""
import sys
import time
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from mixed_palletizing.srv import Calibrate, CalibrateRequest, DetectBoxes, DetectBoxesRequest, DetectBoxesResponse
from sensor_msgs.msg import PointCloud2

import bad_clouds
from cell_client import Latest, answer_to_cloud, capture
from counts import Counts


class BadClouds(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.diagnostics = Latest('/diagnostics', DiagnosticArray)
        cls.points = rospy.Publisher('test/points', PointCloud2, queue_size=5)
        cls.cloud = capture()
        for service in ('calibrate', 'detect'):
            rospy.wait_for_service('box_detector/' + service, 30.0)
        cls.detect = rospy.ServiceProxy('box_detector/detect', DetectBoxes)
        while cls.points.get_num_connections() == 0:
            rospy.sleep(0.05)
        calibrate = rospy.ServiceProxy('box_detector/calibrate', Calibrate)
        answer = answer_to_cloud(lambda: calibrate(CalibrateRequest(cloud_count=1, timeout=20.0)), cls.points, cls.cloud)
        assert answer.success, answer.message
        cls.counts = Counts('bad or odd cloud, then a good one')

    def answer_to(self, cloud):
        return answer_to_cloud(lambda: self.detect(DetectBoxesRequest(timeout=20.0)), self.points, cloud)

    def check_good(self, cloud, expected, after):
        start = time.monotonic()
        answer = self.answer_to(cloud)
        self.counts.recovery_s.append(time.monotonic() - start)
        self.assertEqual(answer.status, DetectBoxesResponse.OK, f'after {after}: {answer.message}')
        self.assertEqual(answer.boxes.boxes, expected, f'other boxes after {after}')

    def check_bad(self, name, reason, cloud):
        answer = self.answer_to(cloud)
        self.assertEqual(answer.status, DetectBoxesResponse.BAD_CLOUD, f'{name}: {answer.message}')
        self.assertIn(reason + ':', answer.message, name)

    def try_layout(self, layout):
        good = bad_clouds.with_layout(self.cloud, layout)
        expected = self.answer_to(good).boxes.boxes
        self.assertTrue(expected, layout)
        reasons = set()
        for faults in (bad_clouds.faults_of_layout, bad_clouds.faults_of_fields, bad_clouds.faults_of_content):
            for name, reason, cloud in faults(good):
                self.counts.tried += 1
                with self.subTest(layout=layout, cloud=name):
                    self.check_bad(name, reason, cloud)
                    self.check_good(good, expected, name)
                    reasons.add(reason)
                    self.counts.survived += 1
        for name, cloud in bad_clouds.odd_clouds(good):
            self.counts.tried += 1
            with self.subTest(layout=layout, cloud=name):
                answer = self.answer_to(cloud)
                self.assertIn(answer.status, (DetectBoxesResponse.OK, DetectBoxesResponse.NOT_CALIBRATED),
                              f'{name}: {answer.message}')
                self.check_good(good, expected, name)
                self.counts.survived += 1
        return reasons

    def test_bad_clouds(self):
        self.assertTrue(self.answer_to(self.cloud).boxes.boxes)
        reasons = set()
        for layout in rospy.get_param('~layouts', list(bad_clouds.LAYOUTS)):
            reasons |= self.try_layout(layout)
        named = lambda m: reasons <= {v.key[len('dropped: '):] for s in m.status for v in s.values
                                      if v.key.startswith('dropped: ')}
        self.assertIsNotNone(self.diagnostics.wait_for(named, 10.0), f'not all of {reasons} are in /diagnostics')

    @classmethod
    def tearDownClass(cls):
        cls.counts.write(rospy.get_param('~table', ''), with_p99=False)


if __name__ == '__main__':
    rospy.init_node('test_bad_clouds')
    rostest.rosrun('mixed_palletizing', 'bad_clouds', BadClouds, sys.argv)
