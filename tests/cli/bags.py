"""ROS bags of version 2.0 as realsense-viewer writes them, made from numpy arrays.

After wiki.ros.org/Bags/Format/2.0 and what librealsense 2.56 writes; shares no code with the program.
"""
import ctypes
import struct

import numpy as np

from captures import CAMERA

VERSION_LINE = b'#ROSBAG V2.0\n'
HEADER_BYTES = 4096
MESSAGE, FILE_HEADER, INDEX, CHUNK, CHUNK_INFO, CONNECTION = 2, 3, 4, 5, 6, 7
DEPTH, COLOR, INFRARED = ('/device_0/sensor_0/Depth_0', '/device_0/sensor_1/Color_0', '/device_0/sensor_0/Infrared_1')
COLOR_FROM_DEPTH = (0.015, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0)


def text(value):
    return struct.pack('<I', len(value)) + value.encode()


def header_fields(**fields):
    packed = b''
    for name, value in fields.items():
        field = name.encode() + b'=' + value
        packed += struct.pack('<I', len(field)) + field
    return packed


def record(data, **fields):
    header = header_fields(**fields)
    return struct.pack('<I', len(header)) + header + struct.pack('<I', len(data)) + data


def op(number):
    return bytes([number])


def u32(number):
    return struct.pack('<I', number)


def stamp(time_s):
    return struct.pack('<II', int(time_s), round(1e9 * (time_s % 1)))


def lz4(data):
    library = ctypes.CDLL('liblz4.so.1')
    library.LZ4F_compressFrameBound.restype = library.LZ4F_compressFrame.restype = ctypes.c_size_t
    packed = ctypes.create_string_buffer(library.LZ4F_compressFrameBound(ctypes.c_size_t(len(data)), None))
    size = library.LZ4F_compressFrame(packed, ctypes.c_size_t(len(packed)), data, ctypes.c_size_t(len(data)), None)
    return packed.raw[:size]


PACK = {'lz4': lz4, 'none': lambda data: data}


