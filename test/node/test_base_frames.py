#!/usr/bin/env python3
"""Where the detector's base frame comes from: calibrated, restored, read from a file, asked from tf; names and namespaces."""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

import rospy
import rostest
import tf2_ros
from geometry_msgs.msg import TransformStamped
from mixed_palletizing.msg import BoxArray
from mixed_palletizing.srv import (Calibrate, CalibrateRequest, CalibrateResponse, DetectBoxes, DetectBoxesRequest,
                                   DetectBoxesResponse)
from std_srvs.srv import Empty
from tf2_msgs.msg import TFMessage

from cell_client import Latest, truth

CAMERA = 'zivid_optical_frame'


class DetectorNode:
    """A detector of its own, for as long as the `with` lasts."""

    def __init__(self, name, *arguments, capture=True):
        self.name = name
        words = ['rosrun', 'mixed_palletizing', 'box_detector_node', '__name:=' + name.split('/')[-1],
                 '__ns:=/' + '/'.join(name.split('/')[:-1]), 'points:=/zivid_camera/points/xyzrgba', *arguments]
        if capture:
            words.append('_capture_service:=/zivid_camera/capture')
        self.process = subprocess.Popen(words)

    def __enter__(self):
        rospy.wait_for_service(self.name + '/detect', 30.0)
        self.calibrate = rospy.ServiceProxy(self.name + '/calibrate', Calibrate)
        self.detect = rospy.ServiceProxy(self.name + '/detect', DetectBoxes)
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait(30)


class BaseFrames(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.file = os.path.join(self.folder, 'kept', 'calibration.yaml')
        self.truth = truth()

    def tearDown(self):
        shutil.rmtree(self.folder)

    def expect_all_boxes(self, answer):
        self.assertEqual(answer.status, DetectBoxesResponse.OK, answer.message)
        self.assertEqual(len(answer.boxes.boxes), len(self.truth.boxes))

    def calibrated(self, name):
        with DetectorNode(name, '_calibration_file:=' + self.file) as node:
            answer = node.calibrate(CalibrateRequest(cloud_count=1))
            self.assertEqual(answer.status, CalibrateResponse.OK, answer.message)
            self.expect_all_boxes(node.detect(DetectBoxesRequest()))
            return answer

    def test_calibration_is_kept_and_restored(self):
        self.calibrated('first')
        transforms = Latest('/tf_static', TFMessage)
        with DetectorNode('second', '_calibration_file:=' + self.file, '_tf_direction:=base_to_camera') as node:
            self.expect_all_boxes(node.detect(DetectBoxesRequest()))
            base_is_parent = transforms.wait_for(lambda m: any(
                t.header.frame_id == 'aruco_base' and t.child_frame_id == CAMERA for t in m.transforms), 10.0)
            self.assertIsNotNone(base_is_parent)

    def test_damaged_file_means_not_calibrated(self):
        os.makedirs(os.path.dirname(self.file))
        with open(self.file, 'w') as file:
            file.write('base_from_camera: [1, 2')
        with DetectorNode('damaged', '_calibration_file:=' + self.file) as node:
            self.assertEqual(node.detect(DetectBoxesRequest()).status, DetectBoxesResponse.NOT_CALIBRATED)

    def test_given_file(self):
        run = subprocess.run(['rosrun', 'mixed_palletizing', 'box_detector_node', '__name:=nothing', '_base_source:=file',
                              '_calibration_file:=' + self.file], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                             universal_newlines=True, timeout=60)
        self.assertNotEqual(run.returncode, 0)
        self.assertIn(self.file, run.stdout)
        self.calibrated('maker')
        with DetectorNode('reader', '_base_source:=file', '_calibration_file:=' + self.file) as node:
            self.expect_all_boxes(node.detect(DetectBoxesRequest()))
            self.assertEqual(node.calibrate(CalibrateRequest()).status, CalibrateResponse.NOT_APPLICABLE)

    def test_from_tf(self):
        pose = self.calibrated('surveyor').pose.pose
        with DetectorNode('follower', '_base_source:=tf', '_base_frame:=cell', '_tf_timeout_s:=2.0') as node:
            answer = node.detect(DetectBoxesRequest())
            self.assertEqual(answer.status, DetectBoxesResponse.NOT_CALIBRATED)
            self.assertIn('no_transform', answer.message)
            transform = TransformStamped()
            transform.header.frame_id, transform.child_frame_id = 'cell', CAMERA
            transform.header.stamp = rospy.Time.now()
            transform.transform.translation = pose.position
            transform.transform.rotation = pose.orientation
            broadcaster = tf2_ros.StaticTransformBroadcaster()
            broadcaster.sendTransform(transform)
            answer = node.detect(DetectBoxesRequest())
            self.expect_all_boxes(answer)
            self.assertEqual(answer.boxes.header.frame_id, 'cell')

    def test_client_that_triggers_the_camera_itself(self):
        self.calibrated('before')
        capture = rospy.ServiceProxy('/zivid_camera/capture', Empty)
        with DetectorNode('patient', '_calibration_file:=' + self.file, capture=False) as node:
            for _ in range(10):  # the camera publishes nothing before it sees the new subscriber
                before = rospy.Time.now()
                capture()
                answer = node.detect(DetectBoxesRequest(not_before=before, timeout=3.0))
                if answer.status == DetectBoxesResponse.OK:
                    break
            self.expect_all_boxes(answer)
            self.assertGreaterEqual(answer.boxes.header.stamp, before)
            self.assertEqual(node.detect(DetectBoxesRequest(timeout=1.0)).status, DetectBoxesResponse.TIMEOUT)

    def test_in_a_namespace_calibrated_by_the_first_cloud(self):
        boxes = Latest('/left/boxes', BoxArray)
        with DetectorNode('left/detector', '_base_source:=floor', '_calibrate_on_start:=true', '_calibration_clouds:=1',
                          '_base_frame:=left_base', capture=False):
            self.assertTrue(boxes.connected())
            message = None
            for _ in range(10):  # as above
                rospy.ServiceProxy('/zivid_camera/capture', Empty)()
                message = message or boxes.wait_for(lambda m: True, 3.0)
            self.assertIsNotNone(message)
            self.assertEqual(message.header.frame_id, 'left_base')
            self.assertEqual(len(message.boxes), len(self.truth.boxes))


if __name__ == '__main__':
    rospy.init_node('test_base_frames')
    rostest.rosrun('mixed_palletizing', 'base_frames', BaseFrames, sys.argv)
