#!/usr/bin/env python3
"""Many clients at once, clouds faster than they can be worked on, and both for long: every call is answered, the latest cloud
wins, and memory, threads and files stay as they are. Parameters: see load.test."""
import contextlib
import os
import random
import sys
import tempfile
import threading
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), '..', 'torture'))

import rospy  # noqa: E402
import rostest  # noqa: E402
from diagnostic_msgs.msg import DiagnosticArray  # noqa: E402
from mixed_palletizing.msg import BoxArray  # noqa: E402
from mixed_palletizing.srv import (Calibrate, CalibrateRequest, CalibrateResponse, ChooseNextPickRequest,  # noqa: E402
                                   ChooseNextPickResponse, DetectBoxes, DetectBoxesRequest, DetectBoxesResponse,
                                   ReportPickRequest, ReportPickResponse, StartPalletResponse, UndoLastResponse)
from sensor_msgs.msg import PointCloud2  # noqa: E402

from bad_clouds import replaced, with_points  # noqa: E402
from cell_client import Latest, capture  # noqa: E402
from counts import Counts  # noqa: E402
from killed_planner import PlannerProcess  # noqa: E402
from planner_client import PlannerClient, start_request  # noqa: E402
from processes import Use, pid_of  # noqa: E402

LINES = [('a', (100, 100, 50), 60), ('b', (150, 100, 50), 60)]
CALLS = 6          # of each client
FLOOD_S = 4.0
OLD_S = 1.2        # a queue that grows makes answers older than this within the flood
LOOKS = 20         # at memory, during the soak
MEMORY = '/dev/shm'  # on a disk most of the soak would be waiting for its syncs


class Flood:
    """Clouds at a fixed rate while the `with` lasts."""

    def __init__(self, publisher, cloud, rate_hz):
        self._publisher, self._cloud, self._period_s = publisher, cloud, 1.0 / rate_hz
        self._ends = threading.Event()
        self._thread = threading.Thread(target=self._publish)
        self.published = {}  # stamp: when, on the steady clock

    def __enter__(self):
        self._thread.start()
        return self

    def __exit__(self, *_):
        self._ends.set()
        self._thread.join()

    def _publish(self):
        while not self._ends.wait(self._period_s):
            self.last = publish(self._publisher, self._cloud)
            self.published[self.last] = time.monotonic()


def publish(publisher, cloud):
    cloud = replaced(cloud)
    cloud.header.stamp = rospy.Time.now()
    publisher.publish(cloud)
    return cloud.header.stamp


def thinned(cloud):
    """Every second point of every second row: a quarter of the work."""
    height, width = (cloud.height + 1) // 2, (cloud.width + 1) // 2
    return replaced(with_points(cloud, lambda points: points[::2, ::2]), height=height, width=width,
                    row_step=width * cloud.point_step)


