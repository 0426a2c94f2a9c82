#!/usr/bin/env python3
"""The table of scripts/torture.sh from the rows its tests printed; with --write also in a document, between its marks, where each
row names the run it comes from: its command and date."""
import argparse
import datetime
import fcntl
import json
import pathlib
import re
import sys

BEGIN, END = '<!-- table: begin -->', '<!-- table: end -->'
COLUMNS = '| test | tried | survived | lost | recovery p99 | slowest | run |'
ROW = re.compile(r'^\| (?P<test>[^|]+?) \| (?P<cells>\d+ \| \d+ \| \d+ \| [^|]* \| [^|]*) \| (?P<run>\d+) \|$', re.MULTILINE)
RUN = re.compile(r'^(?P<run>\d+)\. (?P<command>`[^`]+`, .*)$', re.MULTILINE)


def seconds(value):
    return '' if value is None else '%.2f s' % value


def new_rows(path, command):
    """{test: (cells, run)} of the lines of the file."""
    run = '`%s`, %s (UTC)' % (command, datetime.datetime.utcnow().strftime('%Y-%m-%d'))
    rows = {}
    for line in path.read_text().splitlines():
        row = json.loads(line)
        cells = '%d | %d | %d | %s | %s' % (row['tried'], row['survived'], row['lost'], seconds(row['p99_s']),
                                            seconds(row['slowest_s']))
        rows[row['test']] = (cells, run)
    return rows


def old_rows(text):
    """The same of a table that was written before."""
    runs = {match['run']: match['command'] for match in RUN.finditer(text)}
    return {match['test']: (match['cells'], runs[match['run']]) for match in ROW.finditer(text)}


def table(rows):
    runs = list(dict.fromkeys(run for _, run in rows.values()))
    lines = [COLUMNS, re.sub(r' [^|]+ ', ' --- ', COLUMNS)]
    lines += ['| %s | %s | %d |' % (test, cells, runs.index(run) + 1) for test, (cells, run) in rows.items()]
    lines += ['', 'The runs:', '']
    lines += ['%d. %s' % (i + 1, run) for i, run in enumerate(runs)]
    return '\n'.join(lines)


def write(document, rows, keep):
    """False when the marks are missing. Several runs may write at the same time."""
    with document.open('r+', encoding='utf-8') as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        text = file.read()
        if BEGIN not in text or END not in text:
            return False
        before, rest = text.split(BEGIN)
        between, after = rest.split(END)
        if keep:
            rows = {**old_rows(between), **rows}
        file.seek(0)
        file.truncate()
        file.write('%s%s\n%s\n%s%s' % (before, BEGIN, table(rows), END, after))
    return True


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--rows', required=True, type=pathlib.Path, help='file with one JSON object a line')
    parser.add_argument('--command', required=True, help='that made the rows')
    parser.add_argument('--write', type=pathlib.Path, help='document with the marks %s and %s' % (BEGIN, END))
    parser.add_argument('--keep', action='store_true', help="keep the document's rows of other tests, with their runs")
    arguments = parser.parse_args()
    rows = new_rows(arguments.rows, arguments.command.strip())
    print(table(rows))
    if arguments.write is None or write(arguments.write, rows, arguments.keep):
        return 0
    print('print_table: %s: its marks are missing' % arguments.write, file=sys.stderr)
    return 1


if __name__ == '__main__':
    sys.exit(main())
