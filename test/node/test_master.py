#!/usr/bin/env python3
"""The master dies and another one comes: the nodes notice, say so, end, and do not work on with defaults."""
import os
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
import xmlrpc.client

import rospy
import rostest

NODES = {'pick_planner': ['_journal/file:=none'], 'box_detector_node': [], 'pallet_reporter': []}


class Master:
    """Another master than the test's own."""

    def __init__(self, port):
        self.uri = 'http://localhost:%d' % port
        self._process = subprocess.Popen([sys.executable, shutil.which('rosmaster'), '--core', '-p', str(port)],
                                         stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def knows(self, node):
        try:
            return xmlrpc.client.ServerProxy(self.uri).lookupNode('/test_master', node)[0] == 1
        except OSError:
            return False

    def kill(self):
        self._process.kill()
        self._process.wait()


class MasterDies(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.processes = {}
        self.port = 1024 + os.getpid() % 30000
        self.master = Master(self.port)

    def tearDown(self):
        for process in self.processes.values():
            process.kill()
            process.wait()
        self.master.kill()
        self.folder.cleanup()

    def log(self, node):
        return os.path.join(self.folder.name, node)

    def said(self, node):
        with open(self.log(node), encoding='utf-8') as file:
            return file.read()

    def start(self, node, *arguments):
        with open(self.log(node), 'w', encoding='utf-8') as log:
            self.processes[node] = subprocess.Popen(
                ['rosrun', 'mixed_palletizing', node, '__name:=' + node, *arguments], stdout=log, stderr=log,
                env={**os.environ, 'ROS_MASTER_URI': self.master.uri, 'ROS_HOME': self.folder.name})

    def wait_until(self, condition, what, timeout_s=30.0):
        end = time.monotonic() + timeout_s
        while not condition():
            self.assertLess(time.monotonic(), end, what)
            time.sleep(0.05)

    def test_nodes_end_when_a_new_master_comes(self):
        for node, arguments in NODES.items():
            self.start(node, *arguments)
        for node in NODES:
            self.wait_until(lambda: self.master.knows('/' + node), node + ' does not start')
        time.sleep(2.0)
        self.master.kill()
        for node in NODES:
            self.wait_until(lambda: 'does not answer' in self.said(node), node + ' does not notice')
            self.assertIsNone(self.processes[node].poll(), node + ' ended: ' + self.said(node))
        self.master = Master(self.port)
        for node in NODES:
            self.assertEqual(self.processes[node].wait(30), 1, self.said(node))
            self.assertIn('was started anew', self.said(node))

    def test_a_launched_node_does_not_work_with_defaults(self):
        for node in ('pick_planner', 'box_detector_node'):
            self.start(node, '_launched:=true')
            self.assertEqual(self.processes[node].wait(30), 1, self.said(node))
            self.assertIn('its parameters are gone', self.said(node))
        self.start('pick_planner', '_launched:=true', '_journal/file:=none')
        self.wait_until(lambda: self.master.knows('/pick_planner'), 'does not start')
        self.wait_until(lambda: 'choose_next_pick' in self.services(), 'does not start: ' + self.said('pick_planner'))

    def services(self):
        state = xmlrpc.client.ServerProxy(self.master.uri).getSystemState('/test_master')[2]
        return ' '.join(name for name, _ in state[2])


if __name__ == '__main__':
    rospy.init_node('test_master')
    rostest.rosrun('mixed_palletizing', 'master', MasterDies, sys.argv)
