#!/usr/bin/env python3
"""The detector through its topics and services: calibration, boxes against the truth, labels, tf, bad clouds."""
import copy
import math
import sys
import threading
import unittest

import numpy
import rospy
import rostest
import tf2_ros
from diagnostic_msgs.msg import DiagnosticArray
from mixed_palletizing.msg import BoxArray
from mixed_palletizing.srv import (Calibrate, CalibrateRequest, CalibrateResponse, DetectBoxes, DetectBoxesRequest,
                                   DetectBoxesResponse)
from sensor_msgs.msg import Image, PointCloud2, PointField
from visualization_msgs.msg import Marker, MarkerArray

from cell_client import Latest, capture, truth


def replaced(cloud, **values):
    """A copy of the cloud with other values; the data is shared unless given."""
    other = copy.copy(cloud)
    other.header = copy.deepcopy(cloud.header)
    other.fields = copy.deepcopy(cloud.fields)
    for name, value in values.items():
        setattr(other, name, value)
    return other


def with_points(cloud, change):
    points = numpy.frombuffer(cloud.data, dtype=numpy.float32).reshape(cloud.height, cloud.width, 4).copy()
    changed = change(points)
    return replaced(cloud, data=(points if changed is None else changed).tobytes())


def set_all(value):
    def change(points):
        points[:, :, :3] = value
    return change


def bad_clouds(cloud):
    """(name, cloud) of clouds that must be dropped."""
    def field(index, **values):
        other = replaced(cloud)
        for name, value in values.items():
            setattr(other.fields[index], name, value)
        return other
    huge = 2 ** 32 - 1
    yield 'unorganized', replaced(cloud, height=1, width=cloud.width * cloud.height,
                                  row_step=cloud.row_step * cloud.height)
    yield 'empty', replaced(cloud, height=0, width=0, row_step=0, data=b'')
    yield 'no fields', replaced(cloud, fields=[])
    yield 'no z', replaced(cloud, fields=[f for f in cloud.fields if f.name != 'z'])
    yield 'x twice', replaced(cloud, fields=list(cloud.fields) + [PointField('x', 0, PointField.FLOAT32, 1)])
    yield 'mistyped x', field(0, datatype=PointField.FLOAT64)
    yield 'count 3', field(0, count=3)
    yield 'offset past the step', field(2, offset=16)
    yield 'short data', replaced(cloud, data=cloud.data[:-4])
    yield 'stale row_step', replaced(cloud, row_step=cloud.row_step - 16)
    yield 'row_step 0', replaced(cloud, row_step=0)
    yield 'point_step 8', replaced(cloud, point_step=8)
    yield 'big endian', replaced(cloud, is_bigendian=True)
    yield 'huge', replaced(cloud, width=huge, height=huge)
    yield 'no frame', with_frame(cloud, '')
    yield 'all NaN', with_points(cloud, set_all(numpy.nan))
    yield 'all infinite', with_points(cloud, set_all(numpy.inf))
    yield 'all zero', with_points(cloud, set_all(0.0))
    yield 'mirrored', with_points(cloud, lambda points: points[:, ::-1])
    yield 'millimetres', with_points(cloud, lambda points: points * numpy.float32([1000, 1000, 1000, 1]))


def with_frame(cloud, frame):
    other = replaced(cloud)
    other.header.frame_id = frame
    return other


def yaw(box):
    q = box.pose.pose.orientation
    return 2.0 * math.atan2(q.z, q.w)


class Detector(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.boxes = Latest('boxes', BoxArray)
        cls.markers = Latest('markers', MarkerArray)
        cls.labels = Latest('labels', Image)
        cls.diagnostics = Latest('/diagnostics', DiagnosticArray)
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

    def test_6_bad_clouds_are_dropped_and_counted(self):
        for name, cloud in bad_clouds(self.cloud):
            stamp = self.publish(cloud)
            good = self.answer_to(self.cloud)
            self.assertIsNotNone(good, 'the good cloud after: ' + name)
            self.assertEqual(len(good.boxes), len(self.truth.boxes), name)
            self.assertIsNone(self.boxes.wait_for(lambda m: m.header.stamp == stamp, 0.0), name)
        counted = self.diagnostics.wait_for(
            lambda m: any('mirrored' in v.key + v.value for s in m.status for v in s.values), 10.0)
        self.assertIsNotNone(counted, 'the reasons are not in /diagnostics')


if __name__ == '__main__':
    rospy.init_node('test_detector')
    rostest.rosrun('mixed_palletizing', 'detector', Detector, sys.argv)
