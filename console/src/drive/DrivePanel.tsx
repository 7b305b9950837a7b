// Turning the camera: the name of the driver, the stick, the angles, and the stop button, which everybody may use.
import './drive.css';
import { useState } from 'preact/hooks';
import { link } from '../link/live_link';
import { useStore } from '../store';
import type { RobotStatus } from '../types';
import { words } from '../words/words';
import { AngleGauge } from './AngleGauge';
import { ControllerSettings } from './ControllerSettings';
import { LampChoice } from './LampChoice';
import { noticeOf } from './pad_words';
import { StickPad } from './StickPad';
import { sticks } from './sticks';

export function StopButton() {
  return (
    <button type="button" class="stop" data-testid="stop" onClick={() => link.stop()}>
      {words.drive.stop}
      <small>{words.drive.stopHelp}</small>
    </button>
  );
}

// Why the robot does not move at the moment, or what to do.
function hint(robot: RobotStatus, yours: boolean, hasController: boolean): string {
  if (robot.problem) return robot.problem;
  if (robot.lent) return words.drive.lent;
  if (!yours) return words.drive.takeFirst;
  if (!robot.armed) return words.drive.stopped;
  if (robot.at_limit) return words.drive.atLimit;
  if (robot.driving) return words.drive.turning;
  return hasController ? words.drive.controllerReady : words.drive.pull;
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
      <section class="drive" aria-label={words.drive.robot}>
        <p class="hint">{words.drive.noRobot}</p>
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
    <section class={`drive ${open ? 'driven' : 'slim'}`} aria-label={words.drive.robot}>
      {open && <StickPad enabled={lease.yours && !robot.lent} />}
      <div class="drive-middle">
        {!small && (
          <div class="gauges">
            <AngleGauge joint="pan" label={words.drive.pan} angle_deg={robot.pan_deg} limits_deg={robot.limits.pan_deg} reversed />
            <AngleGauge joint="tilt" label={words.drive.tilt} angle_deg={robot.tilt_deg} limits_deg={robot.limits.tilt_deg} />
          </div>
        )}
        <p class={`hint ${robot.problem ? 'bad' : denied ? 'warn' : ''}`} role="status" data-testid="drive-hint">
          {small && !robot.problem ? words.drive.openLive : hint(robot, lease.yours, hasController)}
        </p>
        {!small && notice && (
          <p class="warn" role="status" data-testid="controller-notice">
            {notice}
          </p>
        )}
        <div class="drive-lease">
          {lease.yours && (
            <button type="button" data-testid="release" onClick={() => link.releaseControls()}>
              {words.drive.handBack}
            </button>
          )}
          {!lease.yours && !others && !small && (
            <button type="button" data-testid="take" disabled={!mayDrive} onClick={() => link.takeControls(false)}>
              {words.drive.take}
            </button>
          )}
          {others && !asking && !small && (
            <button type="button" data-testid="take-over" disabled={!mayDrive} onClick={() => setAsking(true)}>
              {words.drive.drives(lease.holder || words.page.somebody)}
            </button>
          )}
          {others && asking && (
            <span class="confirm">
              <span>{words.drive.willLose(lease.holder || words.page.somebody)}</span>
              <button type="button" class="primary" data-testid="take-over-yes" onClick={takeOver}>
                {words.drive.takeOver}
              </button>
              <button type="button" onClick={() => setAsking(false)}>
                {words.page.cancel}
              </button>
            </span>
          )}
          {!small && (
            <button type="button" aria-expanded={settingUp} data-testid="controller-open" onClick={() => setSettingUp(!settingUp)}>
              {words.drive.controller}
            </button>
          )}
          {!small && robot.lamp && mayDrive && <LampChoice lamp={robot.lamp} fixed={robot.lent} />}
        </div>
        {!small && settingUp && <ControllerSettings onClose={() => setSettingUp(false)} />}
      </div>
      <StopButton />
    </section>
  );
}
