#!/usr/bin/env python3
"""Tests of the modules behind run_experiments that need no tool of the package."""
import math
import pathlib
import re
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / 'experiments'))

from mp_experiments import (detection_rows, errors, page, pallet_pictures, planning_sets, plots,  # noqa: E402
                            published_packings, statistics, thesis_tables, tools)


def summary(**changes):
    figures = {'count': 10, 'mean': 0.1, 'rms': 0.1}
    good = {'recall': 1.0, 'precision': 1.0, 'position_mm': figures, 'yaw_deg': dict(figures, mean=0.01),
            'side_mm': figures, 'height_mm': dict(figures, mean=0.01), 'truncated_flagged': 3, 'truncated_found': 3,
            'sizes_beyond_stddev': 0}
    good.update(changes)
    return good


class Statistics(unittest.TestCase):
    def test_known_numbers(self):
        values = [3.0, -1.0, 1.0, -3.0]
        self.assertEqual(statistics.mean(values), 0.0)
        self.assertAlmostEqual(statistics.rms(values), math.sqrt(5.0))
        self.assertAlmostEqual(statistics.stddev([2.0, 4.0]), 1.0)
        self.assertEqual(statistics.quantile(range(1, 101), 0.95), 95)

    def test_nothing_is_a_dash(self):
        self.assertEqual(statistics.number(statistics.mean([])), '–')
        self.assertEqual(statistics.number(statistics.quantile([], 0.5)), '–')
        self.assertEqual(statistics.number(None), '–')

    def test_error_rows_hold_mean_rms_and_deviation(self):
        rows = thesis_tables.error_rows([[1.0, 3.0]], 'ours')
        self.assertEqual([row[2] for row in rows], ['2.00', '2.24', '1.00'])


class Rows(unittest.TestCase):
    def test_every_row_has_a_recipe_and_limits(self):
        for row in detection_rows.ROWS:
            self.assertTrue(tools.recipe(row.recipe).is_file())
            self.assertNotEqual(bool(row.limits), row.truncated, row.recipe)

    def test_limits_are_kept_or_broken(self):
        row = detection_rows.ROWS[0]
        self.assertTrue(all(detection_rows.holds(row, summary(), limit) for limit in row.limits))
        self.assertFalse(detection_rows.holds(row, summary(recall=0.99), 'recall'))
        wide = summary(position_mm={'count': 10, 'mean': 0.4, 'rms': 0.5})
        self.assertFalse(detection_rows.holds(row, wide, 'position'))
        self.assertTrue(detection_rows.holds(row, wide, 'position', margin=1.5))
        self.assertFalse(detection_rows.holds(row, summary(yaw_deg={'count': 0, 'mean': 0.0, 'rms': 0.0}), 'yaw'))

    def test_truncated_rows_are_judged_by_flags_and_sizes(self):
        self.assertTrue(detection_rows.truncated_holds(summary()))
        self.assertFalse(detection_rows.truncated_holds(summary(truncated_flagged=2)))
        self.assertFalse(detection_rows.truncated_holds(summary(truncated=1, truncated_found=0, truncated_flagged=0)))
        self.assertTrue(detection_rows.truncated_holds(summary(truncated=0, truncated_found=0, truncated_flagged=0)))
        self.assertFalse(detection_rows.truncated_holds(summary(sizes_beyond_stddev=1)))

    def test_a_missing_recipe_is_named(self):
        with self.assertRaisesRegex(errors.ExperimentError, 'nowhere.yaml is missing'):
            tools.recipe('nowhere')


class Html(unittest.TestCase):
    def test_the_page_needs_nothing_else(self):
        made = page.Page('A <title>')
        made.heading('Heading & more')
        made.table(['a', 'b'], [['x', page.Cell('1.0', 'good')], page.Row(['y', 2], 'group')], 'caption')
        made.figure(plots.histograms([('t', 'mm', [('ours', [0.1, 0.2, 0.2], plots.OURS)])]), 'figure')
        made.code(['rosrun a b --c <d>'])
        text = made.render()
        self.assertIn('A &lt;title&gt;', text)
        self.assertIn('<td class="good">1.0</td>', text)
        self.assertIn('data:image/png;base64,', text)
        self.assertEqual(re.findall(r'(?:src|href)="(?!data:)', text), [])
        self.assertNotIn('http', text)

    def test_no_values_no_picture(self):
        self.assertIsNone(plots.histograms([('t', 'mm', [('ours', [], plots.OURS)])]))

    def test_equal_values_make_a_picture(self):
        self.assertTrue(plots.histograms([('t', 'mm', [('ours', [1.0, 1.0], plots.OURS)])]).startswith(b'\x89PNG'))


