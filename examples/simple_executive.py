#!/usr/bin/env python3
"""A small robot executive: packs one order with the detector and the planner of the cell.

usage: rosrun mixed_palletizing simple_executive.py _order:=ORDER.jsonl [_index:=0] [_pending:=placed|failed]

Copy it and replace SimulatedRobot by your robot: everything else is the dialogue with the services. The order is a
line of an instance file (docs/file_formats.md). Exit code 0 when every box of the order was placed.

Started again after a crash it goes on with the pallet. When it ended in the middle of a pick, somebody has to look
whether that box stands on the pallet, and to say so: _pending:=placed, or _pending:=failed.
"""
import json
import sys
import time

import rospy
from geometry_msgs.msg import PointStamped, Vector3

from mixed_palletizing.msg import OrderLine, PickOption
from mixed_palletizing.srv import (Calibrate, ChooseNextPick, ChooseNextPickResponse, ClosePallet, DetectBoxes,
                                   DetectBoxesResponse, GetPalletState, ReportPick, ReportPickRequest, StartPallet,
                                   TakeBox)

ROTATIONS = {'none': OrderLine.NONE, 'yaw': OrderLine.YAW, 'any': OrderLine.ANY}
OUTCOMES = {'placed': ReportPickRequest.PLACED, 'failed': ReportPickRequest.FAILED}
MOST_FAILURES = 5  # of one kind in a row, before the executive gives up
PAUSE_S = 0.2
PATIENCE_S = 60.0  # with a service that is not there: its node may just be starting again


class SimulatedRobot:
    """Takes boxes out of the simulated pick area; a real robot moves here."""

    def __init__(self):
        self._take = service('zivid_camera/take_box', TakeBox)

    def place(self, header, box, placement):
        """Moves a box of the pick area to its place (placement.pose in the pallet frame). False: it did not work."""
        del placement  # the simulated robot needs no target
        return self._take(PointStamped(header, box.top_center), False).success

    def remove(self, header, box):
        """Takes a box out of the pick area that will not be packed."""
        self._take(PointStamped(header, box.top_center), True)


def service(name, kind):
    rospy.wait_for_service(name, PATIENCE_S)
    return rospy.ServiceProxy(name, kind)


def patient(name, kind):
    """A service that may be called twice for the same: when its node dies meanwhile, the call is repeated."""
    proxy = service(name, kind)

    def call(*arguments, **values):
        end = time.monotonic() + PATIENCE_S
        while True:
            try:
                return proxy(*arguments, **values)
            except rospy.ServiceException as error:
                if rospy.is_shutdown() or time.monotonic() > end:
                    raise
                rospy.logwarn('%s: %s; waiting for it', name, error)
                time.sleep(PAUSE_S)
                rospy.wait_for_service(name, PATIENCE_S)

    return call


def meters(size_mm):
    return Vector3(*(side / 1000.0 for side in size_mm))


def order_lines(items):
    lines = []
    for item in items:
        rotations = item.get('rotations', 'none')
        line = OrderLine(type_id=item['type'], size=meters(item['size_mm']), count=item['count'],
                         weight=item.get('weight_kg', 0.0), max_load=item.get('max_load_kg', 0.0))
        if isinstance(rotations, list):
            line.rotations, line.vertical = OrderLine.CUSTOM, rotations
        else:
            line.rotations = ROTATIONS[rotations]
        lines.append(line)
    return lines


