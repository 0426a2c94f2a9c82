#!/usr/bin/env python3
"""The table of scripts/torture.sh from the rows its tests printed; with --write also in a document, between its marks."""
import argparse
import datetime
import json
import pathlib
import sys

BEGIN, END = '<!-- table: begin -->', '<!-- table: end -->'


def seconds(value):
    return '' if value is None else '%.2f s' % value


def table(rows, command):
    lines = ['`%s`, %s (UTC):' % (command, datetime.datetime.utcnow().strftime('%Y-%m-%d')), '',
             '| test | tried | survived | lost | recovery p99 | slowest |', '| --- | --- | --- | --- | --- | --- |']
    lines += ['| %s | %d | %d | %d | %s | %s |' % (row['test'], row['tried'], row['survived'], row['lost'],
                                                  seconds(row['p99_s']), seconds(row['slowest_s'])) for row in rows]
    return '\n'.join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--rows', required=True, type=pathlib.Path, help='file with one JSON object a line')
    parser.add_argument('--command', required=True, help='that made the rows')
    parser.add_argument('--write', type=pathlib.Path, help='document with the marks %s and %s' % (BEGIN, END))
    arguments = parser.parse_args()
    text = table([json.loads(line) for line in arguments.rows.read_text().splitlines()], arguments.command.strip())
    print(text)
    if arguments.write is None:
        return 0
    document = arguments.write.read_text(encoding='utf-8')
    if BEGIN not in document or END not in document:
        print('print_table: %s: its marks are missing' % arguments.write, file=sys.stderr)
        return 1
    before, after = document.split(BEGIN)[0], document.split(END)[1]
    arguments.write.write_text('%s%s\n%s\n%s%s' % (before, BEGIN, text, END, after), encoding='utf-8')
    return 0


if __name__ == '__main__':
    sys.exit(main())
