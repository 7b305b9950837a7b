"""Recordings of a camera's node in ROS 1 and ROS 2, made from numpy arrays; shares no code with the program."""
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


def in_metres(frames):
    """NaN where nothing was measured."""
    return np.where(frames > 0, frames / 1000, np.nan).astype(np.float32)