class Executive:
    def __init__(self, robot):
        self._robot = robot
        self._calibrate = patient('box_detector/calibrate', Calibrate)
        self._detect = patient('box_detector/detect', DetectBoxes)
        self._start = service('pick_planner/start_pallet', StartPallet)
        self._state = patient('pick_planner/get_pallet_state', GetPalletState)
        self._choose = patient('pick_planner/choose_next_pick', ChooseNextPick)
        self._report = patient('pick_planner/report_pick', ReportPick)
        self._close = service('pick_planner/close_pallet', ClosePallet)
        self._failures = 0

    def pack(self, order, pending=''):
        """Packs the order, or goes on with it; the planner's summary. `pending`: what became of a pick in the middle of
        which an executive ended: 'placed', 'failed', or '' when nobody looked."""
        self._checked(self._calibrate(0, 0.0), 'calibrate')
        state = self._state().state
        if state.is_open and state.pallet_id == order['name']:
            self._go_on(state, pending)
        else:
            self._begin(order)
        while self._step():
            pass
        return self._checked(self._close(), 'close_pallet').summary

    def _begin(self, order):
        self._checked(self._start(pallet_id=order['name'], size=meters(order['pallet_mm']),
                                  order=order_lines(order['items']), gap=order.get('gap_mm', 0) / 1000.0,
                                  min_support_ratio=order.get('min_support_ratio', 1.0)), 'start_pallet')

    def _go_on(self, state, pending):
        """Only a look at the pallet tells whether a pick that was not reported was done."""
        if state.has_pending:
            if pending not in OUTCOMES:
                raise RuntimeError('a {} was on its way when the executive ended: look at the pallet and start again with '
                                   '_pending:=placed or _pending:=failed'.format(state.pending.type_id))
            self._checked(self._report(decision_id=state.pending_decision_id, outcome=OUTCOMES[pending]), 'report_pick')
        rospy.loginfo('pallet %s goes on, %d boxes stand on it', state.pallet_id, len(self._state().state.placements))

    def _step(self):
        """One look and one pick; False when the order is complete."""
        seen = self._detect(0.0, rospy.Time(0))
        if seen.status in (DetectBoxesResponse.TIMEOUT, DetectBoxesResponse.BAD_CLOUD):
            self._failed('detect: ' + seen.message)  # the next cloud may be better
            return True
        if seen.status == DetectBoxesResponse.NOT_CALIBRATED:  # the detector was started again
            self._checked(self._calibrate(0, 0.0), 'calibrate')
            return True
        look = self._checked(seen, 'detect').boxes
        answer = self._choose(request_id='', boxes=look.boxes)
        if answer.status == ChooseNextPickResponse.ORDER_COMPLETE:
            return False
        if answer.status == ChooseNextPickResponse.PICK:
            self._pick(look, answer)
        elif answer.status == ChooseNextPickResponse.NONE_FITS:
            self._discard(look, answer)
        elif answer.status in (ChooseNextPickResponse.UNKNOWN_BOX, ChooseNextPickResponse.AMBIGUOUS_BOX):
            self._failed(answer.message)  # look again: noise may have been the reason
        else:
            raise RuntimeError('choose_next_pick: ' + answer.message)
        return True

    def _pick(self, look, answer):
        box = look.boxes[answer.chosen_index]
        placed = self._robot.place(look.header, box, answer.placement)
        outcome = ReportPickRequest.PLACED if placed else ReportPickRequest.FAILED
        self._checked(self._report(decision_id=answer.decision_id, outcome=outcome), 'report_pick')
        if not placed:
            self._failed('the robot could not place a ' + answer.type_id)
            return
        self._failures = 0
        place = answer.placement.pose.position
        rospy.loginfo('%s to (%.3f, %.3f, %.3f) m', answer.type_id, place.x, place.y, place.z)

    def _discard(self, look, answer):
        known = [i for i, option in enumerate(answer.options) if option.status == PickOption.DOES_NOT_FIT]
        self._checked(self._report(decision_id=answer.decision_id, outcome=ReportPickRequest.DISCARDED), 'report_pick')
        for i in known:
            rospy.logwarn('discarded %s: %s', answer.options[i].type_id, answer.options[i].reason)
            self._robot.remove(look.header, look.boxes[i])

    def _failed(self, message):
        self._failures += 1
        rospy.logwarn(message)
        if self._failures > MOST_FAILURES:
            raise RuntimeError('given up: ' + message)

    @staticmethod
    def _checked(answer, name):
        if answer.status != 0:
            raise RuntimeError('{}: {}'.format(name, answer.message))
        return answer


def read_order(path, index):
    with open(path, encoding='utf-8') as file:
        lines = [line for line in file if line.strip()]
    if not 0 <= index < len(lines):
        raise RuntimeError('{}: has {} orders, no index {}'.format(path, len(lines), index))
    return json.loads(lines[index])


def main(robot=SimulatedRobot):
    rospy.init_node('simple_executive')
    try:
        order = read_order(rospy.get_param('~order'), int(rospy.get_param('~index', 0)))
        pending = rospy.get_param('~pending', '')
        if pending:
            rospy.delete_param('~pending')  # it is true of this start alone
        summary = Executive(robot()).pack(order, pending)
    except (OSError, KeyError, ValueError, RuntimeError, rospy.ROSException, rospy.ServiceException) as error:
        rospy.logerr('%s', error)
        sys.exit(1)
    rospy.loginfo('placed %d, discarded %d, utilization %.1f %%', summary.placed, summary.discarded,
                  100.0 * summary.utilization)
    sys.exit(0 if summary.discarded == 0 and summary.remaining == 0 else 1)


if __name__ == '__main__':
    main()
