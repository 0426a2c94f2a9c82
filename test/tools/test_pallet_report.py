#!/usr/bin/env python3
"""Reports of pallets: what the drawings promise, every kind of file, and one line for every bad one."""
import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = ROOT / 'experiments' / 'pallet_report'
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / 'experiments'))

from mp_experiments import pallet_balance, pallet_drawings, pallet_history, pallet_page, pallet_record  # noqa: E402
from mp_experiments import pallet_sources  # noqa: E402

INSTANCE = {'name': 'o', 'pallet_mm': [1200, 800, 600], 'arrival': ['a', 'b<c>', 'a', 'b<c>'], 'n_pick': 2,
            'items': [{'type': 'a', 'size_mm': [600, 400, 200], 'count': 2},
                      {'type': 'b<c>', 'size_mm': [300, 400, 100], 'count': 2}]}
RESULT = {'name': 'o', 'method': 'dblf', 'seed': 1, 'utilization': 0.1, 'unpacked': [3],
          'decision_ms': {'median': 1.0, 'p99': 2.0, 'max': 3.0}, 'placements': [
              {'item': 0, 'type': 'a', 'origin_mm': [0, 0, 0], 'size_mm': [600, 400, 200], 'available': [0, 1]},
              {'item': 1, 'type': 'b<c>', 'origin_mm': [600, 0, 0], 'size_mm': [300, 400, 100], 'available': [1, 2]},
              {'item': 2, 'type': 'a', 'origin_mm': [0, 0, 200], 'size_mm': [600, 400, 200], 'available': [2, 3]}]}


def decided(number, available, options, chosen=None):
    event = {'decision_id': number, 'available': available, 'options': options, 'decision_ms': 10.0 * number}
    return {'kind': 'decided', 'time': f't{number}', 'event': event if chosen is None else dict(event, chosen=chosen)}


def reported(number, outcome, **more):
    return {'kind': 'reported', 'time': f'r{number}', 'event': {'decision_id': number, 'outcome': outcome, 'discarded': [], **more}}


def place(kind, origin):
    return {'feasible': True, 'placement': {'type': kind, 'origin_mm': origin, 'size_mm': INSTANCE['items'][kind]['size_mm']}}


NO_ROOM = {'feasible': False, 'reason': 'no room'}
JOURNAL = {'pallet_id': 'p', 'open': False, 'order': dict(INSTANCE, name=None), 'remaining': [0, 1], 'history': [
    {'kind': 'started', 'time': 't0', 'event': {}},
    decided(1, [0, 1], [place(0, [0, 0, 0]), place(1, [0, 0, 0])], 0), reported(1, 'FAILED'),
    reported(1, 'PLACED', measured={'type': 0, 'origin_mm': [5, 0, 0], 'size_mm': [600, 400, 200]}),
    decided(2, [0], [place(0, [605, 0, 0])], 0), reported(2, 'PLACED'), {'kind': 'undone', 'time': 'u', 'event': {}},
    decided(3, [0, 1], [NO_ROOM, NO_ROOM]), reported(3, 'DISCARDED'), {'kind': 'closed', 'time': 'c', 'event': {}}]}
TIMES = {'count': 1, 'median': 1.0, 'p99': 2.0, 'max': 2.0}
EXECUTIVE = {'pallet_id': 'e', 'complete': False, 'message': 'no cloud', 'order': {'name': 'o', **INSTANCE},
             'times_ms': {'capture': TIMES, 'detection': TIMES, 'decision': TIMES},
             'picks': [{'type': 'a', 'origin_mm': [0, 0, 0], 'size_mm': [600, 400, 200], 'decision_ms': 7.0, 'available': 2,
                        'measured_mm': [600.4004, 400.1, 199.8]}], 'discards': [{'type': None, 'reason': 'dented'}]}


