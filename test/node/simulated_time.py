"""A clock and transforms as a test wants them."""
import copy
import signal
import subprocess
import threading
import time

import rosbag
import rospy
from geometry_msgs.msg import Quaternion, TransformStamped, Vector3
from rosgraph_msgs.msg import Clock
from tf2_msgs.msg import TFMessage

PERIOD_S = 0.01
HEARD_S = 0.3  # until everybody has heard of a change, on a machine with other work too
START_S = 1000000.0


class SimulatedClock:
    """Publishes /clock from the first `run` on, as fast as the steady clock; can be put forward and back, and stand still."""

    def __init__(self):
        self._publisher = rospy.Publisher('/clock', Clock, queue_size=1)
        self._lock = threading.Lock()
        self._now_s = START_S
        self._last = time.monotonic()
        self._runs = False
        self._quiet = True
        threading.Thread(target=self._publish, daemon=True).start()

    def _advance(self):
        last, self._last = self._last, time.monotonic()
        if self._runs:
            self._now_s += self._last - last

    def now(self):
        """While the clock runs no two are equal: clouds of one stamp cannot be told apart."""
        with self._lock:
            self._advance()
            return rospy.Time.from_sec(self._now_s)

    def run(self):
        with self._lock:
            self._advance()
            self._runs, self._quiet = True, False
        time.sleep(HEARD_S)

    def pause(self):
        with self._lock:
            self._advance()
            self._runs = False
        time.sleep(HEARD_S)

    def be_quiet(self):
        """Somebody else publishes now."""
        with self._lock:
            self._quiet = True

    def jump(self, seconds):
        with self._lock:
            self._now_s += seconds
        time.sleep(HEARD_S)

    def _publish(self):
        while not rospy.is_shutdown():
            time.sleep(PERIOD_S)
            with self._lock:
                self._advance()
                if not self._quiet:
                    self._publisher.publish(Clock(rospy.Time.from_sec(self._now_s)))


class Transforms:
    """Tells tf where the camera is, truly or not."""

    def __init__(self, parent, child, pose):
        self._parent, self._child, self._pose = parent, child, pose
        self._publisher = rospy.Publisher('/tf', TFMessage, queue_size=10)
        end = time.monotonic() + 20.0
        while self._publisher.get_num_connections() < 2 and time.monotonic() < end:  # detector and camera
            time.sleep(0.05)

    def message(self, stamp, parent=None, child=None, **values):
        """The true transform but for `values`: x, y, z, qx, qy, qz, qw."""
        t, q = self._pose.position, self._pose.orientation
        transform = TransformStamped()
        transform.header.stamp = stamp
        transform.header.frame_id = self._parent if parent is None else parent
        transform.child_frame_id = self._child if child is None else child
        transform.transform.translation = Vector3(values.get('x', t.x), values.get('y', t.y), values.get('z', t.z))
        transform.transform.rotation = Quaternion(values.get('qx', q.x), values.get('qy', q.y), values.get('qz', q.z),
                                                  values.get('qw', q.w))
        return TFMessage([transform])

    def send(self, stamp, **changes):
        self._publisher.publish(self.message(stamp, **changes))


class LoopedBag:
    """`rosbag play --loop --clock` of clouds with their transforms, while the `with` lasts."""
    CLOUDS, PERIOD_S = 3, 0.5

    def __init__(self, path, begin, cloud, topic, transforms):
        with rosbag.Bag(path, 'w') as bag:
            for i in range(self.CLOUDS):
                stamp = begin + rospy.Duration(i * self.PERIOD_S)
                bag.write('/tf', transforms.message(stamp - rospy.Duration(PERIOD_S)), stamp)
                bag.write('/tf', transforms.message(stamp + rospy.Duration(PERIOD_S)), stamp)
                cloud = copy.copy(cloud)
                cloud.header = copy.deepcopy(cloud.header)
                cloud.header.stamp = stamp
                bag.write(topic, cloud, stamp + rospy.Duration(PERIOD_S))
        self._command = ['rosbag', 'play', '--loop', '--clock', '--quiet', path]
        self._process = None

    def __enter__(self):
        self._process = subprocess.Popen(self._command, stdin=subprocess.DEVNULL)
        return self

    def __exit__(self, *_):
        self._process.send_signal(signal.SIGINT)
        self._process.wait(20)
