#!/usr/bin/env python3
"""The example executive, run as a user runs it, against the simulated cell."""
import subprocess
import sys
import unittest

import rospy
import rostest
from geometry_msgs.msg import Vector3
from mixed_palletizing.srv import ChooseNextPick, ChooseNextPickRequest, StartPallet

from planner_client import start_request


def example(*parameters):
    return subprocess.run(['rosrun', 'mixed_palletizing', 'simple_executive.py', *parameters], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, universal_newlines=True, timeout=200)


class Example(unittest.TestCase):
    def test_goes_on_with_the_order_and_packs_it(self):
        """Another executive ended in the middle of its first pick."""
        order = '_order:=' + rospy.get_param('~order')
        rospy.wait_for_service('pick_planner/choose_next_pick', 30.0)
        lines = [('a', (600, 400, 300), 2), ('b', (300, 400, 200), 3)]
        started = rospy.ServiceProxy('pick_planner/start_pallet', StartPallet)(
            start_request('small', lines, size=Vector3(1.2, 0.8, 0.3)))
        self.assertEqual(started.status, 0, started.message)
        rospy.ServiceProxy('pick_planner/choose_next_pick', ChooseNextPick)(ChooseNextPickRequest(type_ids=['a']))
        run = example(order)
        self.assertEqual(run.returncode, 1, run.stdout)
        self.assertIn('_pending:=placed or _pending:=failed', run.stdout)
        run = example(order, '_pending:=failed')
        self.assertEqual(run.returncode, 0, run.stdout)
        self.assertIn('placed 5, discarded 0', run.stdout)

    def test_says_what_is_wrong_with_the_order(self):
        for parameters, words in [(['_order:=/nowhere.jsonl'], '/nowhere.jsonl'),
                                  (['_order:=' + rospy.get_param('~order'), '_index:=7'], 'no index 7')]:
            run = example(*parameters)
            self.assertEqual(run.returncode, 1, run.stdout)
            self.assertIn(words, run.stdout)


if __name__ == '__main__':
    rospy.init_node('test_example')
    rostest.rosrun('mixed_palletizing', 'example', Example, sys.argv)
