"""Mass, torque, deflection, tipping, play and power drop, from the meshes and dimensions.scad."""
import math

import numpy as np

G = 9.81  # m/s2


class Statics:
    """Printed parts count as solid, which is heavier than they are."""

    def __init__(self, robot, dimensions, masses_g):
        """`masses_g`: of each bought part; for groups of parts, of all of them together."""
        self.robot, self.masses_g = robot, masses_g
        self.d = {name: value for name, (value, _) in dimensions.items()}

    def mass_g(self, part):
        return part.mesh.volume / 1000 * self.d['density_g_cm3'] if part.kind == 'printed' else self.masses_g[part.name]

    def body(self, *groups):
        """Mass (kg), centre of mass (m) and second moment (kg m2) of groups at pan 0, tilt 0."""
        mass, first, second = 0.0, np.zeros(3), np.zeros((3, 3))
        for part in self.robot.parts.values():
            if part.group in groups:
                kg = self.mass_g(part) / 1000
                mass += kg
                first += kg * part.mesh.centroid / 1000
                second += kg / part.mesh.volume * part.mesh.second_moment / 1e6
        return mass, first / mass, second

    def joint(self, joint):
        """The largest torque on a servo, N m, with the joint's axis in any direction to gravity."""
        groups, axis = (('tilt',), 0) if joint == 'tilt' else (('pan', 'tilt'), 2)
        mass, centre, second = self.body(*groups)
        at = self.robot.tilt_axis / 1000 if joint == 'tilt' else np.zeros(3)
        others = [i for i in range(3) if i != axis]
        arm = np.linalg.norm((centre - at)[others])
        second = second - mass * (np.outer(centre, at) + np.outer(at, centre) - np.outer(at, at))
        inertia = sum(second[i, i] for i in others)
        start = inertia * math.radians(self.d['servo_speed_deg_s']) / self.d['servo_start_s']
        weight = mass * G * arm
        total = weight + start + self.d['cable_torque_nm'] + self.d['joint_friction_nm']
        return {'mass_g': mass * 1000, 'arm_mm': arm * 1000, 'weight_nm': weight, 'start_nm': start,
                'total_nm': total, 'margin': self.d['servo_stall_nm'] / total}

    @property
    def weight_n(self):
        return self.body('fixed', 'pan', 'tilt')[0] * G

    @property
    def cups_n(self):
        """Pull of one cup; its inner diameter is 0.8 of the outer one."""
        return self.d['cup_vacuum_kpa'] / 1000 * math.pi / 4 * (0.8 * self.d['cup_diameter']) ** 2

    def foot(self):
        """The plate under the tether's pull: a beam on its supports with the moment at one end; the column would
        stiffen it."""
        d = self.d
        span, width = 2 * d['support_at'], d['foot_side'] - d['lever_width'] - 1.5
        stiffness = d['modulus_mpa'] * width * d['foot_thickness'] ** 3 / 12
        moment = d['tether_pull_n'] * (d['foot_thickness'] / 2 + d['clamp_z'])
        slope = moment * span / 3 / stiffness
        return {'deflection_mm': moment * span ** 2 / (9 * math.sqrt(3) * stiffness), 'slope_deg': math.degrees(slope),
                'stress_mpa': 6 * moment / (width * d['foot_thickness'] ** 2), 'camera_px': d['focal_px'] * slope}

    def tipping(self):
        """Pulls of the tether, N, at which the robot slides, or tips over its rear supports."""
        d, height = self.d, self.d['foot_clearance'] + self.d['foot_thickness'] + self.d['clamp_z']
        mass, centre, _ = self.body('fixed', 'pan', 'tilt')
        weight = mass * G * (d['support_at'] + centre[1] * 1000)
        cups = 2 * self.cups_n * (d['support_at'] + d['cup_at']) + 2 * self.cups_n * (d['support_at'] - d['cup_at'])
        return {'slides_without_cups_n': d['friction'] * self.weight_n, 'tips_without_cups_n': weight / height,
                'slides_n': d['friction'] * (self.weight_n + 4 * self.cups_n), 'tips_n': (weight + cups) / height}

    def release(self):
        """The pull on the cord that lifts the rear supports against all cups, N, and how far they rise, mm."""
        d = self.d
        pivot_y, pivot_z = d['lever_pivot']
        reach, tip = math.hypot(*d['lever_nose']), d['lever_tip']
        mass, centre, _ = self.body('fixed', 'pan', 'tilt')
        moment = mass * G * (d['support_at'] - centre[1] * 1000) + 4 * self.cups_n * d['support_at']
        force = moment / (d['support_at'] - pivot_y)
        aside = math.sqrt(reach ** 2 - (pivot_z - tip) ** 2)
        turn = math.atan2(pivot_z - tip, aside) - math.atan2(-d['lever_nose'][1], -d['lever_nose'][0])
        return {'cord_n': force * aside / (d['lever_arm'] * math.cos(turn)), 'lift_mm': reach + tip - pivot_z,
                'turn_deg': math.degrees(turn)}

    def play(self):
        """Angles by which the camera may be off, in pixels of its middle."""
        d = self.d

        def pixels(angle_deg):
            return d['focal_px'] * math.radians(angle_deg)

        centres = d['pan_bearing'][2] + d['pan_bearing_distance']
        return {'servo_play_px': pixels(d['servo_play_deg']), 'half_step_px': pixels(d['servo_step_deg'] / 2),
                'bearings_without_preload_px': d['focal_px'] * d['bearing_clearance_mm'] / centres}

    def supply(self, leds):
        """Voltages at the robot's end of the tether."""
        d = self.d

        def drop(current_a, area_mm2):
            return 2 * d['tether_m'] * d['copper_ohm_mm2_m'] / area_mm2 * current_a

        current = 2 * d['servo_current_a'] + leds / 3 * d['led_current_a']
        return {'current_12v_a': current, 'servos_v': 12 - drop(current, d['supply_mm2']),
                'receiver_v': 5 - drop(d['receiver_current_a'], d['signal_mm2']),
                'camera_v': 5 - drop(d['camera_current_a'], d['usb_mm2'])}