class Bag:
    """Writes chunk by chunk, as a recorder does; finish() writes the index."""

    def __init__(self, path, compression='lz4'):
        self.file = open(path, 'wb')
        self.compression = compression
        self.connections, self.chunks = {}, []
        self.file.write(VERSION_LINE)
        self.write_header(0)
        self.begin_chunk()

    def write_header(self, index_at):
        fields = {'op': op(FILE_HEADER), 'index_pos': struct.pack('<Q', index_at),
                  'conn_count': u32(len(self.connections)), 'chunk_count': u32(len(self.chunks))}
        padding = HEADER_BYTES - 8 - len(header_fields(**fields))
        self.file.write(record(b' ' * padding, **fields))

    def begin_chunk(self):
        self.records, self.places = b'', {}

    def connection(self, topic, kind):
        number = self.connections.setdefault(topic, (len(self.connections), kind))[0]
        return record(header_fields(topic=topic.encode(), type=kind.encode(), md5sum=b'0' * 32, message_definition=b''),
                      op=op(CONNECTION), conn=u32(number), topic=topic.encode())

    def add(self, topic, kind, time_s, message):
        if topic not in self.connections:
            self.records += self.connection(topic, kind)
        number = self.connections[topic][0]
        self.places.setdefault(number, []).append((time_s, len(self.records)))
        self.records += record(message, op=op(MESSAGE), conn=u32(number), time=stamp(time_s))

    def end_chunk(self):
        at = self.file.tell()
        self.file.write(record(PACK[self.compression](self.records), op=op(CHUNK), compression=self.compression.encode(),
                               size=u32(len(self.records))))
        for number, places in self.places.items():
            entries = b''.join(stamp(time_s) + u32(offset) for time_s, offset in places)
            self.file.write(record(entries, op=op(INDEX), ver=u32(1), conn=u32(number), count=u32(len(places))))
        self.chunks.append((at, {number: len(places) for number, places in self.places.items()}))
        self.begin_chunk()

    def finish(self):
        if self.records:
            self.end_chunk()
        index_at = self.file.tell()
        for topic, (_, kind) in self.connections.items():
            self.file.write(self.connection(topic, kind))
        for at, counts in self.chunks:
            pairs = b''.join(u32(number) + u32(count) for number, count in counts.items())
            self.file.write(record(pairs, op=op(CHUNK_INFO), ver=u32(1), chunk_pos=struct.pack('<Q', at),
                                   start_time=stamp(0), end_time=stamp(1), count=u32(len(counts))))
        self.file.seek(len(VERSION_LINE))
        self.write_header(index_at)
        self.file.close()

    def stop(self):
        """As a recorder that was killed: no index, and a last chunk that was not ended."""
        self.file.write(record(b'', op=op(CHUNK), compression=self.compression.encode(), size=u32(0)))
        self.file.write(self.records[:len(self.records) // 2])
        self.file.close()


def image_message(pixels, encoding, number, time_s, unit_m=None, padding=0):
    rows = np.ascontiguousarray(pixels).view(np.uint8).reshape(pixels.shape[0], -1)
    rows = np.pad(rows, ((0, 0), (0, padding)), constant_values=255)
    frame_id = '0' if unit_m is None else '1'
    return (u32(number) + stamp(time_s) + text(frame_id) + struct.pack('<II', *pixels.shape[:2]) + text(encoding) + b'\0' +
            u32(rows.shape[1]) + u32(rows.size) + rows.tobytes() + (b'' if unit_m is None else struct.pack('<f', unit_m)))


def camera_info(camera, model='Brown Conrady', coefficients=(0.0,) * 5):
    matrix = (camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1)
    return (bytes(12) + text('') + struct.pack('<II', camera.height, camera.width) + text(model) +
            u32(len(coefficients)) + struct.pack(f'<{len(coefficients)}d', *coefficients) + struct.pack('<9d', *matrix) +
            bytes(9 * 8 + 12 * 8 + 4 + 4 + 17))


def key_value(key, value):
    return text(key) + text(str(value))


def write_bag(path, frames, pictures=(), compression='lz4', unit_m=0.001, unit_in_frames=False, camera=CAMERA,
              frames_per_chunk=2, finish=True, infrared=False, counters=None, padding=0):
    """`frames` are 1/30 s apart; `pictures` are (depth frame that it is nearest to, pixels)."""
    bag = Bag(path, compression)
    bag.add('/file_version', 'std_msgs/UInt32', 0, u32(4 if unit_in_frames else 3))
    for key, value in (('Name', 'Intel RealSense D435'), ('Serial Number', '0123'), ('Firmware Version', '5.12'),
                       ('Usb Type Descriptor', '3.2')):
        bag.add('/device_0/info', 'diagnostic_msgs/KeyValue', 0, key_value(key, value))
    bag.add('/device_0/sensor_0/info', 'diagnostic_msgs/KeyValue', 0, key_value('Name', 'Stereo Module'))
    streams = [DEPTH] + [COLOR] * bool(len(pictures)) + [INFRARED] * infrared
    for stream in streams:
        bag.add(f'{stream}/info/camera_info', 'sensor_msgs/CameraInfo', 0, camera_info(camera))
        place = COLOR_FROM_DEPTH if stream == COLOR else ((0.0,) * 3, (0.0, 0.0, 0.0, 1.0))
        bag.add(f'{stream}/tf/1', 'geometry_msgs/Transform', 0, struct.pack('<7d', *place[0], *place[1]))
    if not unit_in_frames:
        bag.add('/device_0/sensor_0/option/Depth_Units/value', 'std_msgs/Float32', 0, struct.pack('<f', unit_m))
    bag.add('/device_0/sensor_0/option/Stereo Baseline/value', 'std_msgs/Float32', 0, struct.pack('<f', 50.0))
    bag.add('/device_0/sensor_0/option/Laser_Power/value', 'std_msgs/Float32', 0, struct.pack('<f', 150.0))
    counters = counters or range(100, 100 + len(frames))
    images = [(i / 30 + 0.001, DEPTH, 'mono16', frame, counters[i]) for i, frame in enumerate(frames)]
    images += [(i / 30 + 0.003, COLOR, 'rgb8', picture, i) for i, picture in pictures]
    if infrared:
        images += [(i / 30 + 0.001, INFRARED, '8UC1', (frame // 256).astype(np.uint8), i) for i, frame in enumerate(frames)]
    in_chunk = 0
    for time_s, stream, encoding, pixels, number in sorted(images, key=lambda image: image[0]):
        is_depth = stream == DEPTH
        if is_depth:
            if in_chunk == frames_per_chunk:
                bag.end_chunk()
                in_chunk = 0
            in_chunk += 1
        bag.add(f'{stream}/image/data', 'sensor_msgs/Image', time_s,
                image_message(pixels, encoding, number, 500 + time_s, unit_m if is_depth and unit_in_frames else None,
                              padding))
        for key, value in (('Frame Counter', number), ('Frame Timestamp', round(1e6 * (500 + time_s))),
                           ('Actual Exposure', 8500), ('Time Of Arrival', 1_700_000_000_000 + round(1e3 * time_s))):
            bag.add(f'{stream}/image/metadata', 'diagnostic_msgs/KeyValue', time_s, key_value(key, value))
    if finish:
        bag.finish()
    else:
        bag.stop()
    return path
