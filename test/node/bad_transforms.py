"""Transforms as nobody should publish them, and what the detector must answer to the clouds after them."""
import threading

import rospy
from mixed_palletizing.srv import DetectBoxesResponse

BASE, CAMERA = 'aruco_base', 'zivid_optical_frame'
OK, NO_FRAME = DetectBoxesResponse.OK, DetectBoxesResponse.NOT_CALIBRATED
NAN, INF = float('nan'), float('inf')


class BadTransforms:
    """For a test with a `clock`, transforms `tf` and `boxes_of`."""

    def check_no_frame(self, stamp, frame=CAMERA):
        answer = self.boxes_of(stamp, frame)
        self.assertEqual(answer.status, NO_FRAME, answer.message)
        self.assertIn('no_transform: ', answer.message)
        self.assertGreater(len(answer.message), len('no_transform: '))

    def fault(self, **changes):
        """A transform that tells nothing, and a cloud after it."""
        def check():
            now = self.clock.now()
            self.tf.send(now, **changes)
            self.check_no_frame(now)
        return check

    def late(self):
        now = self.clock.now()
        threading.Timer(0.15, lambda: self.tf.send(now)).start()
        self.assertEqual(self.boxes_of(now).status, OK)

    def far_away(self):
        now = self.clock.now()
        self.tf.send(now, x=1e9, z=-1e9)
        answer = self.boxes_of(now)
        self.assertIn(answer.status, (OK, DetectBoxesResponse.FAILED), answer.message)
        self.assertFalse(answer.boxes.boxes)

    def other_parent(self):
        now = self.clock.now()
        self.tf.send(now, parent='elsewhere')
        self.check_no_frame(now)
        self.tf.send(now, parent=BASE, child='elsewhere', x=0.0, y=0.0, z=0.0, qx=0.0, qy=0.0, qz=0.0, qw=1.0)
        self.assertEqual(self.boxes_of(now).status, OK)

    def each_others_parent(self):
        now = self.clock.now()
        self.tf.send(now, parent=CAMERA, child=BASE)
        self.tf.send(now)
        answer = self.boxes_of(now)
        self.assertIn(answer.status, (OK, NO_FRAME), answer.message)
        self.clock.jump(0.1)

    def bad_transforms(self):
        second = rospy.Duration(1.0)
        return {
            'frame nobody knows': lambda: self.check_no_frame(self.clock.now(), 'never heard of'),
            'late transform': self.late,
            'no transform for this time': lambda: self.check_no_frame(self.clock.now() + 5 * second),
            'stale transform': lambda: self.check_no_frame(self.clock.now() + 600 * second),
            'cloud older than tf remembers': lambda: self.check_no_frame(self.clock.now() - 600 * second),
            'NaN in the place': self.fault(x=NAN), 'Inf in the place': self.fault(z=INF),
            'NaN in the rotation': self.fault(qw=NAN), 'rotation of zeros': self.fault(qx=0.0, qy=0.0, qz=0.0, qw=0.0),
            'rotation of length two': self.fault(qx=2.0, qy=0.0, qz=0.0, qw=0.0),
            'no parent': self.fault(parent=''), 'no child': self.fault(child=''), 'own parent': self.fault(parent=CAMERA),
            'camera far away': self.far_away, 'other parent': self.other_parent,
            "each other's parent": self.each_others_parent}
