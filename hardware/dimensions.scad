// All dimensions of the robot, in millimetres unless the name has another unit. Each has its source behind it:
// a standard, a data sheet, the code, or why it was chosen. "Check" marks values that are from memory and must be
// compared with the data sheet before a part is ordered or printed.

// Camera: D435, D435i, D405 or D455 (openscad -D 'camera="D405"').
camera = "D435";  // the thesis' camera, appendix A

// Kinematic chain: must equal src/geometry/pan_tilt.hpp, which the test hardware.model compares.
servo1_z = 180;  // PanTiltChain::servo1
tilt_z = 60;  // PanTiltChain::bracket, above servo1
imager_y = 20;  // PanTiltChain::bracket_from_camera
imager_z = 10;  // PanTiltChain::bracket_from_camera

// Cameras: width, height, depth, imager behind the front, imager beside the middle, side of the plug
// (1 right, -1 left), distance of the threads in the back, mass in grams, field of view of depth (horizontal and
// vertical, degrees), size of the threads, plug behind the imager, its size along the view and across,
// distance of the imagers.
camera_D435 = [90, 25, 25.05, 4.3, 17.5, 1, 45, 75, 87, 58, 3, 6, 8, 18.5, 50];  // realsense2_description, _d435.urdf.xacro; mass: Clearpath's page; threads, field: data sheet, check
camera_D435i = [90, 25, 25.05, 4.3, 17.5, 1, 45, 75, 87, 58, 3, 6, 8, 18.5, 50];  // as D435: its description includes that of the D435
camera_D405 = [42, 42, 23, 3.8, 9, -1, 20, 60, 87, 58, 3, 12.4, 8, 18.5, 18];  // realsense2_description, _d405.urdf.xacro; threads, mass, field: check
camera_D455 = [124, 29, 26, 4.55, 47.5, -1, 95, 103, 87, 58, 4, 4.1, 18.5, 8, 95];  // realsense2_description, _d455.urdf.xacro; threads (M4), mass, field: check
plug_length = 18;  // right-angle USB-C plug with its cable, beside the camera: chosen, check against the cable
camera_screw = 16;  // length: chosen, 2.75 to 3.5 of it in the camera's thread, check against the data sheet
camera_screw_seat = 13.25;  // head to the camera's back: chosen

// Servo, Herkulex DRS-0101.
servo_size = [24, 45, 31];  // DRS-0101 manual: width, length, height without horn; check
servo_axis_to_end = 12;  // axis to the near end: check
servo_horn_diameter = 20;  // round horn: check
servo_horn_top = 6;  // above the face of the case: check
servo_horn_screws = 14;  // pitch circle of four M2 screws in the horn: check
servo_mass_g = 45;  // DRS-0101 manual; check
servo_stall_nm = 1.18;  // DRS-0101 manual: 12 kgf.cm at 7.4 V; check
servo_clearance = 0.25;  // chosen: fused filament parts deviate by 0.1 to 0.2; ribs take it up

// Bearings.
pan_bearing = [40, 52, 7];  // 61808-2RS1, ISO 15 dimension series 18: bore, outside, width
pan_bearing_shoulders = [44, 47];  // SKF 61808: d1 43.2, D1 48.8, shoulder of shaft and housing; check
pan_bearing_mass_g = 34;  // SKF 61808-2RS1; check
pan_bearing_distance = 6;  // spacer between both: chosen, so that they share a moment
tilt_bearing = [5, 16, 5];  // 625-2Z, ISO 15 dimension series 02
tilt_bearing_lip = 12;  // chosen: below the outer ring's inner edge of 13.4 (SKF 625; check)
fit = 0.1;  // on a diameter, bearing seats: chosen, reamed or pressed

// Screws and inserts.
m3_hole = 3.4;  // ISO 273, medium
m3_head = [6, 3];  // ISO 14580 / ISO 4762 M3: largest diameter and height of a head
m3_sunk = 6.7;  // ISO 10642 M3: theoretical diameter of the head
m3_insert = [4.0, 5.7];  // ruthex RX-M3x5.7: hole, length
m4_hole = 4.5;  // ISO 273, medium
m2_hole = 2.4;  // ISO 273, medium
m5_insert = [6.4, 9.5];  // ruthex RX-M5x9.5: hole, length
m5_hole = 5.5;  // ISO 273, medium
insert_wall = 2;  // least wall around an insert: ruthex states 1.6 for M3 and 2.6 for M5; chosen, all walls are 2 or more
driver = [7, 90];  // diameter and length of a screwdriver that must reach each screw: chosen
driver_m2 = [2.5, 90];  // of the shank of a 1.5 mm hexagon driver: chosen

// Printing.
wall = 3;  // chosen: at least 2, three lines of 0.4 on each side and infill between
bed = [220, 220, 250];  // common printers, as the issue of this model states
overhang_deg = 45;  // from vertical: rule for PETG without support
bridge = 10;  // longest bridge: rule for PETG with cooling
density_g_cm3 = 1.27;  // PETG, data sheets of filaments
modulus_mpa = 1500;  // chosen: 3/4 of the 2000 of solid PETG, for layers and infill
strength_mpa = 20;  // chosen: half of the 40 to 50 of solid PETG, across layers

// Foot.
foot_side = 150;  // chosen: inside a circle of 200, which leaves 15 around it in a hole of 230
foot_corner = 22;  // chosen: no sharp edge
foot_thickness = 8;  // chosen: deflection below 0.5 under the tether's pull
foot_clearance = 12;  // height of a cup under vacuum, or of a magnet with its washer: chosen, check against the cup
cup_diameter = 40;  // chosen: four hold 64 N at 0.2 bar below ambient
cup_vacuum_kpa = 20;  // chosen, low: a hand-pressed cup with a screw lip; check
cup_at = 40;  // centre of a cup from both middles: chosen, between column and supports
cup_mass_g = 12;  // chosen, check against the cup
support_at = 63;  // feet that bear the plate while the cups pull it down, from both middles: chosen, at the corners
support_diameter = 10;  // rubber cap on an M5 screw: chosen

