"""`.db3` files of realsense-viewer, from end to end.

usage: db3_test.py RVA
"""
import glob
import json
import os
import shutil
import sqlite3

import numpy as np

import program
from bags import COLOR, DEPTH, write_bag
from captures import CAMERA, noisy, plain_color, read_image, with_box
from db3s import BEFORE, Cdr, Db3, camera_info, image_message, text, transform, write_db3, zstd
from simulations import contents, depth_frames

FRAMES = 5
RED = plain_color(CAMERA.width, CAMERA.height, (200, 30, 40))
BLUE = plain_color(CAMERA.width, CAMERA.height, (40, 30, 200))


class Db3Test(program.ProgramTest):
    def setUp(self):
        super().setUp()
        self.frames = noisy(CAMERA.plane(1000, per_column=2), FRAMES, 1.0, seed=1)
        self.db3 = self.folder / 'a recording?#100%.db3'

    def write(self, **options):
        return write_db3(self.db3, self.frames, **options)

    def record(self, frames, *options):
        self.succeed('record', '--camera', f'replay:{self.db3}', '--frames', frames, '--out', self.out, *options)
        return self.out


class Reading(Db3Test):
    def test_frames_are_those_that_were_written(self):
        for options in ({}, {'pack': zstd}, {'padding': 10}, {'page_bytes': 512}):
            with self.subTest(options):
                self.write(**options)
                np.testing.assert_array_equal(depth_frames(self.record(FRAMES, '--overwrite')), self.frames)

    def test_is_described_as_a_bag_of_the_same(self):
        pictures = [(1, RED), (4, BLUE)]
        bag = write_bag(self.folder / 'same.bag', self.frames, pictures, unit_m=0.0001, counters=[7, 8, 11, 12, 14])
        self.write(pictures=pictures, unit_m=0.0001, counters=[7, 8, 11, 12, 14])
        of_bag, of_db3 = self.info(bag), self.info(self.db3)
        self.assertEqual((of_db3['camera'].pop('model'), of_db3['camera'].pop('firmware')), ('RealSense D435', '5.17'))
        for key in ('model', 'firmware'):
            of_bag['camera'].pop(key)
        of_bag['camera']['settings'] = of_db3['camera']['settings']
        self.assertEqual(of_db3, {**of_bag, 'format': 'db3'})
        self.assertEqual(of_db3['camera']['settings']['Stereo Module'],
                         {'Depth Units': 0.0001, 'Laser Power': 150, 'Stereo Baseline': 50})
        self.assertEqual(self.recorded(bag), self.recorded(self.db3))

    def recorded(self, file):
        out = self.folder / f'of {file.suffix}'
        self.succeed('record', '--camera', f'replay:{file}', '--frames', FRAMES, '--out', out)
        return {name: content for name, content in contents(out).items() if str(name).endswith('.png')}

    def test_infrared_is_kept(self):
        self.write(infrared=True)
        self.record(FRAMES)
        mean = np.mean(np.stack(self.frames[:FRAMES]) // 256, axis=0)
        np.testing.assert_allclose(read_image(self.out / 'infrared' / '000000.png') / 256, mean, atol=0.5 / 256)

    def test_detects_against_a_bag(self):
        initial = write_bag(self.folder / 'initial.bag', self.frames)
        self.frames = noisy(with_box(CAMERA.plane(1000, per_column=2), (20, 10, 11, 7), 60), FRAMES, 1.0, seed=2)
        found = self.detect(initial, self.write(), '--method', 'gaussian')['detections']
        self.assertEqual(len(found), 1)

    def test_the_file_and_its_folder_stay_as_they_are(self):
        before = self.write().read_bytes()
        os.chmod(self.db3, 0o444)
        os.chmod(self.folder, 0o555)
        try:
            self.info(self.db3)
        finally:
            os.chmod(self.folder, 0o755)
        self.assertEqual(self.db3.read_bytes(), before)
        self.assertEqual([path.name for path in self.folder.iterdir()], [self.db3.name])


class Stopped(Db3Test):
    def test_every_cut_gives_frames_that_are_whole_or_a_sentence(self):
        whole = self.write().read_bytes()
        read = 0
        for size in range(0, len(whole), max(1, len(whole) // 40)):
            self.db3.write_bytes(whole[:size])
            done = self.rva('info', self.db3, '--json')
            if done.returncode == 0:
                read += 1
                self.assertIn('notes', json.loads(done.stdout))
            else:
                self.assertEqual(done.returncode, 1, done.stderr)
                self.check_line(done.stderr, [self.db3])

    def test_damaged_pages(self):
        whole = self.write().read_bytes()
        for at in range(100, len(whole), len(whole) // 40):
            self.db3.write_bytes(whole[:at] + b'\xff' * 50 + whole[at + 50:])
            done = self.rva('info', self.db3, '--json')
            self.assertIn(done.returncode, (0, 1), done.stderr)
            if done.returncode == 1:
                self.check_line(done.stderr, [self.db3])

    def test_what_a_recorder_had_not_yet_moved_into_the_file(self):
        self.write()
        database = sqlite3.connect(self.db3)
        database.execute('pragma journal_mode = wal')
        messages = database.execute('select id, topic_id, timestamp, data from messages').fetchall()
        database.execute('delete from messages')
        database.commit()
        database.execute('pragma wal_checkpoint(truncate)')
        database.executemany('insert into messages (id, topic_id, timestamp, data) values (?, ?, ?, ?)', messages)
        database.commit()
        killed = self.folder / 'killed'
        killed.mkdir()
        for file in self.folder.glob(f'{glob.escape(self.db3.name)}*'):
            shutil.copy(file, killed)
        database.close()
        self.db3 = killed / self.db3.name
        log = self.db3.with_name(self.db3.name + '-wal')
        before = self.db3.read_bytes(), log.read_bytes()
        np.testing.assert_array_equal(depth_frames(self.record(FRAMES)), self.frames)
        self.assertEqual((self.db3.read_bytes(), log.read_bytes()), before)
        log.unlink()
        self.check_fails('info', self.db3, names=[self.db3])

    def test_a_change_that_was_begun_and_not_ended(self):
        self.write()
        self.db3.with_name(self.db3.name + '-journal').write_bytes(b'not yet')
        self.assertIn('stopped', self.info(self.db3)['notes'][0])


class Refused(Db3Test):
    def check(self, *names):
        self.check_fails('info', self.db3, names=[self.db3, *names])

    def test_what_is_no_recording(self):
        sqlite3.connect(self.db3).executescript('create table inspection (id integer)').connection.close()
        self.check('topics and messages')
        self.db3.write_bytes(b'SQLite format 3\0')
        self.check()
        self.db3.write_bytes(b'SQLite format 3\0' + bytes(5000))
        self.check()

    def test_a_view_that_never_ends(self):
        self.write()
        database = sqlite3.connect(self.db3)
        database.executescript('''drop table messages; create view messages as with recursive more(id) as
            (select 1 union all select id + 1 from more) select id, 1 as topic_id, 0 as timestamp, x'00' as data from more''')
        database.close()
        self.check('topics and messages')

    def test_other_recorders(self):
        db3 = Db3(self.db3)
        db3.add('/camera/depth/image_rect_raw', 0, image_message(self.frames[0], '16UC1'), 'sensor_msgs/msg/Image')
        db3.finish()
        self.check('/camera/depth/camera_info', 'intrinsics')

    def test_colour_only(self):
        db3 = Db3(self.db3)
        db3.add_image(COLOR, 0, image_message(RED, 'rgb8'))
        db3.finish()
        self.check(COLOR, 'depth')

    def test_depth_that_cannot_be(self):
        sound = image_message(self.frames[0], 'mono16')
        info = camera_info(CAMERA)
        too_wide = Cdr().put('i', 0).put('I', 0).text('').put('I', 48, 2**31).message()
        for message, described, name in (
                (sound, None, 'camera_info'), (sound[:-10], info, 'early'), (too_wide, info, 'side'),
                (image_message(self.frames[0], '32FC1'), info, 'fewer bytes'),
                (image_message(self.frames[0], '64FC1'), info, '64FC1'),
                (image_message(self.frames[0], 'mono16', big_endian=1), info, 'big-endian'),
                (b'\x00\x00' + sound[2:], info, 'little-endian'), (b'', info, 'little-endian'),
                (zstd(sound)[:-50], info, 'decompressed'), (b'\x28\xb5\x2f\xfd\xa0\xff\xff\xff\xff', info, 'decompressed'),
                (image_message(self.frames[0][:-1], 'mono16'), info, '64x47'),
                (sound, camera_info(CAMERA, 'Kannala Brandt4', (0.1,) * 5), 'kannala_brandt4'),
                (sound, camera_info(CAMERA, fx=None), 'fx'), (sound, camera_info(CAMERA, fx='nan'), 'fx'),
                (sound, camera_info(CAMERA, fx='1,2'), 'fx'), (sound, camera_info(CAMERA, width=-3), 'side')):
            with self.subTest(name):
                db3 = Db3(self.db3)
                if described:
                    db3.add(f'{DEPTH}/camera_info', BEFORE, described)
                db3.add_image(DEPTH, 0, message)
                db3.finish()
                self.check(name)

    def test_transforms_that_cannot_be(self):
        for stated in (transform((0, 0, 0), (1, 0, 0, 0, 1, 0, 0, 0, -1)), transform((0, 0)), text('rotation=1'),
                       transform((0, 0, 0), (2, 0, 0, 0, 1, 0, 0, 0, 1))):
            db3 = Db3(self.db3)
            for stream, message in ((DEPTH, image_message(self.frames[0], 'mono16')), (COLOR, image_message(RED, 'rgb8'))):
                db3.add(f'{stream}/camera_info', BEFORE, camera_info(CAMERA))
                db3.add(f'{stream}/tf/ref_0', BEFORE, stated)
                db3.add_image(stream, 0, message)
            db3.finish()
            self.check()

    def test_a_unit_that_changes(self):
        db3 = Db3(self.db3)
        db3.add(f'{DEPTH}/camera_info', BEFORE, camera_info(CAMERA))
        for i, unit_m in enumerate((0.001, 0.0001)):
            db3.add_image(DEPTH, i, image_message(self.frames[0], 'mono16'), depth_units=unit_m)
        db3.finish()
        self.check('unit')


if __name__ == '__main__':
    program.main()
