#!/usr/bin/env python3
"""The short form of test/torture/kill_cell.py: each process of a working cell is killed once."""
import os
import subprocess
import sys
import unittest

import rospy
import rostest

TORTURE = os.path.join(os.path.dirname(os.path.realpath(__file__)), '..', 'torture', 'kill_cell.py')


class KillCell(unittest.TestCase):
    def test_nothing_acknowledged_is_lost(self):
        run = subprocess.run([sys.executable, TORTURE, '--kills', '5', '--seed', '2'], stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, universal_newlines=True, timeout=360)
        self.assertEqual(run.returncode, 0, run.stdout)
        self.assertIn('5 kills', run.stdout)


if __name__ == '__main__':
    rospy.init_node('test_kill_cell')
    rostest.rosrun('mixed_palletizing', 'kill_cell', KillCell, sys.argv)
