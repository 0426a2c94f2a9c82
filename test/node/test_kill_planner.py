#!/usr/bin/env python3
"""The short form of test/torture/kill_planner.py: the planner is killed while an executive works with it."""
import os
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), '..', 'torture'))

import rospy  # noqa: E402
import rostest  # noqa: E402
from killed_planner import Killings  # noqa: E402

KILLS = 20
SEED = 2


class KillPlanner(unittest.TestCase):
    def test_nothing_acknowledged_is_lost(self):
        with tempfile.TemporaryDirectory() as folder, open(os.path.join(folder, 'log'), 'w') as log:
            killings = Killings(os.path.join(folder, 'p.journal'), log, SEED)
            killings.run(KILLS)  # raises at the first loss
        self.assertEqual(killings.tried, KILLS)
        self.assertGreater(killings.steps, KILLS)


if __name__ == '__main__':
    rospy.init_node('test_kill_planner')
    rostest.rosrun('mixed_palletizing', 'kill_planner', KillPlanner, sys.argv)
