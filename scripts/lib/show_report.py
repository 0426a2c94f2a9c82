#!/usr/bin/env python3
"""Prints the report of the cell's executive in short.

usage: show_report.py REPORT      (exit code 1 when the report is missing, broken, or of an order that is not complete)
"""
import json
import sys


def load(path):
    """The report, or an exit with one line that says what is wrong."""
    try:
        with open(path, encoding='utf-8') as file:
            report = json.load(file)
    except OSError as error:
        sys.exit(f'{path}: cannot be read: {error.strerror}')
    except ValueError as error:
        sys.exit(f'{path}: is no JSON: {error}')
    if not isinstance(report, dict):
        sys.exit(f'{path}: is no report: an object is expected')
    return report


def times_line(name, times):
    return (f'{name:<12} {times["count"]:4d} times   median {times["median"]:8.1f} ms   99 % {times["p99"]:8.1f} ms'
            f'   longest {times["max"]:8.1f} ms')


def reasons(discards):
    """Discarded boxes of the same type and reason in one line each."""
    counts = {}
    for discard in discards:
        key = (discard['type'] or 'not identified', discard['reason'])
        counts[key] = counts.get(key, 0) + 1
    return [f'  discarded {count} x {kind}: {reason}' for (kind, reason), count in counts.items()]


def summary(report):
    order, error = report['order'], report['size_error_mm']
    total = sum(item['count'] for item in order['items'])
    size = ' x '.join(f'{side:g}' for side in order['pallet_mm'])
    lines = [f'order        {order["name"]}: {total} boxes of {len(order["items"])} types, pallet {size} mm',
             f'placed       {report["placed"]}, discarded {report["discarded"]}, '
             f'utilization {100 * report["utilization"]:.1f} %']
    lines += reasons(report['discards'])
    lines += [times_line(name, report['times_ms'][name]) for name in ('capture', 'detection', 'decision')]
    if report['picks']:
        worst = ', '.join(f'{value:.1f}' for value in error['max'])
        lines.append(f'sizes        length, width, height at most {worst} mm off')
    lines.append('complete' if report['complete'] is True else f'NOT COMPLETE: {report["message"]}')
    return lines


def main():
    if len(sys.argv) != 2 or sys.argv[1] in ('-h', '--help'):
        print(__doc__.strip())
        sys.exit(0 if sys.argv[1:] in (['-h'], ['--help']) else 2)
    report = load(sys.argv[1])
    try:
        lines = summary(report)
    except (KeyError, TypeError, ValueError, AttributeError, IndexError) as error:
        sys.exit(f'{sys.argv[1]}: is no report: {type(error).__name__} {error}')
    print('\n'.join(lines))
    sys.exit(0 if report['complete'] is True else 1)


if __name__ == '__main__':
    main()
