#!/usr/bin/env python3
"""A rostest with what it printed and the row of its counts for the table of scripts/torture.sh.

usage: rostest_row.py NAME.test [ARGUMENT:=VALUE...]    exit code: that of rostest
"""
import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

LOG_LINES = 60


def show(path):
    """What the test printed, and why its cases failed."""
    for element in ElementTree.parse(path).iter():
        text = (element.text or '').replace('<![CDATA[', '').replace(']]>', '').strip()
        if element.tag in ('system-out', 'failure', 'error') and text:
            print(text)


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        # Not with --text: its exit code knows nothing of the test's cases.
        run = subprocess.run(['rostest', '--results-base-dir', name, 'mixed_palletizing', *sys.argv[1:],
                              'table:=%s' % (folder / 'table')], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                             universal_newlines=True, errors='replace')
        for path in sorted(folder.rglob('rosunit-*.xml')):
            show(path)
        if run.returncode != 0:
            print('\n'.join(run.stdout.splitlines()[-LOG_LINES:]), file=sys.stderr)
        if (folder / 'table').exists():
            print('ROW ' + (folder / 'table').read_text())
    return run.returncode


if __name__ == '__main__':
    sys.exit(main())
