// Turning the camera: the name of the driver, the stick, the angles, and the stop button, which everybody may use.
import './drive.css';
import { useState } from 'preact/hooks';
import { link } from '../link/live_link';
import { useStore } from '../store';
import type { RobotStatus } from '../types';
import { AngleGauge } from './AngleGauge';
import { ControllerSettings } from './ControllerSettings';
import { noticeOf } from './pad_words';
import { StickPad } from './StickPad';
import { sticks } from './sticks';

export function StopButton() {
  return (
    <button type="button" class="stop" data-testid="stop" onClick={() => link.stop()}>
      Stop
      <small>robot · Esc</small>
    </button>
  );
}

// Why the robot does not move at the moment, or what to do.
function hint(robot: RobotStatus, yours: boolean, hasController: boolean): string {
  if (robot.problem) return robot.problem;
  if (robot.lent) return 'A capture is turning the camera.';
  if (!yours) return 'Take the controls to turn the camera.';
  if (!robot.armed) return 'Stopped. Let go of the stick, then pull again.';
  if (robot.at_limit) return 'Limit reached: the camera cannot turn farther.';
  if (robot.driving) return 'Turning. Let go to stop.';
  return hasController ? 'Controller ready: hold the left stick.' : 'Pull the stick, or hold an arrow key. Shift: slowly.';
}

/**
 * A line with the stop button; it opens, with stick and gauges, on the live page while somebody drives.
 * @param small whether another page than the live one is shown, from which nobody drives
 */
export function DrivePanel({ mayDrive, small }: { mayDrive: boolean; small: boolean }) {
  const status = useStore(link.status);
  const lease = useStore(link.lease);
  const pads = useStore(sticks.pads);
  const denied = useStore(sticks.denied) && !lease.yours;
  const [asking, setAsking] = useState(false);
  const [settingUp, setSettingUp] = useState(false);
  const robot = status?.robot;
  if (!robot) {
    return (
      <section class="drive" aria-label="Robot">
        <p class="hint">No robot: the camera does not move.</p>
      </section>
    );
  }
  const hasController = pads.some(({ state }) => state === 'ready');
  const notice = noticeOf(pads);
  const others = lease.holder !== undefined && !lease.yours;
  const open = !small && (lease.yours || others);
  const takeOver = () => {
    setAsking(false);
    link.takeControls(true);
  };
  return (
    <section class={`drive ${open ? 'driven' : 'slim'}`} aria-label="Robot">
      {open && <StickPad enabled={lease.yours && !robot.lent} />}
      <div class="drive-middle">
        {!small && (
          <div class="gauges">
            <AngleGauge label="Pan" angle_deg={robot.pan_deg} limits_deg={robot.limits.pan_deg} reversed />
            <AngleGauge label="Tilt" angle_deg={robot.tilt_deg} limits_deg={robot.limits.tilt_deg} />
          </div>
        )}
        <p class={`hint ${robot.problem ? 'bad' : denied ? 'warn' : ''}`} role="status" data-testid="drive-hint">
          {small && !robot.problem ? 'To drive the camera, open the page “Live”.' : hint(robot, lease.yours, hasController)}
        </p>
        {!small && notice && (
          <p class="warn" role="status" data-testid="controller-notice">
            {notice}
          </p>
        )}
        <div class="drive-lease">
          {lease.yours && (
            <button type="button" data-testid="release" onClick={() => link.releaseControls()}>
              Hand back the controls
            </button>
          )}
          {!lease.yours && !others && !small && (
            <button type="button" data-testid="take" disabled={!mayDrive} onClick={() => link.takeControls(false)}>
              Take the controls
            </button>
          )}
          {others && !asking && !small && (
            <button type="button" data-testid="take-over" disabled={!mayDrive} onClick={() => setAsking(true)}>
              {lease.holder || 'Somebody'} is driving · take over…
            </button>
          )}
          {others && asking && (
            <span class="confirm">
              <span>{lease.holder || 'Somebody'} will lose the controls.</span>
              <button type="button" class="primary" data-testid="take-over-yes" onClick={takeOver}>
                Take over
              </button>
              <button type="button" onClick={() => setAsking(false)}>
                Cancel
              </button>
            </span>
          )}
          {!small && (
            <button type="button" aria-expanded={settingUp} data-testid="controller-open" onClick={() => setSettingUp(!settingUp)}>
              Controller
            </button>
          )}
        </div>
        {!small && settingUp && <ControllerSettings onClose={() => setSettingUp(false)} />}
      </div>
      <StopButton />
    </section>
  );
}
