#!/usr/bin/env python3
"""The example executive, run as a user runs it, against the simulated cell."""
import subprocess
import sys
import unittest

import rospy
import rostest


def example(*parameters):
    return subprocess.run(['rosrun', 'mixed_palletizing', 'simple_executive.py', *parameters], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, universal_newlines=True, timeout=200)


class Example(unittest.TestCase):
    def test_packs_the_order(self):
        run = example('_order:=' + rospy.get_param('~order'))
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
