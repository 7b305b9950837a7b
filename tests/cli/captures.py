"""Captures on disk, made from numpy arrays, in every folder format that the program reads."""
import dataclasses
import json
import pathlib
import shutil
import struct
import zlib

import cv2
import numpy as np

IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]


@dataclasses.dataclass(frozen=True)
class Camera:
    """A pinhole; its two focal lengths differ, so that mistaking an axis shows."""
    width: int = 64
    height: int = 48
    fx: float = 60.0
    fy: float = 63.0
    cx: float = 30.25
    cy: float = 24.5

    def deproject(self, u, v, depth):
        return np.stack([(u - self.cx) / self.fx * depth, (v - self.cy) / self.fy * depth, depth], axis=-1)

    def project(self, points):
        x, y, z = np.moveaxis(np.asarray(points), -1, 0)
        return np.stack([self.fx * x / z + self.cx, self.fy * y / z + self.cy], axis=-1)

    def fields(self):
        return dataclasses.asdict(self)

    def plane(self, depth, per_column=0):
        """Depths that grow by `per_column` from left to right."""
        return np.tile(depth + per_column * np.arange(self.width, dtype=float), (self.height, 1))


CAMERA = Camera()


def with_box(depth, box, height):
    """The depths after something `height` high came to lie on columns [x, x + w), rows [y, y + h)."""
    x, y, w, h = box
    raised = depth.copy()
    raised[..., y:y + h, x:x + w] -= height
    return raised


def noisy(depth, frames, sigma, seed):
    """Frames of whole units with normal noise; a pixel of depth 0 stays unmeasured."""
    noise = np.random.default_rng(seed).normal(0, sigma, (frames, *depth.shape))
    return np.where(depth > 0, np.rint(depth + noise), 0).astype(np.uint16)


def plain_color(width, height, rgb):
    return np.full((height, width, 3), rgb, np.uint8)


def read_image(path):
    """Pixels as they are stored; colour as red, green, blue."""
    image = cv2.imread(str(path), cv2.IMREAD_UNCHANGED)
    assert image is not None, f'{path} is no image'
    return image[..., ::-1] if image.ndim == 3 else image


def write_image(path, pixels):
    path = pathlib.Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    pixels = np.asarray(pixels)
    assert cv2.imwrite(str(path), pixels[..., ::-1] if pixels.ndim == 3 else pixels)


def record_again(capture, target, copy_function=shutil.copy2):
    """A copy of a capture folder that is none to the byte, since copies are refused: one pixel of its first depth
    image differs by one step."""
    shutil.copytree(capture, target, copy_function=copy_function)
    first = min((target / 'depth').iterdir())
    image = read_image(first)
    image[0, 0] ^= 1
    first.unlink()  # it may be a link to the original
    write_image(first, image)
    return target


def write_frames(folder, frames, ending='png'):
    for i, frame in enumerate(frames):
        write_image(folder / f'{i:06d}.{ending}', frame)


def depth_fields(camera=CAMERA, unit_m=0.001):
    return {**camera.fields(), 'unit_m': unit_m}


def write_capture(folder, frames, unit_m=0.001, pictures=(), picture_ending='png', **keys):
    """A capture folder; `keys` join or replace those of capture.json."""
    folder = pathlib.Path(folder)
    write_frames(folder / 'depth', frames)
    write_frames(folder / 'color', pictures, picture_ending)
    description = {'format': 'rva-capture', 'version': 1, 'depth': depth_fields(CAMERA, unit_m), **keys}
    (folder / 'capture.json').write_text(json.dumps(description))
    return folder


def write_open3d(folder, frames, pictures=(), description='intrinsic.json', **keys):
    """A folder as Open3D's recorder and its reconstruction examples lay it out: the matrix by columns."""
    folder = pathlib.Path(folder)
    write_frames(folder / 'depth', frames)
    write_frames(folder / 'color', pictures, 'jpg')
    matrix = [CAMERA.fx, 0, 0, 0, CAMERA.fy, 0, CAMERA.cx, CAMERA.cy, 1]
    (folder / description).write_text(json.dumps(
        {'width': CAMERA.width, 'height': CAMERA.height, 'intrinsic_matrix': matrix, **keys}))
    return folder


def write_tum(folder, frames, pictures=()):
    """A TUM RGB-D folder: 5000 units a metre, lists of files by time. `pictures` holds (seconds, pixels)."""
    folder = pathlib.Path(folder)
    comments = ['# depth maps', "# file: 'made.bag'", '# timestamp filename']
    lines = list(comments)
    for i, frame in enumerate(frames):
        name = f'depth/{10 + i / 30:.6f}.png'
        write_image(folder / name, frame)
        lines.append(f'{10 + i / 30:.6f} {name}')
    (folder / 'depth.txt').write_text('\n'.join(lines) + '\n')
    if pictures:
        lines = list(comments)
        for seconds, pixels in pictures:
            write_image(folder / f'rgb/{seconds:.6f}.png', pixels)
            lines.append(f'{seconds:.6f} rgb/{seconds:.6f}.png')
        (folder / 'rgb.txt').write_text('\n'.join(lines) + '\n')
    return folder


TUM_INTRINSICS = ['--intrinsics', f'{CAMERA.fx},{CAMERA.fy},{CAMERA.cx},{CAMERA.cy}']


def png_chunk(name, data):
    return struct.pack('>I', len(data)) + name + data + struct.pack('>I', zlib.crc32(name + data))


def depth_png(width, height, compressed_rows):
    """A 16-bit grey PNG around rows that zlib has compressed already, each led by its filter byte."""
    header = struct.pack('>IIBBBBB', width, height, 16, 0, 0, 0, 0)
    return (b'\x89PNG\r\n\x1a\n' + png_chunk(b'IHDR', header) + png_chunk(b'IDAT', compressed_rows) +
            png_chunk(b'IEND', b''))


def empty_depth_png(width, height):
    """A PNG of nothing but zeros, whatever its size, without the memory for it."""
    squeeze = zlib.compressobj(9)
    row = bytes(1 + 2 * width)
    parts = [squeeze.compress(row) for _ in range(height)]
    return depth_png(width, height, b''.join(parts) + squeeze.flush())
