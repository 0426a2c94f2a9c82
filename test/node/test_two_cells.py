#!/usr/bin/env python3
"""Two cells side by side on one master: each packs its own order and keeps its own frames."""
import subprocess
import sys
import unittest

import rospy
import rostest
from mixed_palletizing.msg import BoxArray, PalletState

from cell_client import Latest

CELLS = ('left', 'right')


class TwoCells(unittest.TestCase):
    def test_both_pack_at_the_same_time(self):
        boxes = {cell: Latest(cell + '/boxes', BoxArray) for cell in CELLS}
        pallets = {cell: Latest(cell + '/pick_planner/pallet_state', PalletState) for cell in CELLS}
        runs = {cell: subprocess.Popen(['rosrun', 'mixed_palletizing', 'simple_executive.py', '__ns:=' + cell,
                                        '_order:=' + rospy.get_param('~order')], stdout=subprocess.PIPE,
                                       stderr=subprocess.STDOUT, universal_newlines=True) for cell in CELLS}
        for cell, run in runs.items():
            output = run.communicate(timeout=240)[0]
            self.assertEqual(run.returncode, 0, cell + ': ' + output)
            self.assertIn('placed 5, discarded 0', output)
        for cell in CELLS:
            seen = boxes[cell].wait_for(lambda m: m.boxes, 5.0)
            self.assertIsNotNone(seen, cell)
            self.assertEqual(seen.header.frame_id, cell + '_aruco_base')
            state = pallets[cell].wait_for(lambda m: m.placements, 5.0)
            self.assertIsNotNone(state, cell)
            self.assertEqual(state.header.frame_id, cell + '_pallet')


if __name__ == '__main__':
    rospy.init_node('test_two_cells')
    rostest.rosrun('mixed_palletizing', 'two_cells', TwoCells, sys.argv)
