// The lamp around the camera: a button with its brightness, and the choice that it opens.
import { useState } from 'preact/hooks';
import { Choice } from '../Choice';
import { attempt } from '../inspection/inspections';
import { api } from '../link/api';
import type { LampStatus } from '../types';
import { decimal, words } from '../words/words';

const steps = [0, 20, 50, 100];

function brightness(percent: number): string {
  return percent === 0 ? words.drive.lampOff : `${percent} %`;
}

/** @param lamp as the robot reports it @param fixed whether it may not be changed at the moment */
export function LampChoice({ lamp, fixed }: { lamp: LampStatus; fixed: boolean }) {
  const [open, setOpen] = useState(false);
  const pick = (percent: string) => void attempt(() => api.setLamp({ percent: Number(percent) }));
  return (
    <>
      <button type="button" class={lamp.too_hot ? 'warn' : ''} aria-expanded={open} data-testid="lamp" onClick={() => setOpen(!open)}>
        {words.drive.lampIs(lamp.too_hot ? words.drive.tooHot : brightness(lamp.percent))}
      </button>
      {open && (
        <section class="card lamp" aria-label={words.drive.lamp}>
          <Choice
            label={words.drive.lamp}
            name="lamp"
            options={steps.map((percent) => [String(percent), brightness(percent)])}
            value={String(lamp.percent)}
            disabled={fixed}
            onPick={pick}
          />
          <button type="button" data-testid="lamp-close" onClick={() => setOpen(false)}>
            {words.page.close}
          </button>
          {lamp.too_hot && (
            <p class="warn" role="status" data-testid="lamp-hot">
              {words.drive.lampHot(lamp.celsius === undefined ? '' : `${decimal(lamp.celsius, 0)} °C`)}
            </p>
          )}
        </section>
      )}
    </>
  );
}
