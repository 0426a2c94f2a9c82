"""A planner and its services, for the rostests."""
import unittest

import rospy
from geometry_msgs.msg import Pose, PoseWithCovariance, Quaternion, Vector3
from mixed_palletizing.msg import Box, PalletState
from mixed_palletizing.srv import (ChooseNextPick, ChooseNextPickRequest, ClosePallet, GetPalletState, ReportPick,
                                   ReportPickRequest, StartPallet, StartPalletRequest, UndoLast)
from visualization_msgs.msg import MarkerArray

from cell_client import Latest, order_line

PALLET_MM = (600, 400, 200)
LINES = [('big', (300, 400, 200), 1), ('flat', (300, 400, 100), 2)]


def start_request(pallet_id='p', lines=LINES, **values):
    request = StartPalletRequest(pallet_id=pallet_id, size=Vector3(*(s / 1000.0 for s in PALLET_MM)),
                                 order=[order_line(*line) for line in lines])
    for name, value in values.items():
        setattr(request, name, value)
    return request


def detected(size_mm, stddev_mm=0.5):
    """A box as the detector reports it: length >= width."""
    length, width = max(size_mm[:2]), min(size_mm[:2])
    return Box(size=Vector3(length / 1e3, width / 1e3, size_mm[2] / 1e3),
               size_stddev=Vector3(*[stddev_mm / 1e3] * 3),
               pose=PoseWithCovariance(pose=Pose(orientation=Quaternion(w=1.0))))


class PlannerClient(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.states = Latest('pick_planner/pallet_state', PalletState)
        cls.markers = Latest('pick_planner/pallet_markers', MarkerArray)
        cls.services = {}
        for name, kind in [('start_pallet', StartPallet), ('choose_next_pick', ChooseNextPick),
                           ('report_pick', ReportPick), ('undo_last', UndoLast), ('get_pallet_state', GetPalletState),
                           ('close_pallet', ClosePallet)]:
            rospy.wait_for_service('pick_planner/' + name, 30.0)
            cls.services[name] = rospy.ServiceProxy('pick_planner/' + name, kind)

    def setUp(self):
        self.services['close_pallet']()

    def start(self, **values):
        return self.services['start_pallet'](start_request(**values))

    def choose(self, *type_ids, **values):
        return self.services['choose_next_pick'](ChooseNextPickRequest(type_ids=list(type_ids), **values))

    def report(self, decision_id, outcome=ReportPickRequest.PLACED, **values):
        return self.services['report_pick'](ReportPickRequest(decision_id=decision_id, outcome=outcome, **values))

    def state(self):
        return self.services['get_pallet_state']()
