#!/usr/bin/env python3
"""Kills the planner again and again at random instants while an executive works with it; see --help."""
import argparse
import os
import sys
import tempfile

import rospy

from killed_planner import Killings, Lost, percentile
from report_row import print_row

RECOVERY_S = 2.0


def main():
    parser = argparse.ArgumentParser(description='Kills the planner (SIGKILL) at random instants while an executive works '
                                     'with it through its services. A ROS master must run.')
    parser.add_argument('--kills', type=int, default=200, help='how often (200)')
    parser.add_argument('--seed', type=int, default=1, help='of the instants and of the work (1)')
    arguments = parser.parse_args()
    if arguments.kills < 1:
        parser.error('--kills: %d is less than 1' % arguments.kills)
    rospy.init_node('kill_planner', anonymous=True, disable_signals=True)
    fault = ''
    with tempfile.TemporaryDirectory() as folder, open(os.path.join(folder, 'log'), 'w+') as log:
        killings = Killings(os.path.join(folder, 'p.journal'), log, arguments.seed)
        try:
            killings.run(arguments.kills, progress)
        except Lost as lost:
            fault = str(lost)
            log.seek(0)
            print('seed %d, kill %d: %s\n%s' % (arguments.seed, killings.tried, fault, log.read()[-2000:]),
                  file=sys.stderr)
    slowest = max(killings.recovery_s, default=0.0)
    late = sum(1 for seconds in killings.recovery_s if seconds > RECOVERY_S)
    print('%d kills, %d steps acknowledged, %d pending decisions served again; recovery median %.2f s, p99 %.2f s, '
          'slowest %.2f s, %d later than %.0f s' %
          (killings.tried, killings.steps, killings.served_again, percentile(killings.recovery_s or [0.0], 0.5),
           percentile(killings.recovery_s or [0.0], 0.99), slowest, late, RECOVERY_S))
    print_row('planner killed at random instants', killings.tried, killings.tried - bool(fault), int(bool(fault)),
              percentile(killings.recovery_s or [0.0], 0.99), slowest)
    return 1 if fault or late else 0


def progress(tried):
    if sys.stderr.isatty():
        print('\rkill %d' % tried, end='', file=sys.stderr, flush=True)


if __name__ == '__main__':
    sys.exit(main())
