#!/usr/bin/env python3
"""The master dies and another one comes: the converters notice, say so, and end."""
import sys

import rospy
import rostest

from lost_master import LostMaster


class MasterOfConvertersDies(LostMaster):
    def test_nodes_end_when_a_new_master_comes(self):
        self.check_they_end(['boxes_to_vision_msgs', 'boxes_to_jsk', 'pallet_to_moveit'])


if __name__ == '__main__':
    rospy.init_node('test_converters_master')
    rostest.rosrun('mixed_palletizing', 'master_of_converters', MasterOfConvertersDies, sys.argv)
