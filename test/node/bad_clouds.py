"""Clouds as no camera should send them, by the reason the detector must name; and odd ones it must stand."""
import copy
import struct

import numpy
import rospy
from sensor_msgs.msg import PointCloud2, PointField

LAYOUTS = ('xyz', 'xyzrgba_float32', 'xyzrgba_uint32', 'xyzcrgb')
LARGEST = 2 ** 32 - 1


def with_layout(cloud, layout):
    """A cloud of x, y, z, rgba (16 bytes a point) in another layout of the drivers."""
    points = _points(cloud)
    names = {'xyz': ('x', 'y', 'z'), 'xyzcrgb': ('x', 'y', 'z', 'contrast', 'rgb')}.get(layout, ('x', 'y', 'z', 'rgba'))
    out = numpy.zeros((cloud.height, cloud.width, 4 if layout == 'xyz' else len(names)), numpy.float32)
    out[:, :, :3] = points[:, :, :3]
    if layout != 'xyz':
        out[:, :, -1] = points[:, :, 3]
    fields = [PointField(name, 4 * i, PointField.FLOAT32, 1) for i, name in enumerate(names)]
    if layout == 'xyzrgba_uint32':
        fields[-1].datatype = PointField.UINT32
    step = 4 * out.shape[2]
    return replaced(cloud, fields=fields, point_step=step, row_step=step * cloud.width, data=out.tobytes())


def replaced(cloud, **values):
    """A copy of the cloud with other values; the data is shared unless given."""
    other = copy.copy(cloud)
    other.header = copy.deepcopy(cloud.header)
    other.fields = copy.deepcopy(cloud.fields)
    for name, value in values.items():
        setattr(other, name, value)
    return other


def with_points(cloud, change):
    """`change` gets the points (height, width, floats of a point), changes them or returns others."""
    points = _points(cloud).copy()
    changed = change(points)
    return replaced(cloud, data=(points if changed is None else changed).astype(numpy.float32).tobytes())


def set_all(value):
    def change(points):
        points[:, :, :3] = value
    return change


