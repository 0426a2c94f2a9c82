"""Nodes whose master dies, and another one comes."""
import os
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
import xmlrpc.client

ARGUMENTS = {'pick_planner': ['_journal/file:=none']}


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


class LostMaster(unittest.TestCase):
    """Its tests start nodes at a master of their own."""

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

    def check_they_end(self, nodes):
        """They notice that the master is away, and end when a new one comes."""
        for node in nodes:
            self.start(node, *ARGUMENTS.get(node, []))
        for node in nodes:
            self.wait_until(lambda: self.master.knows('/' + node), node + ' does not start')
        time.sleep(2.0)
        self.master.kill()
        for node in nodes:
            self.wait_until(lambda: 'does not answer' in self.said(node), node + ' does not notice')
            self.assertIsNone(self.processes[node].poll(), node + ' ended: ' + self.said(node))
        self.master = Master(self.port)
        for node in nodes:
            self.assertEqual(self.processes[node].wait(30), 1, self.said(node))
            self.assertIn('was started anew', self.said(node))

    def services(self):
        state = xmlrpc.client.ServerProxy(self.master.uri).getSystemState('/test_master')[2]
        return ' '.join(name for name, _ in state[2])