def at_once(count, work):
    """work(i) in `count` threads; what they returned."""
    results, errors = [None] * count, []

    def run(i):
        try:
            results[i] = work(i)
        except Exception as error:  # pylint: disable=broad-except
            errors.append(error)
    threads = [threading.Thread(target=run, args=(i,)) for i in range(count)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    if errors:
        raise AssertionError('%d of %d clients failed: %s' % (len(errors), count, errors[0])) from errors[0]
    return results


class Load(PlannerClient):
    @classmethod
    def setUpClass(cls):
        cls.counts = Counts('clients at once, flood of clouds, soak')
        cls.clients = rospy.get_param('~clients', 50)
        cls.rate_hz = rospy.get_param('~rate_hz', 200)
        cls.cycles = rospy.get_param('~cycles', 120)
        cls.rng = random.Random(rospy.get_param('~seed', 1))
        cls.folder = tempfile.TemporaryDirectory(dir=MEMORY if os.path.isdir(MEMORY) else None)
        # Few pallets, so that the journal, of which SQLite keeps up to 2 MB in memory, has its final size soon.
        cls.planner = PlannerProcess(os.path.join(cls.folder.name, 'p.journal'), None,
                                     ('_time_budget_s:=0.002', '_journal/keep_pallets:=3'))
        cls.planner.start()
        super().setUpClass()
        cls.states.close()  # they would pile up here
        cls.markers.close()
        cls.boxes = Latest('boxes', BoxArray)
        cls.diagnostics = Latest('/diagnostics', DiagnosticArray)
        cls.points = rospy.Publisher('test/points', PointCloud2, queue_size=1)
        cls.cloud = capture()
        for name, kind in (('detect', DetectBoxes), ('calibrate', Calibrate)):
            rospy.wait_for_service('box_detector/' + name, 30.0)
            cls.services[name] = rospy.ServiceProxy('box_detector/' + name, kind)
        with Flood(cls.points, cls.cloud, 5):
            answer = cls.services['calibrate'](CalibrateRequest(cloud_count=1, timeout=20.0))
        assert answer.success, answer.message

    @classmethod
    def tearDownClass(cls):
        cls.planner.kill()
        cls.folder.cleanup()
        cls.counts.write(rospy.get_param('~table', ''), with_p99=False)

    def timed(self, name, *arguments, **values):
        start = time.monotonic()
        answer = self.services[name](*arguments, **values)
        self.counts.recovery_s.append(time.monotonic() - start)
        return answer

    @contextlib.contextmanager
    def counted(self, count):
        """What is tried within the `with`; it survived when nothing is thrown."""
        self.counts.tried += count
        yield
        self.counts.survived += count

    def client(self, i):
        """One of many executives; how many changes it was told of, as revisions."""
        rng = random.Random(i)
        changes = []
        for call in range(CALLS):
            types = [rng.choice(LINES)[0] for _ in range(rng.randint(1, 3))]
            choice = self.timed('choose_next_pick', ChooseNextPickRequest(request_id='%d %d' % (i, call), type_ids=types))
            self.assertIn(choice.status, (ChooseNextPickResponse.PICK, ChooseNextPickResponse.NONE_FITS,
                                          ChooseNextPickResponse.ORDER_COMPLETE, ChooseNextPickResponse.UNKNOWN_BOX),
                          choice.message)
            outcome = rng.choice([ReportPickRequest.PLACED, ReportPickRequest.DISCARDED])
            if choice.status == ChooseNextPickResponse.PICK:
                report = self.timed('report_pick', ReportPickRequest(decision_id=choice.decision_id, outcome=outcome))
                self.assertIn(report.status, (ReportPickResponse.OK, ReportPickResponse.UNKNOWN_DECISION), report.message)
                changes += [report.revision] if report.status == ReportPickResponse.OK else []
            self.assertEqual(self.timed('get_pallet_state').status, 0)
            self.assertEqual(self.timed('start_pallet', start_request()).status, StartPalletResponse.PALLET_OPEN)
            if rng.random() < 0.2:
                undone = self.timed('undo_last')
                self.assertIn(undone.status, (UndoLastResponse.OK, UndoLastResponse.NOTHING_TO_UNDO), undone.message)
                changes += [undone.revision] if undone.status == UndoLastResponse.OK else []
        return changes

    def test_1_clients_of_the_planner(self):
        self.start(lines=LINES)
        before = self.state().state.revision
        with self.counted(self.clients * CALLS):
            changes = [revision for told in at_once(self.clients, self.client) for revision in told]
            after = self.state().state.revision
            self.assertEqual(sorted(changes), list(range(before + 1, after + 1)), 'a change lost, or told twice')

    def test_2_clients_of_the_detector(self):
        with self.counted(3 * self.clients):
            self.clients_of_the_detector()

    def clients_of_the_detector(self):
        detect = lambda timeout_s: lambda i: self.timed('detect', DetectBoxesRequest(timeout=timeout_s)).status
        with Flood(self.points, self.cloud, self.rate_hz):
            self.assertEqual(set(at_once(self.clients, detect(20.0))), {DetectBoxesResponse.OK})
            told = at_once(self.clients, lambda i: self.timed('calibrate', CalibrateRequest(1, 20.0)).status)
        self.assertLessEqual(set(told), {CalibrateResponse.OK, CalibrateResponse.BUSY})
        self.assertIn(CalibrateResponse.OK, told)
        time.sleep(1.0)  # the last cloud
        before = self.diagnostics.count()
        self.assertEqual(set(at_once(self.clients, detect(2.5))), {DetectBoxesResponse.TIMEOUT})
        self.assertGreater(self.diagnostics.count(), before, 'waiting clients silence the diagnostics')

    def test_3_latest_cloud_wins(self):
        came = []
        listener = rospy.Subscriber('boxes', BoxArray, lambda m: came.append((m.header.stamp, time.monotonic(), len(m.boxes))))
        with Flood(self.points, self.cloud, self.rate_hz) as flood:
            time.sleep(FLOOD_S)
        self.assertIsNotNone(self.boxes.wait_for(lambda m: m.header.stamp == flood.last, 20.0), 'the last cloud got lost')
        listener.unregister()
        with self.counted(len(flood.published)):
            self.check_flood(flood, came)

    def check_flood(self, flood, came):
        came = [(stamp, when, boxes) for stamp, when, boxes in came if stamp in flood.published]
        self.assertGreater(len(came), 5)
        self.assertTrue(all(boxes for _, _, boxes in came))
        self.assertEqual([stamp for stamp, _, _ in came], sorted({stamp for stamp, _, _ in came}), 'out of sequence')
        ages = sorted(when - flood.published[stamp] for stamp, when, _ in came[len(came) // 2:])
        self.assertLess(ages[len(ages) // 2], OLD_S, 'clouds wait in a queue')
        print('%d clouds at %d Hz, %d worked on, median age of the answers %.2f s' %
              (len(flood.published), self.rate_hz, len(came), ages[len(ages) // 2]))

    def test_4_soak(self):
        uses = [Use('detector', pid_of('/manager')), Use('planner', pid_of('/pick_planner'))]
        self.start(lines=LINES)
        with self.counted(self.cycles):
            self.soak(uses)

    def soak(self, uses):
        cloud = thinned(self.cloud)
        for name in ('choose_next_pick', 'report_pick'):  # connecting anew takes longer than the answer
            self.services[name] = rospy.ServiceProxy(self.services[name].resolved_name, self.services[name].service_class,
                                                     persistent=True)
        for cycle in range(self.cycles):
            publish(self.points, cloud)
            self.one_pick(cycle)
            if (cycle + 1) % max(1, self.cycles // LOOKS) == 0:
                last = publish(self.points, cloud)
                seen = self.boxes.wait_for(lambda m: m.header.stamp == last, 20.0)
                self.assertTrue(seen is not None and seen.boxes, 'no boxes in the last cloud of cycle %d' % cycle)
                time.sleep(0.3)
                for use in uses:
                    use.look()
                self.boxes.forget()
        for use in uses:
            print(use)
            self.assertLess(use.growth(), rospy.get_param('~growth', 0.05), use)
            self.assertLessEqual(use.threads[-1], use.threads[LOOKS // 4], use)
            self.assertLessEqual(use.files[-1], use.files[LOOKS // 4], use)

    def one_pick(self, cycle):
        choice = self.timed('choose_next_pick', ChooseNextPickRequest(type_ids=[self.rng.choice(LINES)[0]]))
        if choice.status != ChooseNextPickResponse.PICK:
            self.services['close_pallet']()
            self.start(pallet_id='soak %d' % cycle, lines=LINES)
            return
        self.assertEqual(self.timed('report_pick', ReportPickRequest(decision_id=choice.decision_id)).status, 0)


if __name__ == '__main__':
    rospy.init_node('test_load')
    rostest.rosrun('mixed_palletizing', 'load', Load, sys.argv)