def _points(cloud):
    return numpy.frombuffer(cloud.data, numpy.float32).reshape(cloud.height, cloud.width, cloud.point_step // 4)


def _with_header(cloud, **values):
    other = replaced(cloud)
    for name, value in values.items():
        setattr(other.header, name, value)
    return other


def _with_field(cloud, index, **values):
    other = replaced(cloud)
    for name, value in values.items():
        setattr(other.fields[index], name, value)
    return other


def _scaled(factor):
    def change(points):
        points[:, :, :3] *= numpy.float32(factor)
    return change


def _negated(axis):
    def change(points):
        points[:, :, axis] *= -1
    return change


def _shuffled(points):
    flat = points.reshape(-1, points.shape[2])
    return flat[numpy.random.RandomState(1).permutation(len(flat))].reshape(points.shape)


def faults_of_layout(cloud):
    """(name, reason, cloud): messages whose numbers contradict each other or the camera's promise."""
    yield 'no frame', 'no_frame', _with_header(cloud, frame_id='')
    yield '0 x 0', 'empty', replaced(cloud, height=0, width=0, row_step=0, data=b'')
    yield 'width 0', 'empty', replaced(cloud, width=0)
    yield 'height 0', 'empty', replaced(cloud, height=0)
    yield 'one row', 'unorganized', replaced(cloud, height=1, width=cloud.width * cloud.height,
                                             row_step=cloud.row_step * cloud.height)
    yield 'one column', 'unorganized', replaced(cloud, height=cloud.width * cloud.height, width=1,
                                                row_step=cloud.point_step)
    yield 'big endian', 'big_endian', replaced(cloud, is_bigendian=True)
    yield 'row_step 0', 'wrong_row_step', replaced(cloud, row_step=0)
    yield 'row_step short by one', 'wrong_row_step', replaced(cloud, row_step=cloud.row_step - 1)
    yield 'row_step stale', 'wrong_data_size', replaced(cloud, row_step=cloud.row_step * 2)
    yield 'row_step 2^32 - 1', 'wrong_data_size', replaced(cloud, row_step=LARGEST)
    yield 'point_step 2^32 - 1', 'wrong_row_step', replaced(cloud, point_step=LARGEST)
    yield 'point_step 0', 'field_outside_step', replaced(cloud, point_step=0)
    yield 'point_step 8', 'field_outside_step', replaced(cloud, point_step=8)
    yield 'point_step 11', 'field_outside_step', replaced(cloud, point_step=11)
    yield 'width 2^32 - 1', 'wrong_row_step', replaced(cloud, width=LARGEST)
    yield 'height 2^32 - 1', 'wrong_data_size', replaced(cloud, height=LARGEST)
    yield 'both 2^32 - 1', 'wrong_row_step', replaced(cloud, width=LARGEST, height=LARGEST)
    yield 'data short by one', 'wrong_data_size', replaced(cloud, data=cloud.data[:-1])
    yield 'half the data', 'wrong_data_size', replaced(cloud, data=cloud.data[:len(cloud.data) // 2])
    yield 'no data', 'wrong_data_size', replaced(cloud, data=b'')
    yield 'data long by one', 'wrong_data_size', replaced(cloud, data=cloud.data + b'\0')


def faults_of_fields(cloud):
    """(name, reason, cloud): lists of fields that cannot be read."""
    yield 'no fields', 'missing_field', replaced(cloud, fields=[])
    for axis in 'xyz':
        yield 'no ' + axis, 'missing_field', replaced(cloud, fields=[f for f in cloud.fields if f.name != axis])
    yield 'capital X', 'missing_field', _with_field(cloud, 0, name='X')
    yield 'nameless z', 'missing_field', _with_field(cloud, 2, name='')
    for name in [f.name for f in cloud.fields if f.name != 'contrast']:
        twice = list(cloud.fields) + [f for f in cloud.fields if f.name == name]
        yield name + ' twice', 'doubled_field', replaced(cloud, fields=twice)
    for index in range(3):
        yield f'field {index} FLOAT64', 'wrong_field_type', _with_field(cloud, index, datatype=PointField.FLOAT64)
    yield 'integer y', 'wrong_field_type', _with_field(cloud, 1, datatype=PointField.INT32)
    yield 'type 0', 'wrong_field_type', _with_field(cloud, 2, datatype=0)
    yield 'type 255', 'wrong_field_type', _with_field(cloud, 0, datatype=255)
    for count in (0, 3, LARGEST):
        yield f'count {count}', 'wrong_field_count', _with_field(cloud, 0, count=count)
    yield 'offset past the step', 'field_outside_step', _with_field(cloud, 2, offset=cloud.point_step)
    yield 'offset across the step', 'field_outside_step', _with_field(cloud, 2, offset=cloud.point_step - 3)
    yield 'offset 2^32 - 1', 'field_outside_step', _with_field(cloud, 0, offset=LARGEST)
    if cloud.fields[-1].name in ('rgb', 'rgba'):
        yield 'colour as FLOAT64', 'wrong_field_type', _with_field(cloud, -1, datatype=PointField.FLOAT64)
        yield 'colour past the step', 'field_outside_step', _with_field(cloud, -1, offset=cloud.point_step)


def faults_of_content(cloud):
    """(name, reason, cloud): numbers in order, points impossible."""
    yield 'all NaN', 'no_data', with_points(cloud, set_all(numpy.nan))
    yield 'all infinite', 'no_data', with_points(cloud, set_all(numpy.inf))
    yield 'all minus infinite', 'no_data', with_points(cloud, set_all(-numpy.inf))
    yield 'all zero', 'implausible_scale', with_points(cloud, set_all(0.0))
    yield 'all 1e38', 'implausible_scale', with_points(cloud, set_all(1e38))
    yield 'all -1e38', 'implausible_scale', with_points(cloud, set_all(-1e38))
    yield 'all denormal', 'implausible_scale', with_points(cloud, set_all(1e-40))
    yield 'millimetres', 'implausible_scale', with_points(cloud, _scaled(1000))
    yield 'kilometres', 'implausible_scale', with_points(cloud, _scaled(0.001))
    yield 'behind the camera', 'implausible_scale', with_points(cloud, _negated(2))
    yield 'x mirrored', 'mirrored', with_points(cloud, _negated(0))
    yield 'y mirrored', 'mirrored', with_points(cloud, _negated(1))
    yield 'columns mirrored', 'mirrored', with_points(cloud, lambda p: p[:, ::-1])
    yield 'turned by half', 'mirrored', with_points(cloud, lambda p: p[::-1, ::-1])
    yield 'shuffled', 'mirrored', with_points(cloud, _shuffled)


def odd_clouds(cloud):
    """(name, cloud): sound by the rules, hard on a detector. They are answered, with whatever boxes."""
    def first_only(points):
        z = points[0, 0, :3].copy()
        points[:, :, :3] = numpy.nan
        points[points.shape[0] // 2, points.shape[1] // 2, :3] = numpy.where(numpy.isfinite(z), z, 1.0)

    def checkerboard(points):
        points[(numpy.indices(points.shape[:2]).sum(axis=0) % 2) == 0, :3] = numpy.nan

    def columns(points):
        points[:, ::3, :3] = numpy.nan

    def noise(points):
        points[:, :, 2] += numpy.random.RandomState(2).normal(0.0, 0.3, points.shape[:2])

    def spikes(points):
        points[::37, ::41, 2] = 1e30

    def flat(points):
        points[:, :, 2] = numpy.nanmedian(points[:, :, 2])

    def steps(points):
        points[:, :, 2] = numpy.round(points[:, :, 2] / 0.05) * 0.05

    def near(points):
        points[:, :, :3] *= numpy.float32(0.02)

    def far(points):
        points[:, :, :3] *= numpy.float32(20.0)

    for name, change in (('one point', first_only), ('checkerboard', checkerboard), ('every third column', columns),
                         ('noise of 0.3 m', noise), ('spikes of 1e30', spikes), ('all at one depth', flat),
                         ('steps of 5 cm', steps), ('near', near), ('far', far)):
        yield name, with_points(cloud, change)
    yield 'fields in reverse', replaced(cloud, fields=list(reversed(cloud.fields)))
    rows = [cloud.data[i * cloud.row_step:(i + 1) * cloud.row_step] + b'\xff' * 13 for i in range(cloud.height)]
    yield 'padded rows', replaced(cloud, row_step=cloud.row_step + 13, data=b''.join(rows))
    unaligned = [b'\xff' + point for point in struct.unpack(f'{cloud.point_step}s' * (cloud.width * cloud.height),
                                                              cloud.data)]
    fields = copy.deepcopy(cloud.fields)
    for field in fields:
        field.offset += 1
    yield 'unaligned points', replaced(cloud, fields=fields, point_step=cloud.point_step + 1,
                                       row_step=cloud.row_step + cloud.width, data=b''.join(unaligned))
    many = list(cloud.fields) + [PointField(f'extra{i}', 0, PointField.UINT8, 1) for i in range(500)]
    yield '500 more fields', replaced(cloud, fields=many)
    yield 'a frame nobody knows', _with_header(cloud, frame_id='a_frame_nobody_knows')
    yield 'a frame of 100 kB', _with_header(cloud, frame_id='x' * 100000)
    yield 'stamp 0', _with_header(cloud, stamp=rospy.Time(0))
    yield 'stamp of tomorrow', _with_header(cloud, stamp=rospy.Time.now() + rospy.Duration(86400))
    yield 'the largest stamp', _with_header(cloud, stamp=rospy.Time(LARGEST, 999999999))
