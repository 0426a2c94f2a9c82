#!/usr/bin/env python3
"""The master dies and another one comes: the nodes notice, say so, end, and do not work on with defaults."""
import sys

import rospy
import rostest

from lost_master import LostMaster


class MasterDies(LostMaster):
    def test_nodes_end_when_a_new_master_comes(self):
        self.check_they_end(['pick_planner', 'box_detector_node', 'pallet_reporter'])

    def test_a_launched_node_does_not_work_with_defaults(self):
        for node in ('pick_planner', 'box_detector_node'):
            self.start(node, '_launched:=true')
            self.assertEqual(self.processes[node].wait(30), 1, self.said(node))
            self.assertIn('its parameters are gone', self.said(node))
        self.start('pick_planner', '_launched:=true', '_journal/file:=none')
        self.wait_until(lambda: self.master.knows('/pick_planner'), 'does not start')
        self.wait_until(lambda: 'choose_next_pick' in self.services(), 'does not start: ' + self.said('pick_planner'))


if __name__ == '__main__':
    rospy.init_node('test_master')
    rostest.rosrun('mixed_palletizing', 'master', MasterDies, sys.argv)
