"""Command line of pallet_report."""
import argparse
import json
import os
import pathlib
import sys

from . import pallet_page, pallet_sources
from .errors import ExperimentError
from .tools import Tools

DESCRIPTION = """Writes what became of a pallet as one HTML file that needs no network: pictures in three dimensions and by layer,
the sequence, utilization, centre of gravity, what is not on the pallet and why, decision times."""


def _parser():
    parser = argparse.ArgumentParser(prog='pallet_report', description=DESCRIPTION)
    parser.add_argument('file', help="a planner's journal, an export of pallet_journal, a report of cell_executive, or a result "
                                     'of pack or plan_picks')
    parser.add_argument('--out', required=True, metavar='HTML', help='report to write')
    parser.add_argument('--json', metavar='JSON', help='the same for programs')
    parser.add_argument('--pallet', default='', metavar='ID', help='of a journal: which pallet (default: the last one)')
    parser.add_argument('--instances', default='', metavar='JSONL', help='of a result: its orders')
    parser.add_argument('--name', default='', help='of a result: which order, when there are several')
    return parser


def write_whole(path, text):
    """Nobody reads half a file."""
    path = pathlib.Path(path)
    part = path.with_name(path.name + '.part')
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        part.write_text(text, encoding='utf-8')
        os.replace(str(part), str(path))
    except OSError as error:
        raise ExperimentError(f'{path}: cannot be written: {error.strerror}')


def write(records, html_path, json_path=''):
    write_whole(html_path, pallet_page.render(records))
    if json_path:
        write_whole(json_path, json.dumps({'pallets': records}, indent=2) + '\n')


def main(arguments, script_folder):
    options = _parser().parse_args(arguments)
    try:
        records = pallet_sources.from_file(options.file, Tools(script_folder, quiet=True), options.pallet, options.instances,
                                           options.name)
        write(records, options.out, options.json)
    except ExperimentError as error:
        print(f'pallet_report: {error}', file=sys.stderr)
        return 1
    print(options.out)
    return 0
