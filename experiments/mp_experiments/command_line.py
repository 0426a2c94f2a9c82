"""Command line of run_experiments."""
import argparse
import os
import pathlib
import sys

from .errors import ExperimentError

DESCRIPTION = """Runs experiments and writes them as reports: one HTML file each, readable without a network, with the
records beside it."""


def _count(text):
    value = int(text)
    if value < 1:
        raise argparse.ArgumentTypeError(f'{value} is less than 1')
    return value


def _parser():
    parser = argparse.ArgumentParser(prog='run_experiments', description=DESCRIPTION)
    parser.add_argument('experiment', choices=('detection', 'packing', 'planning'), help='what to measure')
    parser.add_argument('--thesis', action='store_true',
                        help="detection: the experiments of the source thesis' chapter 4.1 instead of the table")
    parser.add_argument('--out', required=True, metavar='DIR', help='folder for report and records, made when missing')
    parser.add_argument('--count', type=_count,
                        help='scenes a row, orders a height (default: 50 scenes, or as many as the thesis has)')
    parser.add_argument('--quick', action='store_true', help='few scenes: a look at the report in minutes')
    parser.add_argument('--only', metavar='PART', action='append',
                        help='detection: this recipe, a row of the table, alone; planning: steps, rules, curves or rich alone '
                             '(more than one: repeat the option)')
    parser.add_argument('--data', metavar='DIR', default=os.environ.get('MIXED_PALLETIZING_DATA', ''),
                        help='packing, planning: folder with packing, published orders (default: MIXED_PALLETIZING_DATA)')
    parser.add_argument('--seed', type=int, default=1, help='of all scenes and orders (default: 1)')
    parser.add_argument('--threads', type=_count, default=1, help='scenes, or orders that are planned, side by side; times are clean with 1')
    parser.add_argument('--quiet', action='store_true', help='no progress on stderr')
    return parser


def _folder(path):
    out = pathlib.Path(path)
    try:
        (out / 'data').mkdir(parents=True, exist_ok=True)
        probe = out / 'data' / '.probe'
        probe.write_text('', encoding='utf-8')
        probe.unlink()
    except OSError as error:
        raise ExperimentError(f'{path}: cannot be written: {error.strerror}')
    return out


def _run(options, script_folder):
    if options.experiment != 'detection' and options.thesis:
        raise ExperimentError('--thesis belongs to detection')
    if options.experiment == 'packing' and options.only:
        raise ExperimentError('--only belongs to detection and planning')
    out = _folder(options.out)
    # Here and not above: --help and a wrong command line need no matplotlib.
    from . import detection_report, measurements, order_reports, planning_report, thesis_report, tools as tools_module
    tools = tools_module.Tools(script_folder, options.quiet)
    measurer = measurements.Measurer(tools, out / 'data', options.seed, options.threads)
    makers = {'detection': thesis_report.make if options.thesis else detection_report.make,
              'packing': order_reports.packing, 'planning': planning_report.planning}
    return makers[options.experiment](tools, measurer, options, out)


def main(arguments, script_folder):
    options = _parser().parse_args(arguments)
    try:
        print(_run(options, script_folder))
    except ExperimentError as error:
        print(f'run_experiments: {error}', file=sys.stderr)
        return 1
    except OSError as error:
        print(f'run_experiments: {error.filename or options.out}: {error.strerror}', file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print('run_experiments: interrupted', file=sys.stderr)
        return 130
    return 0
