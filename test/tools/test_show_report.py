#!/usr/bin/env python3
"""show_report.py tells complete orders from others, and says of every bad file what is wrong in one line."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCRIPT = ROOT / 'scripts' / 'lib' / 'show_report.py'
TIMES = {'count': 2, 'median': 1.0, 'p99': 2.0, 'max': 2.0}
REPORT = {
    'pallet_id': 'p', 'complete': True, 'message': '',
    'order': {'name': 'o', 'pallet_mm': [1200, 800, 600],
              'items': [{'type': 'a', 'size_mm': [300, 200, 100], 'count': 3}]},
    'placed': 1, 'discarded': 2, 'utilization': 0.5,
    'times_ms': {'capture': TIMES, 'detection': TIMES, 'decision': TIMES},
    'size_error_mm': {'mean': [0, 0, 0], 'max': [1.04, 0.5, 0.2]},
    'picks': [{'type': 'a'}],
    'discards': [{'type': 'a', 'reason': 'no room'}, {'type': None, 'reason': 'dented'}],
}


class ShowReport(unittest.TestCase):
    def show(self, text):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / 'report.json'
            if text is not None:
                path.write_text(text, encoding='utf-8')
            return subprocess.run([sys.executable, str(SCRIPT), str(path)], capture_output=True, text=True, check=False)

    def test_complete(self):
        shown = self.show(json.dumps(REPORT))
        self.assertEqual((shown.returncode, shown.stderr), (0, ''))
        for expected in ('o: 3 boxes of 1 types', '1, discarded 2, utilization 50.0 %', '1 x a: no room',
                         '1 x not identified: dented', 'at most 1.0, 0.5, 0.2 mm off'):
            self.assertIn(expected, shown.stdout)
        self.assertEqual(shown.stdout.splitlines()[-1], 'complete')

    def test_not_complete(self):
        shown = self.show(json.dumps({**REPORT, 'complete': False, 'message': 'no cloud', 'picks': []}))
        self.assertEqual(shown.returncode, 1)
        self.assertEqual(shown.stdout.splitlines()[-1], 'NOT COMPLETE: no cloud')
        self.assertEqual(self.show(json.dumps({**REPORT, 'complete': 'yes'})).returncode, 1)

    def test_bad_files(self):
        without_times = {key: value for key, value in REPORT.items() if key != 'times_ms'}
        for text in (None, '', '{"complete": true', '[]', '{}', 'null', json.dumps(without_times),
                     json.dumps({**REPORT, 'order': 3}), json.dumps({**REPORT, 'utilization': 'all'}),
                     json.dumps({**REPORT, 'discards': [None]})):
            shown = self.show(text)
            self.assertEqual((shown.returncode, shown.stdout), (1, ''), text)
            self.assertEqual(len(shown.stderr.splitlines()), 1, shown.stderr)

    def test_usage(self):
        shown = subprocess.run([sys.executable, str(SCRIPT)], capture_output=True, text=True, check=False)
        self.assertEqual(shown.returncode, 2)
        self.assertIn('usage:', shown.stdout)


if __name__ == '__main__':
    unittest.main()