// Column.
column_x = 31;  // half width: bearing's radius, 26, and a wall of 5
column_front = 31;  // as column_x
column_rear = 44;  // the servo's far end at 33, its cradle, and room for cables
column_corner = 6;  // chosen: no sharp edge
post_inset = 5.5;  // centre of a corner's insert from the outside: half the hole, and 3.5 of wall
cable_window = [40, 24];  // chosen: a USB-C plug of 12 x 18 passes with its cable

// Joint housing, bearing seats, yoke.
floor_thickness = 5;  // of what a servo is screwed to: chosen, an M3 countersunk head and 3 below it
gap = 1;  // between parts that turn against each other: chosen, more than the bearings' tilt
ring_thickness = 4;  // chosen: stiff between its screws
hub_bore = 23.6;  // chosen: four M2 heads on the horn's screw circle, and a driver
hub_screw_radius = 15.9;  // middle of the hub's wall, 2 on both sides of an insert
preload = 0.1;  // housing lower than its bearings, so that the rings are clamped: chosen
yoke_thickness = 10;  // of the yoke's floor: an M3 insert of 4 in its ends, and 3 around it
yoke_y = 22;  // half depth of the yoke's floor: as the shoulder of the bearing's inner ring
arm_y = 23;  // half width of the servo's arm: cradle's screws at 17, and 6
side_gap = 10;  // between the camera's body and the bracket's ear: the side bar of the LED frame
ear = 5;  // thickness of the servo's ear: chosen
pivot_ear = 11.5;  // thickness of the other ear: the M5 insert, and 2
pivot_arm = 7;  // thickness of the other arm: the bearing, and a lip of 2
ear_radius = 14;  // horn's screws at 7, and 7
bracket_thickness = 5;  // chosen: as the servo's ear
bracket_back = -14;  // rear face of the bracket, behind the tilt axis: as ear_radius
stand = [13, 4.1];  // around the camera's screws, between bracket and camera, its height beyond the hole: chosen, beside the driver of the horn's screws
post_diameter = 8;  // of the LED frame's posts: the M3 insert and 2 around it
post_outwards = 1;  // of the posts from the middle of the frame's bars: chosen, beside the driver of the horn's screws

// LED ring.
led_diameter = 5;  // LED 5 mm, T-1 3/4
led_hole = 5.2;  // chosen: a press fit after printing
led_bar = 13;  // width of the frame: chosen, 3.9 of wall on both sides of an LED
led_frame_y = 8;  // thickness: the dome (7.7) is below its front
led_opening = 0.5;  // around the camera: chosen
led_pitch = 16;  // chosen: 18 LEDs, three in series

// Tether and release.
usb_cable = 6.5;  // active USB 3 cable: check against the cable
power_cable = 8;  // two wires of 1 mm2 and one CAT5e cable in one sleeve: chosen, check
clamp_x = 12;  // cables on both sides of the release lever: chosen
clamp_y = -52;  // chosen, between column and lever
clamp_z = 16;  // cable's middle above the foot: chosen, above the lever's bearing
lever_pivot = [-67, 24];  // y and z: chosen, behind the clamp, above the plate
lever_nose = [-27, -13];  // from the pivot, at rest: chosen, 11 above the ground
lever_tip = 3;  // radius of the nose: chosen, no sharp edge
lever_arm = 60;  // pivot to cord: chosen, force ratio in statics
lever_width = 10;  // chosen

// Loads and play, for the statics.
tether_pull_n = 20;  // chosen: eight times the drag of 5 m of 0.1 kg/m on metal (friction 0.5)
cable_torque_nm = 0.05;  // chosen: bending the USB cable at a joint; to be measured
joint_friction_nm = 0.02;  // chosen: sealed bearings, SKF's start-up torque is below it
servo_speed_deg_s = 90;  // firmware/rva_robot/limits.h
servo_start_s = 0.1;  // chosen: from rest to full speed
servo_play_deg = 0.3;  // backlash_deg of src/sim/simulated_robot.hpp, as assumed there; to be measured
servo_step_deg = 0.325;  // docs/protocol.md
focal_px = 425;  // src/sim/sensor/stereo_sensor_options.hpp
bearing_clearance_mm = 0.02;  // SKF, normal internal clearance of a 40 mm bore: 6 to 20 micrometres; check
friction = 0.5;  // rubber on painted metal: chosen, low

// Supply, for the power drop.
tether_m = 5;  // as the issue of this model states
copper_ohm_mm2_m = 0.0175;  // copper at 20 degrees C, IEC 60228
supply_mm2 = 1.0;  // cross-section of the 12 V wires: chosen
signal_mm2 = 0.205;  // AWG 24, CAT5e
usb_mm2 = 0.519;  // AWG 20, power wires that the active cable must have: AWG 22 would leave 4.62 V
servo_current_a = 1.0;  // each, stalled: chosen above the manual's value; check
servo_least_v = 7;  // DRS-0101 manual: 7 to 12 V; check
led_current_a = 0.02;  // LED data sheets
receiver_current_a = 0.05;  // RS-422 transceiver: chosen, check
camera_current_a = 0.7;  // 3.5 W at 5 V, Clearpath's page on the D435
camera_least_v = 4.75;  // Clearpath's page on the D435
