"""The contents of a folder, and whether each of its files can be opened, using the standard library only."""
import hashlib
import json
import re
import struct
import zlib

from killing import run

PNG_CHANNELS = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}
PLY_BYTES = {'char': 1, 'uchar': 1, 'short': 2, 'ushort': 2, 'int': 4, 'uint': 4, 'float': 4, 'double': 8}


def contents(folder):
    """By path, the SHA-256 of every file below the folder, and an empty string for every folder, whose path ends in a
    slash."""
    found = {}
    for path in sorted(folder.rglob('*')):
        name = path.relative_to(folder).as_posix()
        found[name + '/' if path.is_dir() else name] = '' if path.is_dir() else hashlib.sha256(path.read_bytes()).hexdigest()
    return found


def topmost(names):
    """Those of the paths, as returned by contents(), that are in none of the other folders."""
    top = []
    for name in sorted(names):
        if not any(name.startswith(other) for other in top if other.endswith('/')):
            top.append(name)
    return top


def few(names):
    names = sorted(names)
    return ', '.join(names[:3]) + (f' and {len(names) - 3} more' if len(names) > 3 else '')


def check_png(data):
    """Raises ValueError or zlib.error unless the image is complete."""
    if data[:8] != b'\x89PNG\r\n\x1a\n':
        raise ValueError('is no PNG')
    at, kind, packed = 8, b'', b''
    while kind != b'IEND':
        if len(data) < at + 12:
            raise ValueError('ends early')
        length, kind = struct.unpack('>I4s', data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if data[at + 8 + length:at + 12 + length] != struct.pack('>I', zlib.crc32(kind + body)):
            raise ValueError('has a wrong checksum')
        if kind == b'IHDR':
            width, height, bits, color = struct.unpack('>IIBB', body[:10])
        elif kind == b'IDAT':
            packed += body
        at += 12 + length
    row = 1 + (width * bits * PNG_CHANNELS[color] + 7) // 8
    if len(zlib.decompress(packed)) != height * row:
        raise ValueError('lacks rows')


def check_jpeg(data):
    if data[:2] != b'\xff\xd8' or data[-2:] != b'\xff\xd9':
        raise ValueError('is no whole JPEG')


def check_ply(data):
    header, end, body = data.partition(b'end_header\n')
    count = re.search(rb'element vertex (\d+)', header)
    if not end or not count:
        raise ValueError('has no header of a PLY')
    size = sum(PLY_BYTES[kind.decode()] for kind in re.findall(rb'property (\w+) \w+', header))
    if len(body) != int(count[1]) * size:
        raise ValueError(f'has {len(body)} bytes of points, not {int(count[1])} times {size}')


def check_pcd(data):
    header, end, body = data.partition(b'DATA binary\n')
    fields = {line.split()[0]: [int(number) for number in line.split()[1:]] for line in header.decode().splitlines()
              if line.startswith(('SIZE', 'COUNT', 'POINTS'))}
    if not end:
        raise ValueError('has no header of a PCD')
    size = sum(size * count for size, count in zip(fields['SIZE'], fields['COUNT']))
    if len(body) != fields['POINTS'][0] * size:
        raise ValueError(f'has {len(body)} bytes of points, not {fields["POINTS"][0]} times {size}')


def check_lines(data):
    for line in data.splitlines():
        json.loads(line)


CHECKS = {'.png': check_png, '.jpg': check_jpeg, '.ply': check_ply, '.pcd': check_pcd, '.json': json.loads,
          '.jsonl': check_lines}


def faults(rva, path):
    """Messages about the file, or the files and captures of the folder, that cannot be opened."""
    found = []
    for file in [path] if path.is_file() else sorted(path.rglob('*')):
        if file.is_file() and file.suffix in CHECKS:
            try:
                CHECKS[file.suffix](file.read_bytes())
            except (ValueError, KeyError, IndexError, UnboundLocalError, zlib.error) as error:
                found.append(f'{file.relative_to(path.parent)}: {error}')
        if file.name in ('capture.json', 'intrinsic.json'):
            ended = run([rva, 'info', file.parent], path.parent)
            if ended.status != 0:
                found.append(f'rva info {file.parent.relative_to(path.parent)}: {ended.last_line()}')
    return found
