#!/usr/bin/env python3
"""Sums test results and says 'N passed, N failed' on its last line.

usage: count_tests.py RESULTS CHECKS    RESULTS: folder of JUnit XML; CHECKS: folder of NAME.result files
Exit code 1 when something failed or nothing passed.
"""
import pathlib
import sys
import xml.etree.ElementTree as ElementTree


def count_xml(path):
    """(passed, failed names, skipped names) of one JUnit file; a file that cannot be read is a failure."""
    try:
        tree = ElementTree.parse(path)
    except ElementTree.ParseError as error:
        return 0, [f'{path.name}: {error}'], []
    passed, failed, skipped = 0, [], []
    for case in tree.iter('testcase'):
        name = f"{case.get('classname', '')}.{case.get('name', '')}"
        if case.find('failure') is not None or case.find('error') is not None:
            failed.append(name)
        elif case.find('skipped') is not None or case.get('result') == 'skipped':
            skipped.append(name)
        elif case.get('status') != 'notrun':
            passed += 1
    return passed, failed, skipped


def main():
    results, checks = (pathlib.Path(argument) for argument in sys.argv[1:3])
    passed, failed, skipped = 0, [], []
    for path in sorted(results.rglob('*.xml')):
        more_passed, more_failed, more_skipped = count_xml(path)
        passed += more_passed
        failed += more_failed
        skipped += more_skipped
    for path in sorted(checks.glob('*.result')):
        if path.read_text().strip() == 'passed':
            passed += 1
        else:
            failed.append(f'check {path.stem}')
    for name in skipped:
        print(f'skipped: {name}')
    for name in failed:
        print(f'FAILED: {name}')
    print(f'{passed} passed, {len(failed)} failed' + (f', {len(skipped)} skipped' if skipped else ''))
    sys.exit(1 if failed or not passed else 0)


if __name__ == '__main__':
    main()
