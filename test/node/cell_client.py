"""What the rostests share: the simulated camera, waiting, and orders."""
import threading
import time

import rospy
from sensor_msgs.msg import PointCloud2
from std_srvs.srv import Empty

from geometry_msgs.msg import Vector3
from mixed_palletizing.msg import BoxArray, OrderLine


ARRIVAL_S = 0.15  # from the call of a service until it waits for a cloud


class Latest:
    """The messages of one topic, to be waited for."""

    def __init__(self, topic, kind):
        self._messages = []
        self._arrived = threading.Condition()
        self._subscriber = rospy.Subscriber(topic, kind, self._add, queue_size=50)

    def _add(self, message):
        with self._arrived:
            self._messages.append(message)
            self._arrived.notify_all()

    def wait_for(self, condition, timeout_s):
        """First message, past or coming, that fulfils the condition; None when none comes in time."""
        with self._arrived:
            found = lambda: next((m for m in self._messages if condition(m)), None)
            self._arrived.wait_for(lambda: found() is not None, timeout_s)
            return found()

    def all(self):
        with self._arrived:
            return list(self._messages)

    def count(self):
        with self._arrived:
            return len(self._messages)

    def forget(self):
        with self._arrived:
            self._messages.clear()

    def close(self):
        self._subscriber.unregister()
        self.forget()

    def connected(self, timeout_s=20.0):
        end = time.monotonic() + timeout_s  # simulated time may stand still
        while self._subscriber.get_num_connections() == 0 and time.monotonic() < end:
            time.sleep(0.05)
        return self._subscriber.get_num_connections() > 0


def answer_to_cloud(service, publisher, cloud):
    """Answer of a service that waits for a cloud, and gets this one until it answers."""
    answers = []
    caller = threading.Thread(target=lambda: answers.append(service()), daemon=True)
    caller.start()
    while caller.is_alive():
        time.sleep(ARRIVAL_S)
        publisher.publish(cloud)
        caller.join(5.0)
    return answers[0]


def capture(timeout_s=30.0):
    """One cloud of the simulated camera."""
    clouds = Latest('zivid_camera/points/xyzrgba', PointCloud2)
    assert clouds.connected(), 'the camera does not publish'
    rospy.wait_for_service('zivid_camera/capture', timeout_s)
    rospy.ServiceProxy('zivid_camera/capture', Empty)()
    cloud = clouds.wait_for(lambda m: True, timeout_s)
    assert cloud is not None, 'the camera gave no cloud'
    return cloud


def truth(timeout_s=10.0):
    """The boxes in the pick area, in the base frame."""
    return rospy.wait_for_message('zivid_camera/truth', BoxArray, timeout_s)


def order_line(type_id, size_mm, count, rotations=OrderLine.NONE):
    return OrderLine(type_id=type_id, size=Vector3(*(s / 1000.0 for s in size_mm)), count=count,
                     rotations=rotations)
