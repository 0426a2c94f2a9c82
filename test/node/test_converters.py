#!/usr/bin/env python3
"""The converters that cell.launch starts: boxes and pallet as the messages of other packages."""
import sys
import unittest

import rosgraph
import rospy
import rostest
from jsk_recognition_msgs.msg import BoundingBoxArray
from mixed_palletizing.msg import BoxArray
from mixed_palletizing.srv import Calibrate, ChooseNextPick, ClosePallet, DetectBoxes, ReportPick, StartPallet
from moveit_msgs.msg import CollisionObject, PlanningScene
from vision_msgs.msg import Detection3DArray

from cell_client import Latest, order_line, truth
from geometry_msgs.msg import Vector3

TIMEOUT_S = 30.0


def call(name, kind, **fields):
    rospy.wait_for_service(name, TIMEOUT_S)
    return rospy.ServiceProxy(name, kind)(**fields)


def listeners(topic):
    subscribers = rosgraph.Master(rospy.get_name()).getSystemState()[1]
    return {node for name, nodes in subscribers if name == rospy.resolve_name(topic) for node in nodes}


class Converters(unittest.TestCase):
    def test_boxes(self):
        there = len(truth(TIMEOUT_S).boxes)
        self.assertGreater(there, 0)
        self.assertTrue(call('box_detector/calibrate', Calibrate, cloud_count=1, timeout=TIMEOUT_S).success)
        self.assertEqual(listeners('boxes'), set(), 'the detector works for nobody')

        boxes, detections, boundings = (Latest('boxes', BoxArray), Latest('detections', Detection3DArray),
                                        Latest('bounding_boxes', BoundingBoxArray))
        for topic in (boxes, detections, boundings):
            self.assertTrue(topic.connected(), topic)
        end = rospy.Time.now() + rospy.Duration(TIMEOUT_S)
        while not {'/boxes_to_vision_msgs', '/boxes_to_jsk'} <= listeners('boxes') and rospy.Time.now() < end:
            rospy.sleep(0.05)
        rospy.sleep(0.5)  # registered is not yet connected
        self.assertTrue(call('box_detector/detect', DetectBoxes, timeout=TIMEOUT_S).success)

        seen = boxes.wait_for(lambda m: True, TIMEOUT_S)
        self.assertEqual(len(seen.boxes), there)
        same = lambda m: m.header.stamp == seen.header.stamp
        vision, jsk = detections.wait_for(same, TIMEOUT_S), boundings.wait_for(same, TIMEOUT_S)
        self.assertIsNotNone(vision)
        self.assertIsNotNone(jsk)
        self.assertEqual((vision.header.frame_id, jsk.header.frame_id), (seen.header.frame_id,) * 2)
        self.assertEqual(len(vision.detections), there)
        self.assertEqual(len(jsk.boxes), there)
        for box, detection, bounding in zip(seen.boxes, vision.detections, jsk.boxes):
            self.assertEqual((detection.bbox.center, detection.bbox.size), (box.pose.pose, box.size))
            self.assertEqual(detection.results[0].pose, box.pose)
            self.assertEqual((bounding.pose, bounding.dimensions, bounding.label), (box.pose.pose, box.size, box.id))

    def test_pallet(self):
        scenes = Latest('planning_scene', PlanningScene)
        started = call('pick_planner/start_pallet', StartPallet, pallet_id='scene', size=Vector3(1.2, 0.8, 0.6),
                       order=[order_line('a', (300, 200, 100), 2)])
        self.assertEqual(started.status, 0, started.message)
        pick = call('pick_planner/choose_next_pick', ChooseNextPick, type_ids=['a'])
        placed = call('pick_planner/report_pick', ReportPick, decision_id=pick.decision_id)
        self.assertEqual(placed.status, 0, placed.message)

        ids = lambda scene: [thing.id for thing in scene.world.collision_objects]
        whole = scenes.wait_for(lambda m: ids(m) == ['pallet_carrier', 'pallet_box_1'], TIMEOUT_S)
        self.assertIsNotNone(whole, [ids(m) for m in scenes.all()])
        self.assertTrue(whole.is_diff and whole.robot_state.is_diff)
        box = whole.world.collision_objects[1]
        self.assertEqual((box.header.frame_id, box.type.key, box.operation), ('pallet', 'a', CollisionObject.ADD))
        for side, metres in zip(sorted(box.primitives[0].dimensions), (0.1, 0.2, 0.3)):
            self.assertAlmostEqual(side, metres, delta=1e-6)
        # Who comes later hears the latched message: the whole pallet.
        self.assertIsNotNone(Latest('planning_scene', PlanningScene).wait_for(lambda m: ids(m) == ids(whole), TIMEOUT_S))

        self.assertEqual(call('pick_planner/close_pallet', ClosePallet).status, 0)
        gone = scenes.wait_for(lambda m: any(t.operation == CollisionObject.REMOVE for t in m.world.collision_objects), TIMEOUT_S)
        self.assertIsNotNone(gone)
        self.assertEqual(sorted(ids(gone)), ['pallet_box_1', 'pallet_carrier'])


if __name__ == '__main__':
    rospy.init_node('test_converters')
    rostest.rosrun('mixed_palletizing', 'converters', Converters, sys.argv)
