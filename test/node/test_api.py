#!/usr/bin/env python3
"""docs/ros_api.md names every topic and service of the running nodes, with its type, and none that is not there."""
import pathlib
import re
import sys
import unittest

import rosgraph
import rospy
import rosservice
import rostest

DOCUMENT = pathlib.Path(__file__).resolve().parents[2] / 'docs' / 'ros_api.md'
NODES = {'Detector': '/box_detector', 'Planner': '/pick_planner'}
LEFT_OUT = re.compile(r'/rosout$|/clock$|/tf$|/tf_static$|.*/(get_loggers|set_logger_level)$')
ACTION = {'goal': 'in', 'cancel': 'in', 'status': 'out', 'feedback': 'out', 'result': 'out'}
OURS = 'mixed_palletizing/'
TIMEOUT_S = 30.0


def full(name, node):
    return node + '/' + name[1:] if name.startswith('~') else '/' + name.lstrip('/')


def documented(title):
    """{(in, out or srv, full name): type or '' when the document gives none} of the table below a title."""
    section = DOCUMENT.read_text(encoding='utf-8').split('\n## %s\n' % title)[1].split('\n## ')[0]
    found = {}
    for kinds, names, kind_of_message in re.findall(r'^\| (in|out|srv|action|srv, out) \| ([^|]+) \| ([^|]*)\|', section, re.M):
        words = kind_of_message.replace(',', ' ').split()
        message = words[0] if words and words[0] != 'dynamic_reconfigure' else ''
        if message and '/' not in message:
            message = OURS + message
        for name in re.findall(r'`([^`]+)`', names):
            name = full(name, NODES[title])
            if kinds == 'action':
                found.update({(kind, '%s/%s' % (name, part)): '' for part, kind in ACTION.items()})
            elif kinds == 'srv, out':
                found['srv' if name.endswith('set_parameters') else 'out', name] = message
            else:
                found[kinds, name] = message
    return {key: message for key, message in found.items() if not LEFT_OUT.match(key[1])}


def running(node):
    publishers, subscribers, services = rosgraph.Master(rospy.get_name()).getSystemState()
    return {(kind, name) for kind, names in (('out', publishers), ('in', subscribers), ('srv', services))
            for name, nodes in names if node in nodes and not LEFT_OUT.match(name)}


class Api(unittest.TestCase):
    def compare(self, title):
        node, expected = NODES[title], documented(title)
        self.assertGreater(len(expected), 9)
        for kind, name in expected:
            if kind == 'srv':
                rospy.wait_for_service(name, TIMEOUT_S)
        there = running(node)
        self.assertEqual(there - set(expected), set(), 'not in the document')
        self.assertEqual(set(expected) - there, set(), 'in the document only')
        types = dict(rosgraph.Master(rospy.get_name()).getTopicTypes())
        for (kind, name), message in expected.items():
            if message:
                self.assertEqual(rosservice.get_service_type(name) if kind == 'srv' else types[name], message, name)

    def test_detector(self):
        self.compare('Detector')

    def test_planner(self):
        self.compare('Planner')

    def test_others(self):
        text = DOCUMENT.read_text(encoding='utf-8')
        for node in ('/pallet_reporter', '/zivid_camera/cell_simulator'):
            for name in ('/zivid_camera/capture', '/zivid_camera/take_box'):
                rospy.wait_for_service(name, TIMEOUT_S)
            there = running(node)
            self.assertTrue(there, node)
            for _, name in there:
                name = re.sub(r'^/(zivid_camera/|pick_planner/)?', '', name)
                self.assertTrue('`%s`' % name in text or '`~%s`' % name in text, name)


if __name__ == '__main__':
    rospy.init_node('test_api')
    rostest.rosrun('mixed_palletizing', 'api', Api, sys.argv)
