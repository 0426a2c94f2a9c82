#!/usr/bin/env python3
"""Whole runs as a user starts them: wrong parameters, a bag replayed, the simulated cell to its end."""
import glob
import io
import json
import math
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

import rospy
import rostest
import yaml
from mixed_palletizing.msg import BoxArray
from visualization_msgs.msg import MarkerArray

from cell_client import Latest

SMALL_ORDER = {'name': 'small', 'pallet_mm': [1200, 800, 300], 'n_pick': 3,
               'items': [{'type': 'a', 'size_mm': [600, 400, 300], 'count': 2, 'rotations': 'none'},
                         {'type': 'b', 'size_mm': [300, 400, 200], 'count': 3, 'rotations': 'none'}]}


def rosrun(*words, **options):
    return subprocess.run(['rosrun', 'mixed_palletizing', *words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          universal_newlines=True, timeout=120, **options)


def roslaunch(*words):
    return subprocess.Popen(['roslaunch', '--no-summary', 'mixed_palletizing', *words])


class Runs(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()

    def tearDown(self):
        shutil.rmtree(self.folder)

    def path(self, name):
        return os.path.join(self.folder, name)

    def test_wrong_parameters_stop_the_start(self):
        for node, wrong in [('box_detector_node', ['base_sorce:=floor', 'detection/cluster/min_points:=-3']),
                            ('pick_planner', ['planner/n_cots:=4', 'time_budget_s:=-1.0']),
                            ('cell_executive', ['sede:=1', 'move_s:=-1.0'])]:
            run = rosrun(node, *('_' + w for w in wrong))
            self.assertNotEqual(run.returncode, 0, run.stdout)
            for word in wrong:  # the whole list at once
                self.assertIn(word.split(':=')[0].split('/')[-1], run.stdout)

    def test_dumped_parameters_load_again(self):
        config = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))), 'config')
        for node, file, service, more in (('box_detector_node', 'box_detector.yaml', '/detect', []),
                                          ('pick_planner', 'pick_planner.yaml', '/choose_next_pick', ['_journal/file:=none'])):
            space, dump = '/dumped_' + node, self.path(file)
            for command in (['load', os.path.join(config, file)], ['dump', dump], ['delete'], ['load', dump]):
                subprocess.run(['rosparam', command[0], *command[1:], space], check=True, timeout=30)
            with open(os.path.join(config, file)) as shipped:
                self.assertEqual(rospy.get_param(space), yaml.safe_load(shipped))
            process = subprocess.Popen(['rosrun', 'mixed_palletizing', node, '__name:=' + space[1:], *more])
            try:
                rospy.wait_for_service(space + service, 30.0)
            finally:
                process.terminate()
                process.wait(30)

    def replay(self, bag, *arguments, timeout_s=90.0):
        boxes, markers = Latest('boxes', BoxArray), Latest('markers', MarkerArray)
        launch = roslaunch('replay.launch', 'bag:=' + bag, *arguments)
        try:
            self.assertEqual(launch.wait(timeout_s), 0)
        finally:
            launch.terminate()
            launch.wait(30)
        message = boxes.wait_for(lambda m: True, 5.0)
        self.assertIsNotNone(message, 'the replay gave no BoxArray')
        self.assertIsNotNone(markers.wait_for(lambda m: len(m.markers) > 1, 5.0), 'no marker')
        return message

    def test_replay_of_a_simulated_scene(self):
        share = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
        scene = os.path.join(share, 'config', 'scenes', 'three_boxes.yaml')
        run = rosrun('simulate_scene', '--scene', scene, '--out', self.path('c.pcd'), '--truth', self.path('t.json'))
        self.assertEqual(run.returncode, 0, run.stdout)
        run = rosrun('pcd_to_bag', '--clouds', self.path('c.pcd'), '--out', self.path('c.bag'), '--repeat', '2')
        self.assertEqual(run.returncode, 0, run.stdout)
        message = self.replay(self.path('c.bag'))
        with open(self.path('t.json')) as file:
            truth = json.load(file)['boxes']
        self.assertEqual(len(message.boxes), len(truth))
        for true in truth:
            nearest = min(math.hypot(b.pose.pose.position.x - true['center'][0],
                                     b.pose.pose.position.y - true['center'][1]) for b in message.boxes)
            self.assertLess(nearest, 0.005)

    def replayed_boxes(self, bag, rate):
        """Every BoxArray of a replay by its stamp, as bytes without the time that the detection took."""
        boxes = Latest('boxes', BoxArray)
        launch = roslaunch('replay.launch', 'bag:=' + bag, 'rate:=%g' % rate)
        try:
            self.assertEqual(launch.wait(120), 0)
        finally:
            launch.terminate()
            launch.wait(30)
        found = {}
        for message in boxes.all():
            message.processing_ms = 0.0
            message.header.seq = 0  # counted by the publisher
            data = io.BytesIO()
            message.serialize(data)
            found[message.header.stamp.to_nsec()] = (data.getvalue(), message)
        return found

    def test_replays_are_the_same_at_any_rate(self):
        share = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
        with open(os.path.join(share, 'config', 'scenes', 'three_boxes.yaml')) as file:
            scene = yaml.safe_load(file)
        scene['camera'].update(width_px=960, height_px=600)
        with open(self.path('scene.yaml'), 'w') as file:
            yaml.safe_dump(scene, file)
        clouds = []
        for seed in range(1, 6):
            clouds.append(self.path('%d.pcd' % seed))
            run = rosrun('simulate_scene', '--scene', self.path('scene.yaml'), '--out', clouds[-1], '--truth', self.path('t.json'),
                         '--seed', str(seed))
            self.assertEqual(run.returncode, 0, run.stdout)
        bag = self.path('c.bag')
        run = rosrun('pcd_to_bag', '--clouds', *clouds, '--out', bag)
        self.assertEqual(run.returncode, 0, run.stdout)

        slow, fast = self.replayed_boxes(bag, 1), self.replayed_boxes(bag, 50)
        self.assertEqual(len(slow), 5)
        self.assertEqual({stamp: data for stamp, (data, _) in slow.items()}, {stamp: data for stamp, (data, _) in fast.items()})

        # The same as in process, without a clock.
        run = rosrun('bag_regression', '--bag', bag, '--golden', self.path('golden.json'), '--update')
        self.assertEqual(run.returncode, 0, run.stdout)
        with open(self.path('golden.json')) as file:
            golden = json.load(file)
        self.assertEqual([cloud['stamp_ns'] for cloud in golden['clouds']], sorted(slow))
        for cloud in golden['clouds']:
            message = slow[cloud['stamp_ns']][1]
            self.assertEqual(len(message.boxes), len(cloud['boxes']))
            for box, expected in zip(message.boxes, cloud['boxes']):
                for axis, value, side in zip('xyz', expected['center'], expected['size']):
                    self.assertAlmostEqual(getattr(box.pose.pose.position, axis), value, delta=1e-9)
                    self.assertAlmostEqual(getattr(box.size, axis), side, delta=1e-9)

    def test_replay_of_a_recorded_carton(self):
        data = os.environ.get('MIXED_PALLETIZING_DATA', '')
        recorded = glob.glob(os.path.join(data, 'real', 'fau1.pcd')) if data else []
        if not recorded:
            self.skipTest('no recorded data: MIXED_PALLETIZING_DATA is not set')
        run = rosrun('pcd_to_bag', '--clouds', recorded[0], '--out', self.path('c.bag'), '--repeat', '2')
        self.assertEqual(run.returncode, 0, run.stdout)
        message = self.replay(self.path('c.bag'), 'base:=floor')
        self.assertEqual(len(message.boxes), 1)
        for side, length in zip(('x', 'y', 'z'), (0.448, 0.355, 0.187)):
            self.assertAlmostEqual(getattr(message.boxes[0].size, side), length, delta=0.015)

    def test_demo_to_its_end(self):
        with open(self.path('order.jsonl'), 'w') as file:
            file.write(json.dumps(SMALL_ORDER) + '\n')
        launch = roslaunch('demo.launch', 'rviz:=false', 'instances:=' + self.path('order.jsonl'),
                           'report:=' + self.path('report.json'), 'move_s:=0.0', 'width_px:=960', 'height_px:=600')
        try:
            launch.wait(240)
        finally:
            launch.terminate()
            launch.wait(30)
        with open(self.path('report.json')) as file:
            report = json.load(file)
        self.assertIs(report['complete'], True, report.get('message'))
        self.assertEqual(report['placed'] + report['discarded'], 5)
        self.assertEqual(report['discarded'], 0)
        self.assertGreater(report['utilization'], 0.5)
        with open(self.path('report.html')) as file:
            self.assertIn('Complete: every box of the order was placed.', file.read())


if __name__ == '__main__':
    rospy.init_node('test_runs')
    rostest.rosrun('mixed_palletizing', 'runs', Runs, sys.argv)
