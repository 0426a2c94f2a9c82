#!/usr/bin/env python3
"""Kills the processes of a working cell again and again at random instants; see --help."""
import argparse
import os
import socket
import sys
import tempfile

from killed_planner import percentile
from report_row import print_row


def free_port():
    with socket.socket() as free:
        free.bind(('127.0.0.1', 0))
        return free.getsockname()[1]


def main():
    parser = argparse.ArgumentParser(description='Kills (SIGKILL) camera, detector (its manager, its loader), planner, '
                                     'executive and master in turn, at random instants, while boxes are packed. Starts a '
                                     'master of its own.')
    parser.add_argument('--kills', type=int, default=40, help='how often (40)')
    parser.add_argument('--seed', type=int, default=1, help='of the instants (1)')
    arguments = parser.parse_args()
    if arguments.kills < 1:
        parser.error('--kills: %d is less than 1' % arguments.kills)
    port = free_port()
    os.environ['ROS_MASTER_URI'] = 'http://localhost:%d' % port
    from killed_cell import CellKillings, Lost  # rospy takes the master that is named when it is imported

    fault = ''
    with tempfile.TemporaryDirectory() as folder, open(os.path.join(folder, 'log'), 'w+', encoding='utf-8') as log:
        killings = CellKillings(folder, port, log, arguments.seed, arguments.kills)
        try:
            killings.run(progress)
        except Lost as lost:
            fault = str(lost)
            log.seek(0)
            print('seed %d, kill %d: %s\n%s' % (arguments.seed, killings.tried, fault, log.read()[-4000:]), file=sys.stderr)
    everything = [seconds for times in killings.recovery_s.values() for seconds in times] or [0.0]
    for victim, times in killings.recovery_s.items():
        if times:
            print('%-9s killed %d times; two boxes placed after: median %.1f s, p99 %.1f s, slowest %.1f s' %
                  (victim, len(times), percentile(times, 0.5), percentile(times, 0.99), max(times)))
    print('%d kills, %d boxes placed, executive started %d times, in the middle of a pick %d times: %d of these boxes stood on the '
          'pallet' % (killings.tried, killings.boxes, killings.starts, sum(killings.pending.values()),
                      killings.pending['placed']))
    print_row('camera, detector, planner, executive, master killed in turn', killings.tried,
              max(0, killings.tried - bool(fault)), int(bool(fault)), percentile(everything, 0.99), max(everything))
    return 1 if fault else 0


def progress(tried):
    if sys.stderr.isatty():
        print('\rkill %d' % tried, end='', file=sys.stderr, flush=True)


if __name__ == '__main__':
    sys.exit(main())
