"""Databases of rosbag2 as librealsense 2.58 records them, made from numpy arrays.

After its src/media/ros2/ros2_writer.cpp and OMG's CDR; shares no code with the program.
"""
import sqlite3
import struct

import numpy as np

from bags import COLOR, DEPTH, INFRARED
from captures import CAMERA

BEFORE = -2**63  # the time of what was so before the recording began


class Cdr:
    """A message: numbers stand at multiples of their size."""

    def __init__(self):
        self.bytes = b''

    def put(self, kind, *numbers):
        for number in numbers:
            self.bytes += bytes(-len(self.bytes) % struct.calcsize(kind)) + struct.pack('<' + kind, number)
        return self

    def text(self, value):
        self.put('I', len(value.encode()) + 1)
        self.bytes += value.encode() + b'\0'
        return self

    def list(self, data):
        self.put('I', len(data))
        self.bytes += data
        return self

    def message(self):
        return b'\x00\x01\x00\x00' + self.bytes


def text(value):
    return Cdr().text(value).message()


def image_message(pixels, encoding, name='Depth', padding=0, big_endian=0):
    rows = np.ascontiguousarray(pixels).view(np.uint8).reshape(pixels.shape[0], -1)
    rows = np.pad(rows, ((0, 0), (0, padding)), constant_values=255)
    return (Cdr().put('i', 0).put('I', 0).text(name).put('I', *pixels.shape[:2]).text(encoding).put('B', big_endian)
            .put('I', rows.shape[1]).list(rows.tobytes()).message())


def zstd(data):
    """A frame of Zstandard whose blocks are stored as they are (RFC 8878, 3.1.1)."""
    most = 2**17
    blocks = [data[at:at + most] for at in range(0, len(data), most)] or [b'']
    packed = b'\x28\xb5\x2f\xfd' + b'\xa0' + struct.pack('<I', len(data))
    for i, block in enumerate(blocks):
        packed += struct.pack('<I', len(block) << 3 | (i == len(blocks) - 1))[:3] + block
    return packed


def camera_info(camera, model='Brown Conrady', coefficients=(0.0,) * 5, **other):
    values = {'width': camera.width, 'height': camera.height, 'fx': f'{camera.fx:g}', 'ppx': f'{camera.cx:g}',
              'fy': f'{camera.fy:g}', 'ppy': f'{camera.cy:g}', 'model': model,
              'coeffs': ','.join(f'{number:f}' for number in coefficients), **other}
    return text(';'.join(f'{key}={value}' for key, value in values.items() if value is not None))


def transform(translation, rotation=(1, 0, 0, 0, 1, 0, 0, 0, 1)):
    return text('rotation=' + ','.join(f'{number:f}' for number in rotation) +
                ';translation=' + ','.join(f'{number:f}' for number in translation))


class Db3:
    def __init__(self, path, pack=bytes, page_bytes=4096):
        path.unlink(missing_ok=True)
        self.database = sqlite3.connect(path)
        self.pack = pack
        self.topics = {}
        self.database.execute(f'PRAGMA page_size = {page_bytes}')
        self.database.executescript('''
            CREATE TABLE topics(id INTEGER PRIMARY KEY,name TEXT NOT NULL,type TEXT NOT NULL,
                                serialization_format TEXT NOT NULL,offered_qos_profiles TEXT NOT NULL);
            CREATE TABLE messages(id INTEGER PRIMARY KEY,topic_id INTEGER NOT NULL,timestamp INTEGER NOT NULL,
                                  data BLOB NOT NULL);
            CREATE INDEX timestamp_idx ON messages (timestamp ASC);''')
        self.add('/file_version', 0, Cdr().put('I', 4).message(), 'std_msgs/msg/UInt32')

    def add(self, topic, time_ns, message, kind='std_msgs/msg/String'):
        if topic not in self.topics:
            self.topics[topic] = self.database.execute(
                'INSERT INTO topics (name, type, serialization_format, offered_qos_profiles) VALUES (?, ?, ?, ?)',
                (topic, kind, 'cdr', '')).lastrowid
        self.database.execute('INSERT INTO messages (timestamp, topic_id, data) VALUES (?, ?, ?)',
                              (time_ns, self.topics[topic], self.pack(message)))

    def add_image(self, stream, time_ns, message, **metadata):
        self.add(f'{stream}/image/data', time_ns, message, 'sensor_msgs/msg/Image')
        if metadata:
            self.add(f'{stream}/image/metadata', time_ns,
                     text(';'.join(f'{key}={value}' for key, value in metadata.items()) + ';'))

    def finish(self):
        self.database.commit()
        self.database.close()


def write_db3(path, frames, pictures=(), unit_m=0.001, camera=CAMERA, infrared=False, counters=None, padding=0,
              pack=bytes, page_bytes=4096):
    """`frames` are 1/30 s apart; `pictures` are (depth frame that it is nearest to, pixels)."""
    db3 = Db3(path, pack, page_bytes)
    db3.add('/device_0/info', BEFORE, text('Name=RealSense D435;Serial Number=0123;Firmware Version=5.17;'
                                           'Usb Type Descriptor=3.2'))
    db3.add('/device_0/sensor_0/info', BEFORE, text('Name=Stereo Module'))
    for option, value in (('Depth_Units', unit_m), ('Stereo_Baseline', 50), ('Laser_Power', 150)):
        db3.add(f'/device_0/sensor_0/option/{option}/value', BEFORE, text(f'{value:f}'))
        db3.add(f'/device_0/sensor_0/option/{option}/description', BEFORE, text('what it does'))
    for stream in [DEPTH] + [COLOR] * bool(len(pictures)) + [INFRARED] * infrared:
        db3.add(f'{stream}/info', BEFORE, text('encoding=Z16;fps=30'))
        db3.add(f'{stream}/camera_info', BEFORE, camera_info(camera))
        db3.add(f'{stream}/tf/ref_1', BEFORE, transform((0.015 if stream == COLOR else 0.0, 0.0, 0.0)))
    counters = counters or range(100, 100 + len(frames))
    images = [(i / 30 + 0.001, DEPTH, 'mono16', frame, counters[i]) for i, frame in enumerate(frames)]
    images += [(i / 30 + 0.003, COLOR, 'rgb8', picture, i) for i, picture in pictures]
    if infrared:
        images += [(i / 30 + 0.001, INFRARED, '8UC1', (frame // 256).astype(np.uint8), i) for i, frame in enumerate(frames)]
    for time_s, stream, encoding, pixels, number in sorted(images, key=lambda image: image[0]):
        values = {'Frame number': number, 'timestamp_domain': 'Hardware Clock', 'timestamp': f'{1e3 * (500 + time_s):f}',
                  'Actual Exposure': 8500, 'Time Of Arrival': 1_700_000_000_000 + round(1e3 * time_s)}
        if stream == DEPTH:
            values['depth_units'] = f'{unit_m:f}'
        db3.add_image(stream, round(1e9 * time_s), image_message(pixels, encoding, padding=padding), **values)
    db3.finish()
    return path
