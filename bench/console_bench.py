"""Measures the latency of pictures and stops of `rva serve`, and whether its memory grows.

usage: console_bench.py RVA ROBOT_IN_THE_LOOP [--minutes M] [--viewers N] [--trials T]

Pictures: a recording of 30 simulated frames, 848 x 480, is replayed from memory at 30 frames per second to N viewers with
separate connections and, if Chromium and the console's packages are installed, to one browser. Stops: the time from the
event at a console to the stop command on the robot's serial line, through the built firmware on a simulated board.
"""
import argparse
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / 'tests' / 'cli'))

from console_client import Console  # noqa: E402
from served_robot import NotBuilt, ServedRobot  # noqa: E402

SCENE = ROOT / 'data' / 'scenes' / 'three-tools.yaml'


def say(name, values, unit='ms'):
    ordered = sorted(values)
    at = lambda share: ordered[min(len(ordered) - 1, int(share * len(ordered)))]
    print(f'{name:44} {len(ordered):6} {statistics.median(ordered):8.1f} {at(0.95):8.1f} {ordered[-1]:8.1f} {unit}')


def resident_mb(process):
    status = pathlib.Path(f'/proc/{process.pid}/status').read_text()
    return int(status.split('VmRSS:')[1].split()[0]) / 1024


def in_a_browser(address, seconds):
    done = subprocess.run(['node', ROOT / 'console' / 'tests' / 'latency.mjs', address, str(seconds)], capture_output=True,
                          encoding='utf-8', check=False)
    if done.returncode != 0:
        print('no browser:', done.stderr.strip().splitlines()[-1] if done.stderr.strip() else '')
        return None
    return json.loads(done.stdout)


def pictures(program, folder, arguments):
    recording = folder / 'recording'
    subprocess.run([program, 'record', '--camera', f'sim:{SCENE}', '--frames', '30', '--out', recording], check=True,
                   stdout=subprocess.DEVNULL)
    server = subprocess.Popen([program, 'serve', '--camera', f'replay:{recording}', '--data', folder / 'data', '--port', '0'],
                              stdout=subprocess.PIPE, encoding='utf-8')
    try:
        address = server.stdout.readline().strip()
        seconds = 20
        for stream in ('color', 'depth'):
            found = in_a_browser(address + '#' + stream, seconds)
            if found:
                say(f'camera to browser, {stream}', found['latencies_ms'])
                print(f'{"":44} {len(found["latencies_ms"]) / seconds:6.1f} pictures a second')
        viewers = [Console(address, stream=('color', 'depth')[i % 2]) for i in range(arguments.viewers)]
        time.sleep(2)
        for viewer in viewers:
            viewer.pictures, viewer.latencies_ms = 0, []
        start = time.monotonic()
        memory_mb = [resident_mb(server)]
        for _ in range(12):
            time.sleep(60 * arguments.minutes / 12)
            memory_mb.append(resident_mb(server))
        passed = time.monotonic() - start
        say(f'camera to {arguments.viewers} viewers', [ms for viewer in viewers for ms in viewer.latencies_ms])
        say('pictures of each viewer', [viewer.pictures / passed for viewer in viewers], 'a second')
        camera = viewers[0].status['camera']
        print(f'camera: {camera["rate_hz"]} frames a second, {camera["lost"]} lost')
        print(f'memory in {passed / 60:.1f} minutes, MB:', ' '.join(f'{mb:.1f}' for mb in memory_mb))
    finally:
        server.terminate()
        server.wait()


def hold_until_moving(console):
    before = console.status['robot'].get('pan_deg', 0.0)
    pan = -1.0 if before > 0 else 1.0
    while abs(console.status['robot'].get('pan_deg', before) - before) < 4.0:
        console.drive(pan, 0.0)
        time.sleep(0.05)


def let_go(console):
    console.drive(0.0, 0.0)


def fall_silent(_console):
    pass


def stops(program, robot, folder, trials):
    served = ServedRobot(program, robot, SCENE, folder)
    try:
        for name, act in (('stick let go, to stop on the serial line', let_go),
                          ('console silent, to stop', fall_silent),
                          ('connection broken off, to stop', Console.break_off)):
            taken = []
            for _ in range(trials):
                console = Console(served.address)
                console.wait_for(lambda status: 'pan_deg' in status['robot'])
                console.say(type='lease', action='take-over', name='Ann')
                console.drive(0.0, 0.0)
                hold_until_moving(console)
                at = time.monotonic()
                act(console)
                while not (stopped := served.line.stops_after(at)):
                    time.sleep(0.001)
                taken.append(1000 * (stopped - at))
                console.close()
                time.sleep(0.3)
            say(name, taken)
    finally:
        served.end()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('program')
    parser.add_argument('robot_in_the_loop')
    parser.add_argument('--minutes', type=float, default=1.0)
    parser.add_argument('--viewers', type=int, default=10)
    parser.add_argument('--trials', type=int, default=30)
    arguments = parser.parse_args()
    print(f'{"":44} {"number":>6} {"median":>8} {"95 %":>8} {"most":>8}')
    with tempfile.TemporaryDirectory(prefix='rva-bench-') as name:
        folder = pathlib.Path(name)
        pictures(arguments.program, folder, arguments)
        try:
            stops(arguments.program, arguments.robot_in_the_loop, folder, arguments.trials)
        except NotBuilt:
            print('no stops: the firmware was not built')


if __name__ == '__main__':
    main()
