#!/usr/bin/env python3
"""Runs run_experiments as a user does, with one scene a row; the package's setup.bash is sourced."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM = pathlib.Path(__file__).resolve().parents[2] / 'experiments' / 'run_experiments'


def run(*arguments, **environment):
    return subprocess.run([sys.executable, str(PROGRAM), *map(str, arguments)], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, universal_newlines=True,
                          env=dict(os.environ, PYTHONDONTWRITEBYTECODE='1', **environment))


class RunExperiments(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.out = pathlib.Path(scratch.name) / 'new' / 'folder'

    def one_line(self, done, pattern):
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertRegex(done.stderr, '^run_experiments: ' + pattern)
        self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)

    def report(self, done, name):
        self.assertEqual(done.returncode, 0, done.stderr)
        text = (self.out / name).read_text(encoding='utf-8')
        self.assertIn(str(self.out / name), done.stdout)
        self.assertEqual(re.findall(r'(?:src|href)="(?!data:)', text), [])
        self.assertNotIn(str(self.out), text, 'paths of this machine')
        return text

    def test_the_detection_table(self):
        done = run('detection', '--out', self.out, '--count', 1, '--only', 'hidden', '--only', 'truncated', '--seed', 3)
        text = self.report(done, 'detection.html')
        self.assertIn('a taller box hides', text)
        self.assertIn('partly outside', text)
        self.assertEqual(text.count('data:image/jpeg'), 2)
        self.assertIn('--seed 3', text)
        self.assertTrue((self.out / 'data' / 'hidden_best.jsonl').is_file())
        self.assertIn('measure_detection', done.stderr)

    def test_the_experiments_of_the_thesis(self):
        done = run('detection', '--thesis', '--out', self.out, '--count', 1, '--quiet')
        text = self.report(done, 'detection_thesis.html')
        for table in ('4.1', '4.2', '4.3', '4.4', '4.5', '4.6', '4.7'):
            self.assertIn(f'Table {table}', text)
        self.assertEqual(done.stderr, '')

    def test_packing_and_planning(self):
        for experiment, table in (('packing', '4.24'), ('planning', 'Table 4.8')):
            done = run(experiment, '--quick', '--count', 1, '--quiet', '--out', self.out, MIXED_PALLETIZING_DATA='')
            text = self.report(done, f'{experiment}.html')
            self.assertIn(table, text)
            self.assertGreaterEqual(text.count('data:image/png') + text.count('<svg '), 7)

    def test_a_part_of_planning(self):
        done = run('planning', '--quick', '--count', 2, '--only', 'rules', '--threads', 2, '--quiet', '--out', self.out)
        text = self.report(done, 'planning.html')
        self.assertIn('Fig. 4.26', text)
        self.assertIn('--threads 2', text)
        self.assertNotIn('Table 4.8', text)
        self.assertNotIn('Rich sets', text)

    def test_mistakes_are_named_in_one_line(self):
        self.one_line(run('detection', '--out', '/dev/null/x'), '/dev/null/x: cannot be written')
        self.one_line(run('detection', '--out', self.out, '--only', 'nothing'), '--only nothing: the rows are')
        self.one_line(run('detection', '--quiet', '--out', self.out, CMAKE_PREFIX_PATH='', PATH='/nowhere'),
                      'tool measure_detection not found')
        broken = self.out.parent.parent / 'matplotlib'
        broken.mkdir()
        (broken / '__init__.py').write_text('raise ImportError("broken here")')
        self.one_line(run('detection', '--out', self.out, PYTHONPATH=str(broken.parent)),
                      'matplotlib cannot be imported .*install python3-matplotlib')
        self.one_line(run('packing', '--out', self.out, '--thesis'), '--thesis belongs to detection')
        self.one_line(run('packing', '--out', self.out, '--only', 'rules'), '--only belongs to detection and planning')
        self.one_line(run('planning', '--out', self.out, '--only', 'nothing'), '--only nothing: planning has steps, rules')
        wrong = run('detection', '--out', self.out, '--count', 0)
        self.assertEqual(wrong.returncode, 2)
        self.assertIn('0 is less than 1', wrong.stderr)


if __name__ == '__main__':
    unittest.main()