def cut(rng, low, high, parts):
    """Disjoint cuboids that fill a box."""
    if parts == 1:
        return [(tuple(low), tuple(high))]
    axis = max(range(3), key=lambda i: high[i] - low[i])
    at = rng.randint(low[axis] + 1, high[axis] - 1)
    middle_high, middle_low = list(high), list(low)
    middle_high[axis] = middle_low[axis] = at
    return cut(rng, low, middle_high, parts // 2) + cut(rng, middle_low, high, parts - parts // 2)


class Drawings(unittest.TestCase):
    def test_what_is_seen_is_painted_last(self):
        for seed in range(8):
            rng = random.Random(seed)
            cuboids = cut(rng, [0, 0, 0], [1000, 800, 600], rng.randint(2, 40))
            rng.shuffle(cuboids)
            place_of = {cuboids[i]: n for n, i in enumerate(pallet_drawings.painting_order(cuboids))}
            self.assertEqual(len(place_of), len(cuboids), f'seed {seed}')
            for _ in range(60):  # along a ray of sight, nearer cuboids are painted later
                x, y, z = rng.uniform(0, 1000), rng.uniform(0, 800), rng.uniform(0, 600)
                last = None
                for step in range(-1000, 1001, 7):
                    p = (x + step, y + step, z - step)
                    hit = [c for c in cuboids if all(a < v < b for a, v, b in zip(c[0], p, c[1]))]
                    if hit and hit[0] != last:
                        if last:
                            self.assertGreater(place_of[last], place_of[hit[0]], f'seed {seed}')
                        last = hit[0]

    def test_layers_and_steps(self):
        record = pallet_sources.from_result(RESULT, INSTANCE)[0]
        self.assertEqual(pallet_drawings.layer_heights(record), [0, 200])
        floor, upper = (pallet_drawings.layer(record, z).decode() for z in (0, 200))
        self.assertEqual(re.findall('data-step="(\\d)"', floor), ['1', '2'])
        self.assertEqual(re.findall('data-step="(\\d)"', upper), ['3'])
        for turned in (False, True):
            picture = pallet_drawings.in_space(record, turned).decode()
            self.assertEqual(sorted(re.findall('data-step="(\\d)"', picture)), ['1', '2', '3'])
        self.assertIsNone(pallet_drawings.decision_times(record))


class Balance(unittest.TestCase):
    PLACED = [{'type': 'a', 'origin_mm': [0, 0, 0], 'size_mm': [400, 400, 200]},
              {'type': 'b', 'origin_mm': [400, 0, 0], 'size_mm': [400, 400, 200]}]

    def test_by_volume_and_by_weight(self):
        by_volume = pallet_balance.balance(self.PLACED, {'a': 1.0})
        self.assertEqual((by_volume['gravity_by'], by_volume['center_of_gravity_mm']), ('volume', [400.0, 200.0, 100.0]))
        self.assertEqual(by_volume['gravity_margin_mm'], 200.0)
        by_weight = pallet_balance.balance(self.PLACED, {'a': 3.0, 'b': 1.0})
        self.assertEqual((by_weight['gravity_by'], by_weight['center_of_gravity_mm']), ('weight', [300.0, 200.0, 100.0]))
        self.assertIsNone(pallet_balance.balance([], {})['center_of_gravity_mm'])

    def test_outside_is_negative(self):
        tower = [{'type': 'a', 'origin_mm': [0, 0, 0], 'size_mm': [100, 100, 100]},
                 {'type': 'b', 'origin_mm': [0, 0, 100], 'size_mm': [1000, 100, 100]}]
        self.assertLess(pallet_balance.balance(tower, {})['gravity_margin_mm'], 0.0)


class Records(unittest.TestCase):
    def test_a_journal_is_played_again(self):
        record = pallet_history.from_journal(JOURNAL)
        self.assertEqual([p['origin_mm'] for p in record['placements']], [[5, 0, 0]])
        self.assertEqual(record['unpacked'], [{'type': 'a', 'reason': 'no room', 'count': 1},
                                              {'type': 'b<c>', 'reason': 'no room', 'count': 1},
                                              {'type': 'b<c>', 'reason': pallet_record.NEVER_CAME, 'count': 1}])
        self.assertEqual(record['decision_ms'], {'count': 3, 'median': 20.0, 'p99': 30.0, 'max': 30.0})
        self.assertFalse(record['complete'])
        self.assertAlmostEqual(record['utilization'], 600 * 400 * 200 / (1200 * 800 * 600))

    def test_an_executive_that_stopped(self):
        record = pallet_sources.from_executive(EXECUTIVE)
        self.assertEqual((record['complete'], record['message']), (False, 'no cloud'))
        self.assertEqual(sum(u['count'] for u in record['unpacked']), 4)
        self.assertIn('dented', [u['reason'] for u in record['unpacked']])
        self.assertIn('<td>600.4 x 400.1 x 199.8</td>', pallet_page.render([record]))

    def test_sizes_in_a_layer_stay_within_their_box(self):
        record = pallet_sources.from_executive(EXECUTIVE)
        for width in (90.0, 300.0, 1200.0):
            record['placements'][0].update(origin_mm=[0, 0, 0], size_mm=[width, 400.2501, 199.75])
            drawing = pallet_drawings.layer(record, 0).decode()
            (letter, words), = re.findall(r'font-size="([0-9]+)"[^>]*>([0-9.]+ x [0-9.]+ x [0-9.]+)<', drawing)
            self.assertEqual(words, f'{width:g} x 400.3 x 199.8')
            self.assertLessEqual(int(letter) * 0.55 * len(words), width)

    def test_several_pallets(self):
        spread = dict(RESULT, pallets=2, placements=[dict(p, pallet=i // 2) for i, p in enumerate(RESULT['placements'])])
        records = pallet_sources.from_result(spread, INSTANCE)
        self.assertEqual([len(r['placements']) for r in records], [2, 1])
        self.assertEqual([bool(r['unpacked']) for r in records], [False, True])
        self.assertEqual(pallet_page.render(records).count('<section>'), 2)


class Program(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def run_on(self, content, *arguments):
        path = self.folder / 'in.json'
        path.write_text(content if isinstance(content, str) else json.dumps(content), encoding='utf-8')
        return subprocess.run([sys.executable, '-B', str(PROGRAM), str(path), '--out', str(self.folder / 'new' / 'out.html'),
                               *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)

    def instances(self, *content):
        path = self.folder / 'instances.jsonl'
        path.write_text('\n'.join(map(json.dumps, content)), encoding='utf-8')
        return '--instances', path

    def test_every_kind_of_file(self):
        for content, more in ((RESULT, self.instances(INSTANCE)), (JOURNAL, ()), (EXECUTIVE, ()),
                              (dict(RESULT, placements=[], unpacked=[0, 1, 2, 3]), self.instances(INSTANCE))):
            done = self.run_on(content, '--json', self.folder / 'out.json', *more)
            self.assertEqual((done.returncode, done.stderr), (0, ''))
            text = (self.folder / 'new' / 'out.html').read_text(encoding='utf-8')
            self.assertEqual(re.findall(r'(?:src|href)=|http', text), [], 'needs something else')
            self.assertNotIn('b<c>', text)
            self.assertIn('b&lt;c&gt;', text)
            record, = json.loads((self.folder / 'out.json').read_text(encoding='utf-8'))['pallets']
            self.assertEqual(text.count('class="drawing"') > 2, bool(record['placements']))

    def test_mistakes_are_named_in_one_line(self):
        two = '\n'.join(json.dumps(dict(RESULT, name=name)) for name in 'op')
        for content, more, words in (('', (), 'is no JSON'), ('[1]', (), 'is no journal'), (RESULT, (), '--instances'),
                                     (dict(JOURNAL, order={}), (), "is broken: KeyError 'items'"),
                                     (two, self.instances(INSTANCE), 'choose one with --name: o, p'),
                                     (RESULT, ('--name', 'x', *self.instances(INSTANCE)), "holds no 'x'"),
                                     ('SQLite format 3\0', (), 'pallet_journal')):
            done = self.run_on(content, *more)
            self.assertEqual((done.returncode, done.stdout), (1, ''))
            self.assertIn(words, done.stderr)
            self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
        done = self.run_on(JOURNAL, '--json', '/dev/null/x')
        self.assertIn('/dev/null/x: cannot be written', done.stderr)


if __name__ == '__main__':
    unittest.main()