class Pictures(unittest.TestCase):
    def test_counts_and_pallets_are_drawn(self):
        bars = plots.count_bars([('600 mm', [('ours', [0, 0, 3], plots.OURS), ('theirs', [1], plots.THEIRS)])], 'left')
        self.assertTrue(bars.startswith(b'\x89PNG'))
        placements = [{'type': 'a', 'origin_mm': [0, 0, 0], 'size_mm': [600, 400, 200]},
                      {'type': 'b', 'origin_mm': [600, 0, 0], 'size_mm': [300, 400, 100]}]
        self.assertTrue(pallet_pictures.pallet(placements, [1200, 800, 600]).startswith(b'<svg'))
        self.assertTrue(pallet_pictures.pallet([], [1200, 800, 600]).startswith(b'<svg'))
        grown = pallet_pictures.growing(placements, [1200, 800, 600], 5)
        self.assertEqual([picks for picks, _ in grown], [1, 2])
        self.assertNotEqual(grown[0][1], grown[1][1])

    def test_a_missing_picture_is_named(self):
        with self.assertRaisesRegex(errors.ExperimentError, 'nowhere.png'):
            plots.scene('/nowhere.png', {'boxes': [], 'invented': []})


class PublishedPackings(unittest.TestCase):
    TEXT = '2\n1 250\n587 233 220\n1\n1 10 0 20 0 30 1 5\n2 251\n587 233 220\n2\n1 1 0 2 0 3 1 4\n2 5 0 6 0 7 1 8\n'

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.file, self.part = pathlib.Path(scratch.name) / 'BR.txt', pathlib.Path(scratch.name) / 'part.txt'

    def test_the_first_instances_are_cut_out(self):
        self.file.write_text(self.TEXT)
        published_packings.first_instances(self.file, 1, self.part)
        self.assertEqual(self.part.read_text(), '1\n1 250\n587 233 220\n1\n1 10 0 20 0 30 1 5\n')
        published_packings.first_instances(self.file, 9, self.part)
        self.assertEqual(self.part.read_text(), self.TEXT)

    def test_broken_files_are_named(self):
        for text in ('', 'words', self.TEXT[:-9]):
            self.file.write_text(text)
            with self.assertRaisesRegex(errors.ExperimentError, 'BR.txt: is no BR file'):
                published_packings.first_instances(self.file, 2, self.part)


class RealOrders(unittest.TestCase):
    HEADER = 'Order,Product,Quantity,Length,Width,Height,Weight\n'

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.file, self.part = pathlib.Path(scratch.name) / 'orders.csv', pathlib.Path(scratch.name) / 'part.csv'

    def test_orders_of_about_a_pallet_are_cut_out(self):
        lines = ['a,1,1,100,100,100,1\n', 'b,1,10,1000,800,100,1\n', 'c,1,9,1000,1000,100,1\n', 'd,1,99,1000,1000,100,1\n']
        self.file.write_text(self.HEADER + ''.join(lines))
        planning_sets.first_orders(self.file, 5, self.part)
        self.assertEqual(self.part.read_text(), self.HEADER + lines[1] + lines[2])
        planning_sets.first_orders(self.file, 1, self.part)
        self.assertEqual(self.part.read_text(), self.HEADER + lines[1])

    def test_broken_files_are_named(self):
        for text in ('a,b\n1,2\n', self.HEADER + 'a,1,x,1,1,1,1\n'):
            self.file.write_text(text)
            with self.assertRaisesRegex(errors.ExperimentError, 'orders.csv: is no file of orders'):
                planning_sets.first_orders(self.file, 2, self.part)


class Regret(unittest.TestCase):
    def test_is_counted_by_order(self):
        def results(*used):
            return [{'name': str(i), 'utilization': u, 'unpacked': [1] if u < 1.0 else []} for i, u in enumerate(used)]
        row = planning_sets.result_row('x', results(0.9, 0.8, 1.0), results(0.8, 0.85, 1.0), results(0.95, 0.9, 1.0))
        self.assertEqual(row[2:6], ['1 of 3', '90.00', '8.16', '0.7'])
        self.assertEqual((row[6].text, row[6].kind, row[8]), ('5.00', '', '1 of 3'))


class Runner(unittest.TestCase):
    def test_the_bar_counts_commands(self):
        runner = tools.Tools(ROOT, quiet=True)
        self.assertEqual(runner.bar(), '')
        runner.expected = 4
        runner.run('true', [])
        self.assertEqual(runner.bar(4), '[#...] 1/4')

    def test_a_missing_tool_is_named(self):
        with self.assertRaisesRegex(errors.ExperimentError, 'no_such_tool not found'):
            tools.Tools(ROOT, quiet=True).run('no_such_tool', [])

    def test_a_failing_tool_gives_its_last_line(self):
        runner = tools.Tools(ROOT, quiet=True)
        with self.assertRaisesRegex(errors.ExperimentError, 'ls failed: .*nowhere'):
            runner.run('ls', ['/nowhere'])
        self.assertEqual(runner.commands, [])


if __name__ == '__main__':
    unittest.main()
