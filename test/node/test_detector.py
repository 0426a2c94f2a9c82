#!/usr/bin/env python3
"""The detector through its topics and services: calibration, boxes against the truth, labels, tf."""
import math
import sys
import threading
import unittest

import numpy
import rospy
import rostest
import tf2_ros
from mixed_palletizing.msg import BoxArray
from mixed_palletizing.srv import (Calibrate, CalibrateRequest, CalibrateResponse, DetectBoxes, DetectBoxesRequest,
                                   DetectBoxesResponse)
from sensor_msgs.msg import Image, PointCloud2
from visualization_msgs.msg import Marker, MarkerArray

from bad_clouds import replaced, set_all, with_points
from cell_client import Latest, capture, truth


def yaw(box):
    q = box.pose.pose.orientation
    return 2.0 * math.atan2(q.z, q.w)


class Detector(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.boxes = Latest('boxes', BoxArray)
        cls.markers = Latest('markers', MarkerArray)
        cls.labels = Latest('labels', Image)
        cls.points = rospy.Publisher('test/points', PointCloud2, queue_size=5)
        cls.cloud = capture()
        cls.truth = truth()
        cls.stamp = rospy.Time.now()
        for service in ('calibrate', 'detect'):
            rospy.wait_for_service('box_detector/' + service, 30.0)
        cls.calibrate = rospy.ServiceProxy('box_detector/calibrate', Calibrate)
        cls.detect = rospy.ServiceProxy('box_detector/detect', DetectBoxes)
        assert cls.boxes.connected() and cls.labels.connected() and cls.markers.connected()
        while cls.points.get_num_connections() == 0:
            rospy.sleep(0.05)

    def publish(self, cloud):
        """Publishes under a new stamp and returns it."""
        type(self).stamp += rospy.Duration(1.0)
        cloud = replaced(cloud)
        cloud.header.stamp = self.stamp
        self.points.publish(cloud)
        return self.stamp

    def call_while_publishing(self, service, request, cloud):
        """Answer of a service that waits for clouds."""
        answers = []
        caller = threading.Thread(target=lambda: answers.append(service(request)))
        caller.start()
        rospy.sleep(0.5)
        while caller.is_alive():
            self.publish(cloud)
            caller.join(4.0)  # a cloud is under way no longer than that
        rospy.sleep(1.0)
        return answers[0]

    def answer_to(self, cloud, timeout_s=20.0):
        stamp = self.publish(cloud)
        return self.boxes.wait_for(lambda m: m.header.stamp == stamp, timeout_s)

    def test_1_before_calibration(self):
        self.assertEqual(self.detect(DetectBoxesRequest(timeout=1.0)).status, DetectBoxesResponse.NOT_CALIBRATED)
        self.assertEqual(self.calibrate(CalibrateRequest(timeout=-1.0)).status, CalibrateResponse.BAD_REQUEST)
        answer = self.calibrate(CalibrateRequest(cloud_count=1, timeout=1.0))
        self.assertEqual(answer.status, CalibrateResponse.TIMEOUT)
        self.assertFalse(answer.success)
        self.assertIsNone(self.answer_to(self.cloud, 2.0), 'boxes without a base frame')

    def test_2_no_marker(self):
        def grey(points):
            points.view(numpy.uint32)[:, :, 3] = 0xff808080
        answer = self.call_while_publishing(self.calibrate, CalibrateRequest(cloud_count=1, timeout=20.0),
                                            with_points(self.cloud, grey))
        self.assertEqual(answer.status, CalibrateResponse.NO_FRAME)
        self.assertFalse(answer.success)
        self.assertIn('marker', answer.message)

    def test_3_calibrate(self):
        answer = self.call_while_publishing(self.calibrate, CalibrateRequest(cloud_count=2, timeout=20.0), self.cloud)
        self.assertEqual(answer.status, CalibrateResponse.OK, answer.message)
        self.assertTrue(answer.success)
        self.assertEqual(list(answer.marker_ids), [0])
        self.assertEqual(len(answer.marker_corners), 4)
        self.assertEqual(answer.clouds_used, 2)
        self.assertGreater(answer.plane_inliers, 100000)
        self.assertLess(answer.plane_rms, 0.005)
        buffer = tf2_ros.Buffer()
        listener = tf2_ros.TransformListener(buffer)
        found = buffer.lookup_transform('aruco_base', self.cloud.header.frame_id, rospy.Time(0), rospy.Duration(10.0))
        for axis in 'xyz':
            self.assertAlmostEqual(getattr(found.transform.translation, axis), getattr(answer.pose.pose.position, axis),
                                   places=6)
        self.assertGreater(found.transform.translation.z, 1.0)
        listener.unregister()

    def check_boxes(self, message):
        self.assertEqual(message.header.frame_id, 'aruco_base')
        self.assertEqual(len(message.boxes), len(self.truth.boxes))
        for true in self.truth.boxes:
            box = min(message.boxes, key=lambda b: math.hypot(b.pose.pose.position.x - true.pose.pose.position.x,
                                                              b.pose.pose.position.y - true.pose.pose.position.y))
            for axis in 'xyz':
                self.assertAlmostEqual(getattr(box.pose.pose.position, axis), getattr(true.pose.pose.position, axis),
                                       delta=0.005)
                self.assertAlmostEqual(getattr(box.size, axis), getattr(true.size, axis), delta=0.006)
                self.assertGreater(getattr(box.size_stddev, axis), 0.0)
            self.assertAlmostEqual(math.sin(yaw(box) - yaw(true)), 0.0, delta=math.radians(1.0))

    def test_4_boxes_labels_markers(self):
        message = self.answer_to(self.cloud)
        self.assertIsNotNone(message)
        self.check_boxes(message)
        self.assertGreater(message.processing_ms, 0.0)
        labels = self.labels.wait_for(lambda m: m.header.stamp == message.header.stamp, 10.0)
        self.assertEqual((labels.width, labels.height, labels.encoding), (self.cloud.width, self.cloud.height, '16UC1'))
        values = numpy.frombuffer(labels.data, dtype=numpy.uint16)
        counts = numpy.bincount(values)
        self.assertEqual(len(counts), len(message.boxes) + 1)
        for box in message.boxes:
            self.assertEqual(counts[box.id + 1], box.point_count)
        markers = self.markers.wait_for(lambda m: len(m.markers) > len(message.boxes), 10.0)
        self.assertEqual(markers.markers[0].action, Marker.DELETEALL)
        for marker in markers.markers[1:]:
            q = marker.pose.orientation
            self.assertAlmostEqual(q.x ** 2 + q.y ** 2 + q.z ** 2 + q.w ** 2, 1.0, places=3)

    def test_5_detect_service(self):
        answer = self.call_while_publishing(self.detect, DetectBoxesRequest(timeout=20.0), self.cloud)
        self.assertEqual(answer.status, DetectBoxesResponse.OK, answer.message)
        self.check_boxes(answer.boxes)
        self.assertEqual(self.detect(DetectBoxesRequest(timeout=1.0)).status, DetectBoxesResponse.TIMEOUT)
        self.assertEqual(self.detect(DetectBoxesRequest(timeout=float('nan'))).status, DetectBoxesResponse.BAD_REQUEST)
        bad = self.call_while_publishing(self.detect, DetectBoxesRequest(timeout=20.0),
                                         with_points(self.cloud, set_all(numpy.nan)))
        self.assertEqual(bad.status, DetectBoxesResponse.BAD_CLOUD)


if __name__ == '__main__':
    rospy.init_node('test_detector')
    rostest.rosrun('mixed_palletizing', 'detector', Detector, sys.argv)
