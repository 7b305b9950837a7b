"""Recordings of a camera's node in ROS 1 and ROS 2, made from numpy arrays; shares no code with the program."""
import struct
import zlib

import cv2
import numpy as np

import bags
import db3s
from captures import CAMERA

DEPTH = '/camera/depth/image_rect_raw'
ALIGNED = '/camera/aligned_depth_to_color/image_raw'
COLOR = '/camera/color/image_raw'


def ros2_camera_info(camera, model='plumb_bob', coefficients=(0.0,) * 5):
    k = (camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1)
    r = (1, 0, 0, 0, 1, 0, 0, 0, 1)
    p = (camera.fx, 0, camera.cx, 0, 0, camera.fy, camera.cy, 0, 0, 0, 1, 0)
    message = (db3s.Cdr().put('i', 0).put('I', 0).text('camera_depth_optical_frame').put('I', camera.height, camera.width)
               .text(model).put('I', len(coefficients)).put('d', *coefficients, *k, *r, *p))
    return message.put('I', 0, 0, 0, 0, 0, 0).put('B', 0).message()


def namespace(topic):
    return topic[:topic.rindex('/') + 1]


def write_ros2(path, streams, infos=True):
    """`streams` are (topic, encoding, frames 1/30 s apart)."""
    db3 = db3s.Db3(path)
    for topic, encoding, frames in streams:
        for i, frame in enumerate(frames):
            time_ns = round(1e9 * (1_700_000_000 + i / 30))
            if infos:
                db3.add(namespace(topic) + 'camera_info', time_ns, ros2_camera_info(CAMERA), 'sensor_msgs/msg/CameraInfo')
            db3.add(topic, time_ns, db3s.image_message(frame, encoding, name='camera_depth_optical_frame'), 'sensor_msgs/msg/Image')
    db3.finish()
    return path


def write_ros1(path, streams, infos=True):
    bag = bags.Bag(path)
    for topic, encoding, frames in streams:
        for i, frame in enumerate(frames):
            if infos:
                bag.add(namespace(topic) + 'camera_info', 'sensor_msgs/CameraInfo', i / 30, bags.camera_info(CAMERA, 'plumb_bob'))
            bag.add(topic, 'sensor_msgs/Image', i / 30, bags.image_message(frame, encoding, i, 500 + i / 30))
    bag.finish()
    return path


def png_of(pixels):
    return cv2.imencode('.png', pixels)[1].tobytes()


def compressed_depth(frame):
    """What compressed_depth_image_transport writes for 16UC1: 12 bytes of parameters, then a PNG."""
    return '16UC1; compressedDepth png', bytes(12) + png_of(frame)


def quantised_depth(metres, quantisation=100.0, most_m=10.0):
    """The same for 32FC1: inverse depth in 16 bits (compressed_depth_image_transport, codec.cpp)."""
    a = quantisation * (quantisation + 1)
    b = 1 - a / most_m
    with np.errstate(divide='ignore', invalid='ignore'):
        stored = np.where(metres > 0, np.round(a / metres + b), 0)
    return '32FC1; compressedDepth png', struct.pack('<iff', 0, a, b) + png_of(stored.astype(np.uint16))


def compressed_color(picture, kind='jpeg'):
    return f'rgb8; {kind} compressed bgr8', cv2.imencode('.' + kind, picture[:, :, ::-1])[1].tobytes()


class Ros2:
    """Messages of ROS 2."""
    encoding = 'cdr'

    @staticmethod
    def kind(name):
        return name.replace('/', '/msg/')

    @staticmethod
    def info():
        return ros2_camera_info(CAMERA)

    @staticmethod
    def image(frame, encoding, name, number):
        return db3s.image_message(frame, encoding, name=name)

    @staticmethod
    def compressed(content, name, number):
        return db3s.Cdr().put('i', 0).put('I', 0).text(name).text(content[0]).list(content[1]).message()

    @staticmethod
    def transforms(edges):
        message = db3s.Cdr().put('I', len(edges))
        for parent, child, numbers in edges:
            message.put('i', 0).put('I', 0).text(parent).text(child).put('d', *numbers)
        return message.message()


class Ros1:
    """Messages of ROS 1."""
    encoding = 'ros1'

    @staticmethod
    def kind(name):
        return name

    @staticmethod
    def info():
        return bags.camera_info(CAMERA, 'plumb_bob')

    @staticmethod
    def header(name, number):
        return bags.u32(number) + bags.stamp(number / 30) + bags.text(name)

    @classmethod
    def image(cls, frame, encoding, name, number):
        rows = np.ascontiguousarray(frame).view(np.uint8).reshape(frame.shape[0], -1)
        return (cls.header(name, number) + struct.pack('<II', *frame.shape[:2]) + bags.text(encoding) + b'\0' +
                bags.u32(rows.shape[1]) + bags.u32(rows.size) + rows.tobytes())

    @classmethod
    def compressed(cls, content, name, number):
        return cls.header(name, number) + bags.text(content[0]) + bags.u32(len(content[1])) + content[1]

    @classmethod
    def transforms(cls, edges):
        return bags.u32(len(edges)) + b''.join(
            cls.header(parent, 0) + bags.text(child) + struct.pack('<7d', *numbers) for parent, child, numbers in edges)


