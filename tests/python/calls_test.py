"""Errors, interruption, and other threads during a call."""
import os
import signal
import sys
import threading

import scenes

import rva


class Calls(scenes.Captured):
    def check_same_sentence(self, flags, arguments):
        """The program and Python refuse with one sentence; options are named as each of them names them."""
        out = self.folder / 'refused'
        expected = self.fail_with('detect', self.before, self.after, '--out', out, *flags)
        with self.assertRaises(rva.UsageError) as caught:
            rva.detect(self.before, self.after, out=out, **arguments)
        flag, _, rest = expected.partition(':')
        self.assertEqual(str(caught.exception), flag.removeprefix('--').replace('-', '_') + ':' + rest)
        self.assertFalse(out.exists())

    def test_errors_are_the_sentences_of_the_program(self):
        missing, empty = self.folder / 'missing', self.folder / 'empty'
        empty.mkdir()
        broken = self.folder / 'broken'
        broken.mkdir()
        (broken / 'capture.json').write_text('{"format": 1')
        for folder in (missing, empty, broken, self.folder / 'bä\nd'):
            with self.subTest(folder):
                expected = self.fail_with('info', folder)
                for call in (rva.open, rva.info, rva.noise, lambda path: rva.detect(self.before, path)):
                    with self.assertRaises(rva.Error) as caught:
                        call(folder)
                    self.assertEqual(str(caught.exception), expected)
        error = caught.exception
        self.assertEqual(str(error), f'{error.source}: {error.problem}; {error.remedy}')

    def test_the_same_capture_twice(self):
        expected = self.fail_with('detect', self.before, self.before, '--out', self.folder / 'twice')
        for after in (self.before, rva.open(self.before)):
            with self.assertRaises(rva.Error) as caught:
                rva.detect(self.before, after)
            self.assertEqual(str(caught.exception), expected)

    def test_refused_calibrations(self):
        out = self.folder / 'robot.json'
        self.addCleanup(out.unlink)
        for captures in ([self.before], [self.before, self.before], [self.before, self.after]):
            expected = self.fail_with('calibrate', *captures, '--out', out)
            with self.assertRaises(rva.Error) as caught:
                rva.calibrate(captures, out)
            self.assertEqual(str(caught.exception), expected)
        out.write_text('{}')
        for overwrite, flags in ((False, ()), (True, ('--overwrite',))):
            expected = self.fail_with('calibrate', self.before, '--out', out, *flags)
            with self.assertRaises(rva.Error) as caught:
                rva.calibrate([self.before], out, overwrite=overwrite)
            self.assertEqual(str(caught.exception), expected.replace('--overwrite', 'overwrite=True'))

    def test_arguments_out_of_range(self):
        self.check_same_sentence(('--false-findings', -1), {'false_findings': -1})
        self.check_same_sentence(('--within', '900,0,1,1'), {'within': [(900, 0, 1, 1)]})
        self.check_same_sentence(('--intrinsics', '0,1,1,1'), {'intrinsics': (0, 1, 1, 1)})
        for arguments in ({'method': 'best'}, {'depth_unit': 0}, {'model': 'a.onnx'}, {'classify': True, 'classifier': 'c.json'}):
            with self.assertRaises(rva.UsageError, msg=arguments):
                rva.detect(self.before, self.after, **arguments)
        with self.assertRaisesRegex(rva.UsageError, 'none of after the work'):
            rva.detect(self.before, [])
        with self.assertRaisesRegex(rva.UsageError, 'give these to rva.open'):
            rva.detect(rva.open(self.before), self.after, depth_unit=1.0)
        with self.assertRaisesRegex(rva.UsageError, 'bmp is not a format; give ply'):
            rva.export(self.before, 'bmp', self.folder / 'none')
        with self.assertRaisesRegex(rva.Error, 'frames'):
            rva.simulate(scenes.SCENE, self.folder / 'none', frames=0)

    def test_arguments_of_another_type(self):
        for arguments in ({'frames': 1.5}, {'frames': 'two'}, {'within': '0,0,1,1'}, {'ignore': 5}, {'min_blob': None}):
            with self.assertRaisesRegex(TypeError, rf'^{next(iter(arguments))}: .* help\(rva.detect\)'):
                rva.detect(self.before, self.after, **arguments)
        with self.assertRaisesRegex(TypeError, 'has no argument minblob; help'):
            rva.detect(self.before, self.after, minblob=3)
        with self.assertRaisesRegex(TypeError, 'neither a path nor an rva.Capture'):
            rva.detect(self.before, 5)
        with self.assertRaises(TypeError):
            rva.detect(self.before)
        with self.assertRaises(TypeError):
            rva.Capture()

    def test_frames_that_are_not_there(self):
        capture = rva.open(self.before)
        for i in (len(capture), -len(capture) - 1):
            with self.assertRaises(IndexError):
                capture.depth(i)
        with self.assertRaises(IndexError):
            capture.color(capture.color_frames)
        with self.assertRaises(rva.UsageError):
            capture.infrared_of(0, 'middle')

    def test_options_without_effect_are_warned_of(self):
        result = rva.detect(self.before, self.after, method='constant', sigmas=3)
        self.assertIn("sigmas has no effect with method='constant'", result.warnings)
        self.assertIn("warning: sigmas has no effect", str(result))

    def test_progress(self):
        steps = []
        rva.detect(self.before, self.after, progress=lambda *step: steps.append(step))
        self.assertTrue(steps)
        for step, done, total in steps:
            self.assertIsInstance(step, str)
            self.assertLessEqual(done, total)

    def check_ended_by(self, progress, kind):
        out = self.folder / 'ended'
        before = set(self.folder.iterdir())
        with self.assertRaises(kind):
            rva.detect(self.before, self.after, out=out, progress=progress)
        self.assertEqual(set(self.folder.iterdir()), before, 'something was left behind')

    def test_an_exception_of_the_progress_ends_the_work(self):
        def fail(*_):
            raise LookupError('enough')
        self.check_ended_by(fail, LookupError)
        self.check_ended_by(5, TypeError)

    def test_an_interrupt_ends_the_work(self):
        self.check_ended_by(lambda *_: os.kill(os.getpid(), signal.SIGINT), KeyboardInterrupt)
        self.assertGreaterEqual(len(rva.detect(self.before, self.after)), 3)

    def test_other_threads_run_during_a_call(self):
        count, ended = 0, threading.Event()

        def work():
            nonlocal count
            while not ended.wait(0.001):
                count += 1

        # No thread is made to give the lock away: others run only if the call itself does.
        self.addCleanup(sys.setswitchinterval, sys.getswitchinterval())
        sys.setswitchinterval(1000)
        thread = threading.Thread(target=work)
        thread.start()
        before = count
        rva.detect(self.before, self.after)
        after = count
        ended.set()
        thread.join()
        self.assertGreater(after, before)


if __name__ == '__main__':
    scenes.main()
