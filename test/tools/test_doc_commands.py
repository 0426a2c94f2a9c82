#!/usr/bin/env python3
"""Executes the commands of the documents, so that they cannot rot; the package's setup.bash is sourced.

Blocks that begin with ```sh runnable are run by bash in a scratch folder, the blocks of one document one after the other; those that
begin with ```sh runnable cell need a cell: a simulated one is started for them, for each document on a master of its own. Every
command must succeed, and every service must answer that it did. Of all others at least the options must exist."""
import os
import pathlib
import re
import signal
import socket
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
DOCUMENTS = [ROOT / 'README.md', *sorted((ROOT / 'docs').glob('*.md'))]
BLOCK = re.compile(r'^ *```sh runnable( cell)?\n(.*?)^ *```', re.S | re.M)
COMMANDS_S = 300
CELL = ['roslaunch', '--wait', str(ROOT / 'launch' / 'simulated_cell.launch'), 'journal:=none', 'reports:=none', 'width_px:=960',
        'height_px:=600']
READY = ('timeout 120 bash -c "for s in /zivid_camera/capture /box_detector/detect /pick_planner/close_pallet; do '
         'until rosservice info \\$s >/dev/null 2>&1; do sleep 0.5; done; done" || { tail -n 30 log; exit 1; }\n')


def blocks(document, cell):
    """Commands of a document as one script; empty when it has none."""
    return ''.join(text for kind, text in BLOCK.findall(document.read_text(encoding='utf-8')) if bool(kind) == cell)


def free_port():
    with socket.socket() as probe:
        probe.bind(('127.0.0.1', 0))
        return probe.getsockname()[1]


class Commands(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = scratch.name
        self.environment = dict(os.environ, ROS_HOME=os.path.join(self.folder, 'ros'), ROS_IP='127.0.0.1',
                                ROS_MASTER_URI=f'http://127.0.0.1:{free_port()}')

    def background(self, command):
        log = open(os.path.join(self.folder, 'log'), 'ab')
        process = subprocess.Popen(command, cwd=self.folder, env=self.environment, stdout=log, stderr=log, start_new_session=True)

        def end():
            os.killpg(process.pid, signal.SIGINT)
            try:
                process.wait(30)
            except subprocess.TimeoutExpired:
                os.killpg(process.pid, signal.SIGKILL)
                process.wait()
            log.close()
        self.addCleanup(end)

    def execute(self, document, script):
        done = subprocess.run(['bash', '-exo', 'pipefail', '-c', script], cwd=self.folder, env=self.environment, timeout=COMMANDS_S,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)
        shown = f'{document.name}:\n{done.stdout[-3000:]}'
        self.assertEqual(done.returncode, 0, shown)
        self.assertIsNone(re.search(r'^status: [1-9]|^success: False', done.stdout, re.M), shown)

    def test_without_a_cell(self):
        count = 0
        for document in DOCUMENTS:
            script = blocks(document, cell=False)
            if script:
                count += 1
                self.execute(document, script)
        self.assertGreater(count, 1)

    def test_options_exist(self):
        """Also of commands that are not executed here, for they would take hours or need a camera."""
        used = {}
        for document in DOCUMENTS:
            text = document.read_text(encoding='utf-8').replace('\\\n', ' ')
            for tool, words in re.findall(r'(?:rosrun mixed_palletizing |`)(\w+)((?: +[^\s`|;&#]+)*)', text):
                options = {word.split('=')[0] for word in words.split() if word.startswith('--')}
                if options and not tool.startswith('ros'):
                    used.setdefault(tool, set()).update((option, document.name) for option in options)
        self.assertGreater(len(used), 8, sorted(used))
        for tool, options in sorted(used.items()):
            shown = subprocess.run(['rosrun', 'mixed_palletizing', tool, '--help'], env=self.environment, timeout=60,
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True).stdout
            for option, document in sorted(options):
                self.assertRegex(shown, re.escape(option) + r'\b', f'{document}: {tool} {option}')

    def in_a_cell(self, name):
        document = ROOT / 'docs' / name
        script = blocks(document, cell=True)
        self.assertTrue(script, 'nothing to run')
        self.background(['roscore', '-p', self.environment['ROS_MASTER_URI'].rsplit(':', 1)[1]])
        self.background(CELL)
        self.execute(document, READY)
        self.execute(document, script)

    def test_quick_start(self):
        self.in_a_cell('quick_start.md')

    def test_attach_camera(self):
        self.in_a_cell('attach_camera.md')

    def test_attach_robot(self):
        self.in_a_cell('attach_robot.md')

    def test_tuning(self):
        self.in_a_cell('tuning.md')

    def test_no_other_document_needs_a_cell(self):
        names = {document.stem for document in DOCUMENTS if blocks(document, cell=True)}
        self.assertEqual({name for name in names if not hasattr(self, f'test_{name}')}, set())


if __name__ == '__main__':
    unittest.main()