def write_messages(path, ros, messages):
    """`messages` are (topic, type as ROS 1 has it, seconds, bytes). The ending of the path chooses the format."""
    ending = path.suffix
    if ending == '.bag':
        file = bags.Bag(path)
        for topic, kind, time_s, data in messages:
            file.add(topic, kind, time_s, data)
    else:
        file = db3s.Db3(path) if ending == '.db3' else Mcap(path, ros.encoding)
        for topic, kind, time_s, data in messages:
            time_ns = round(1e9 * (1_700_000_000 + time_s))
            arguments = (time_ns, data, ros.kind(kind)) if ending == '.db3' else (ros.kind(kind), time_ns, data)
            file.add(topic, *arguments)
    file.finish()
    return path


KINDS_OF_FILES = ((Ros1, 'bag'), (Ros2, 'db3'), (Ros2, 'mcap'), (Ros1, 'mcap'))


def in_metres(frames):
    """NaN where nothing was measured."""
    return np.where(frames > 0, frames / 1000, np.nan).astype(np.float32)


def mcap_text(value):
    return struct.pack('<I', len(value.encode())) + value.encode()


def mcap_record(op, content):
    return struct.pack('<BQ', op, len(content)) + content


class Mcap:
    """An MCAP file (mcap.dev/spec): messages in chunks of so many, or in none; with an index at its end, or without."""

    MAGIC = b'\x89MCAP0\r\n'
    PACKED = {'': bytes, 'lz4': bags.lz4, 'zstd': db3s.zstd}

    def __init__(self, path, encoding='cdr', messages_per_chunk=3, compression='', index=True):
        self.file, self.encoding, self.compression, self.index = open(path, 'wb'), encoding, compression, index
        self.messages_per_chunk = messages_per_chunk
        self.channels, self.pending, self.chunk_indices, self.definitions = {}, [], [], b''
        self.file.write(self.MAGIC + mcap_record(0x01, mcap_text('ros2') + mcap_text('test')))

    def add(self, topic, kind, time_ns, message):
        if topic not in self.channels:
            number = self.channels[topic] = len(self.channels) + 1
            definition = mcap_record(0x03, struct.pack('<H', number) + mcap_text(kind) + mcap_text('ros2msg') + struct.pack('<I', 0))
            definition += mcap_record(0x04, struct.pack('<HH', number, number) + mcap_text(topic) + mcap_text(self.encoding) + struct.pack('<I', 0))
            self.definitions += definition
            self.pending.append((None, None, definition))
        number = self.channels[topic]
        self.pending.append((number, time_ns, mcap_record(0x05, struct.pack('<HIQQ', number, 0, time_ns, time_ns) + message)))
        if len(self.pending) >= self.messages_per_chunk:
            self.end_chunk()

    def end_chunk(self):
        if not self.messages_per_chunk:
            self.file.write(b''.join(data for _, _, data in self.pending))
            self.pending = []
            return
        records, entries = b'', {}
        for number, time_ns, data in self.pending:
            if number is not None:
                entries.setdefault(number, []).append((time_ns, len(records)))
            records += data
        self.pending = []
        packed = self.PACKED[self.compression](records)
        content = struct.pack('<QQQI', 0, 0, len(records), zlib.crc32(records)) + mcap_text(self.compression) + struct.pack('<Q', len(packed)) + packed
        at = self.file.tell()
        chunk = mcap_record(0x06, content)
        self.file.write(chunk)
        indices, offsets = b'', b''
        for number, places in entries.items():
            offsets += struct.pack('<HQ', number, self.file.tell() + len(indices))
            listed = b''.join(struct.pack('<QQ', *place) for place in places)
            indices += mcap_record(0x07, struct.pack('<HI', number, len(listed)) + listed)
        self.file.write(indices)
        self.chunk_indices.append(mcap_record(0x08, struct.pack('<QQQQI', 0, 0, at, len(chunk), len(offsets)) + offsets + struct.pack('<Q', len(indices)) +
                                              mcap_text(self.compression) + struct.pack('<QQ', len(packed), len(records))))

    def finish(self):
        if self.pending:
            self.end_chunk()
        self.file.write(mcap_record(0x0F, struct.pack('<I', 0)))
        summary_at = self.file.tell() if self.index else 0
        if self.index:
            self.file.write(self.definitions + b''.join(self.chunk_indices))
        self.file.write(mcap_record(0x02, struct.pack('<QQI', summary_at, 0, 0)) + self.MAGIC)
        self.file.close()


def write_mcap(path, streams, infos=True, encoding='cdr', **options):
    mcap = Mcap(path, encoding, **options)
    ros1 = encoding == 'ros1'
    for i in range(max(len(frames) for _, _, frames in streams)):
        for topic, pixels, frames in streams:
            time_ns = round(1e9 * (1_700_000_000 + i / 30))
            if infos:
                info = bags.camera_info(CAMERA, 'plumb_bob') if ros1 else ros2_camera_info(CAMERA)
                mcap.add(namespace(topic) + 'camera_info', 'sensor_msgs/CameraInfo' if ros1 else 'sensor_msgs/msg/CameraInfo', time_ns, info)
            if i < len(frames):
                image = bags.image_message(frames[i], pixels, i, i / 30) if ros1 else db3s.image_message(frames[i], pixels)
                mcap.add(topic, 'sensor_msgs/Image' if ros1 else 'sensor_msgs/msg/Image', time_ns, image)
    mcap.finish()
    return path
