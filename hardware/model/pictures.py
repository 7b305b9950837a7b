"""Pictures of the exported parts: the robot, its parts drawn apart, sections, and one for each step of assembly."""
import json
import pathlib

from robot import HARDWARE, run

SIZE = (1000, 900)
ALL_APART = {
    'foot': -30, 'suction_cups': -70, 'support_feet': -70, 'tether_clamp': 5, 'release_lever': 5, 'pan_cradle': 20, 'pan_servo': 70,
    'pan_housing': 95, 'hub': 140, 'outer_spacer': 165, 'pan_bearings': 165, 'retaining_ring': 195, 'yoke_floor': 225}


def steps():
    return json.loads((HARDWARE / 'assembly_steps.json').read_text())


def picture(folder, out, robot, camera, **settings):
    x, y, z, a, b, c, distance = camera
    run('view.scad', out, {'folder': str(pathlib.Path(folder).resolve()), 'camera': robot.camera, **settings},
        f'--imgsize={SIZE[0]},{SIZE[1]}', f'--camera={x},{y},{z},{a},{b},{c},{distance}', '--colorscheme=Tomorrow')


def whole(robot):
    return [*robot.parts, 'camera_cable']


def step_pictures(folder, out, robot):
    present = []
    for number, step in enumerate(steps(), 1):
        present += step['parts']
        shown = [name for name in present if name not in step.get('hidden', [])]
        picture(folder, out / f'step-{number:02}.png', robot, step['camera'], show=shown, shown_screws=step['screws'],
                apart=list(step['apart'].items()), bright=step.get('bright', step['parts']))


def write(folder, out, robot):
    """All pictures of a robot whose parts are in `folder`. OpenSCAD needs a screen for them."""
    out = pathlib.Path(out)
    out.mkdir(parents=True, exist_ok=True)
    picture(folder, out / 'robot.png', robot, [0, 0, 125, 68, 0, 150, 900], show=whole(robot))
    picture(folder, out / 'robot-rear.png', robot, [0, -10, 130, 65, 0, 325, 850], show=whole(robot))
    picture(folder, out / 'robot-tilted.png', robot, [0, 0, 125, 72, 0, 130, 900], show=list(robot.parts), pan_deg=35, tilt_deg=-45)
    tilt = 290
    apart = {**{name: [0, 0, z] for name, z in ALL_APART.items()}, 'column': [0, 0, 0], 'servo_arm': [-35, 0, tilt], 'tilt_servo': [-75, 0, tilt],
             'tilt_cradle': [-125, 0, tilt], 'pivot_arm': [35, 0, tilt], 'tilt_bearing': [70, 0, tilt], 'camera_bracket': [0, 0, tilt],
             'camera': [0, 55, tilt], 'plug': [0, 55, tilt], 'led_frame': [0, 110, tilt], 'leds': [0, 95, tilt]}
    picture(folder, out / 'exploded.png', robot, [0, 0, 245, 72, 0, 145, 1800], show=[name for name in robot.parts if name != 'cables'],
            apart=list(apart.items()))
    fixed = [part.name for part in robot.parts.values() if part.group != 'tilt' and part.name not in ('leds', 'cables', 'suction_cups')]
    picture(folder, out / 'section-pan.png', robot, [0, -8, 150, 78, 0, 72, 460], show=fixed, cut='x')
    picture(folder, out / 'section-tilt.png', robot, [-8, 0, 225, 80, 0, 168, 480], show=[name for name in robot.parts if name != 'leds'],
            cut='y', uncut=['suction_cups', 'cables'])
    step_pictures(folder, out, robot)
