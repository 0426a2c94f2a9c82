#!/usr/bin/env python3
"""The example executive with a robot whose pallet outlasts it: what was put down stands in the file ~placed."""
import os
import random
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), '..', '..', 'examples'))

import rospy  # noqa: E402
import simple_executive  # noqa: E402

LONGEST_MOVE_S = 0.1


def line(position):
    return '%.4f %.4f %.4f' % (position.x, position.y, position.z)


class RememberedRobot(simple_executive.SimulatedRobot):
    def __init__(self):
        super().__init__()
        self._placed = open(rospy.get_param('~placed'), 'a', encoding='ascii')

    def place(self, header, box, placement):
        placed = super().place(header, box, placement)
        self._move()
        if placed:
            self._placed.write(line(placement.pose.position) + '\n')
            self._placed.flush()  # one write: it is on the pallet, or it is not
        self._move()
        return placed

    @staticmethod
    def _move():
        time.sleep(random.uniform(0.0, LONGEST_MOVE_S))


if __name__ == '__main__':
    simple_executive.main(RememberedRobot)
