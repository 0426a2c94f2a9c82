#!/usr/bin/env python3
"""The short form of test/torture/kill_cell.py: processes of a working cell are killed."""
import os
import subprocess
import sys
import unittest

import rospy
import rostest

TORTURE = os.path.join(os.path.dirname(os.path.realpath(__file__)), '..', 'torture', 'kill_cell.py')


class KillCell(unittest.TestCase):
    def test_nothing_acknowledged_is_lost(self):
        run = subprocess.run([sys.executable, TORTURE, '--kills', '4', '--seed', '2'], stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, universal_newlines=True, timeout=360)
        self.assertEqual(run.returncode, 0, run.stdout)
        self.assertIn('4 kills', run.stdout)


if __name__ == '__main__':
    rospy.init_node('test_kill_cell')
    rostest.rosrun('mixed_palletizing', 'kill_cell', KillCell, sys.argv)
