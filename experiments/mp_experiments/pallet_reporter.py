"""The node that writes a report of every pallet at its end, from the planner's journal."""
import datetime
import os
import pathlib
import re
import time

import rosgraph
import rospy
from std_msgs.msg import String

from mixed_palletizing.msg import PalletState

from . import pallet_command, pallet_sources
from .errors import ExperimentError
from .tools import Tools

PLANNER = 'pick_planner'
FOLDER = '~/.ros/mixed_palletizing/reports'
STATES_KEPT = 100
MASTER_POLL_S = 1.0


def journal_path(given, planner_name):
    """Where the planner keeps its journal, by the rule of docs/ros_api.md; empty for none."""
    if given == 'none':
        return ''
    if given:
        return os.path.expanduser(given)
    home = os.environ.get('ROS_HOME') or os.path.expanduser('~/.ros')
    return f'{home}/mixed_palletizing/{planner_name.strip("/").replace("/", "_")}.journal'


def report_name(pallet_id, time):
    """A file name without an ending."""
    return re.sub(r'[^\w.-]+', '_', pallet_id) + time.strftime('_%Y%m%dT%H%M%SZ')


class PalletReporter:
    def __init__(self, script_folder):
        planner = rospy.resolve_name(PLANNER)
        self.folder = pathlib.Path(os.path.expanduser(rospy.get_param('~folder', FOLDER)))
        self.journal = journal_path(rospy.get_param(planner + '/journal/file', ''), planner)
        self.tools = Tools(script_folder, quiet=True)
        self.open = ''
        self.written = rospy.Publisher('pallet_report', String, queue_size=1, latch=True)
        if self.journal:
            rospy.Subscriber(planner + '/pallet_state', PalletState, self.on_state, queue_size=STATES_KEPT)
        else:
            rospy.logwarn('no reports of pallets: the planner keeps no journal')

    def on_state(self, state):
        """A pallet ends when it is closed or another one is open."""
        now = state.pallet_id if state.is_open else ''
        ended, self.open = self.open, now
        if ended and ended != now:
            self.write(ended)

    def write(self, pallet_id):
        path = self.folder / (report_name(pallet_id, datetime.datetime.utcnow()) + '.html')
        try:
            records = pallet_sources.from_file(self.journal, self.tools, pallet_id)
            pallet_command.write(records, path, path.with_suffix('.json'))
        except ExperimentError as error:
            rospy.logerr('no report of pallet %s: %s', pallet_id, error)
            return
        rospy.loginfo('report of pallet %s: %s', pallet_id, path)
        self.written.publish(str(path))


def forgotten():
    """The master was started anew and does not know this node; None while there is no master."""
    try:
        rosgraph.Master(rospy.get_name()).lookupService(rospy.get_name() + '/get_loggers')
    except rosgraph.MasterError:
        return True
    except OSError:
        return None
    return False


def main(script_folder):
    rospy.init_node('pallet_reporter')
    PalletReporter(script_folder)
    away = False
    while not rospy.is_shutdown():
        time.sleep(MASTER_POLL_S)
        answer = forgotten()
        if answer and not rospy.is_shutdown():
            rospy.logfatal('the ROS master was started anew and does not know this node: start the launch file again')
            return 1
        if answer is None and not away:
            rospy.logerr('the ROS master does not answer')
        away = answer is None
    return 0
