// The console: pictures in the middle, the next step beside them, the robot below.
import './App.css';
import { useEffect, useLayoutEffect } from 'preact/hooks';
import { showRequested } from './follow_address';
import { DrivePanel } from './drive/DrivePanel';
import { Begin } from './inspection/Begin';
import { attempt, open, openInspection, trouble } from './inspection/inspections';
import { StepBar, Steps } from './inspection/Steps';
import { titleOf } from './inspection/words';
import { api } from './link/api';
import { link } from './link/live_link';
import { LiveView } from './live/LiveView';
import { SnapshotForm } from './live/SnapshotForm';
import { SnapshotList } from './live/SnapshotList';
import { page as shownPage, type Page } from './pages';
import { PlanEditor } from './plan/PlanEditor';
import { PlanPanel } from './plan/PlanPanel';
import { RegionEditor } from './regions/RegionEditor';
import { RegionPanel } from './regions/RegionPanel';
import { FindingList } from './review/FindingList';
import { MarkForm } from './review/MarkForm';
import { newMark } from './review/marks';
import { ReviewPictures } from './review/ReviewPictures';
import { asItWas, earlierRound, showRound } from './review/rounds';
import { ViewNotes } from './review/ViewNotes';
import { groupsOf } from './review/groups';
import { beginReview, selectionOf, show } from './review/review_state';
import { LazySpace } from './space/LazySpace';
import { useStore } from './store';
import { ThemeSwitch } from './ThemeSwitch';
import { trendsShown } from './trends/trends';
import { TrendsPage } from './trends/TrendsPage';
import type { Inspection, Session } from './types';
import { Glossary } from './words/Glossary';
import { LanguageSwitch } from './words/LanguageSwitch';
import { RefusalText } from './words/RefusalText';
import { decimal, words } from './words/words';

function Chips({ session, onSignedOut }: { session: Session; onSignedOut: () => void }) {
  const status = useStore(link.status);
  const state = useStore(link.state);
  const camera = status?.camera;
  const bad = state !== 'open' || camera?.problem !== undefined;
  return (
    <div class="chips">
      <span class={`chip ${bad ? 'bad' : 'good'}`} data-testid="camera-chip">
        {state !== 'open' ? `✗ ${words.page.noConnection}` : camera?.problem ? `✗ ${words.page.cameraFailed}` : `✓ ${words.page.camera(camera ? decimal(camera.rate_hz, 0) : '–')}`}
      </span>
      {status?.robot && (
        <span class={`chip ${state !== 'open' || status.robot.problem ? 'bad' : 'good'}`} data-testid="robot-chip">
          {state !== 'open' ? '?' : status.robot.problem ? '✗' : '✓'} {words.page.robot}
        </span>
      )}
      {session.name && (
        <button type="button" class="quiet" onClick={() => void attempt(async () => (await api.signOut(), onSignedOut()))}>
          {words.page.signOut(session.name)}
        </button>
      )}
    </div>
  );
}

function Trouble() {
  const shown = useStore(trouble);
  const refused = useStore(link.refused);
  useEffect(() => {
    if (refused) trouble.value = refused;
  }, [refused]);
  if (!shown) return null;
  return (
    <div class="trouble" role="alert" data-testid="trouble">
      <RefusalText refusal={shown} />
      <button type="button" onClick={() => (trouble.value = null)}>
        {words.page.close}
      </button>
    </div>
  );
}

function PageTabs({ page, inspection, onPick }: { page: Page; inspection: Inspection; onPick: (page: Page) => void }) {
  const compared = inspection.compared_at !== undefined;
  const tabs: [Page, string, boolean][] = [
    ['live', words.page.live, true],
    ['regions', words.page.regions, inspection.initial !== undefined],
    ['plan', words.page.plan, inspection.initial !== undefined],
    ['review', words.page.review, compared],
    ['space', words.page.space, compared],
  ];
  return (
    <div class="switch pages" role="tablist" aria-label={words.page.page}>
      {tabs.map(([name, label, enabled]) => (
        <button key={name} type="button" role="tab" aria-selected={page === name} disabled={!enabled} data-testid={`page-${name}`} onClick={() => onPick(name)}>
          {label}
        </button>
      ))}
    </div>
  );
}

export function App({ session, onSignedOut }: { session: Session; onSignedOut: () => void }) {
  const inspection = useStore(openInspection);
  const ended = useStore(link.ended);
  const page = useStore(shownPage);
  const comparison = inspection?.comparison;
  // New findings are shown first. This happens before the page is painted, since afterwards it would undo what a person
  // has pressed in the meantime.
  useLayoutEffect(
    () =>
      showRequested((requested) => {
        beginReview();
        if (requested?.earlier) showRound(requested.earlier);
        shownPage.value = requested?.page ?? (comparison ? 'review' : 'live');
        const earlier = earlierRound.value;
        const seen = inspection && earlier ? asItWas(inspection, earlier) : inspection;
        const chosen = seen && groupsOf(seen).find((group) => group.lead.number === requested?.finding);
        if (chosen || seen?.closing || seen?.findings.some((finding) => finding.decision)) show({ findings: true, uninspected: true });
        if (chosen) show(selectionOf(chosen));
      }),
    [inspection?.id, comparison],
  );

  const trends = useStore(trendsShown) && !inspection;
  const round = useStore(earlierRound);
  const past = inspection && round ? asItWas(inspection, round) : inspection;
  const mayMark = inspection !== null && !inspection.closing && session.role !== 'viewer';
  const drawing = page === 'regions' && inspection?.initial !== undefined;
  const planning = page === 'plan' && inspection?.initial !== undefined;

  if (ended) {
    return (
      <main class="sign-in">
        <div class="card">
          <h1>RVA</h1>
          <p role="alert">
            <RefusalText refusal={ended} />
          </p>
          <button type="button" class="primary" onClick={() => location.reload()}>
            {words.page.reload}
          </button>
        </div>
      </main>
    );
  }
  return (
    <div class="console">
      <header>
        <button type="button" class="brand quiet" data-testid="home" onClick={() => void attempt(() => open(null))}>
          <img src="/icon.svg" alt="" width="28" height="28" />
          {inspection ? (
            <>
              ‹ <span class="brand-text">{words.page.allInspections}</span>
            </>
          ) : (
            'RVA'
          )}
        </button>
        <h1>{inspection ? titleOf(inspection) : words.page.title}</h1>
        <Glossary page={inspection ? page : 'list'} />
        <LanguageSwitch />
        <ThemeSwitch />
        <Chips session={session} onSignedOut={onSignedOut} />
      </header>
      {inspection && (
        <nav>
          <StepBar stage={inspection.stage} />
          <PageTabs page={page} inspection={inspection} onPick={(next) => (shownPage.value = next)} />
        </nav>
      )}
      <Trouble />
      <main>
        {trends ? (
          <TrendsPage />
        ) : page === 'review' && past?.compared_at ? (
          <ReviewPictures inspection={past} onMark={mayMark && !round ? (bbox, view) => (newMark.value = { bbox, where: { view } }) : undefined} />
        ) : page === 'space' && past?.compared_at ? (
          <LazySpace inspection={past} />
        ) : drawing ? (
          <RegionEditor inspection={inspection} session={session} />
        ) : planning ? (
          <PlanEditor inspection={inspection} session={session} />
        ) : (
          <LiveView onMark={mayMark ? (bbox, stream) => (newMark.value = { bbox, where: { stream } }) : undefined} mayExpose={session.role !== 'viewer'} mayKeep={mayMark} />
        )}
      </main>
      <aside aria-label={words.page.whatToDo} key={`${inspection?.id} ${inspection?.stage}`}>
        {!inspection && <Begin session={session} />}
        {drawing && <RegionPanel inspection={inspection} session={session} />}
        {planning && <PlanPanel inspection={inspection} session={session} />}
        {!drawing && !planning && inspection && !inspection.compared_at && <Steps session={session} />}
        {round && !drawing && !planning && (
          <div class="note earlier-round" role="status" data-testid="earlier-round">
            <span>{words.page.earlierRound(round.number)}</span>
            <button type="button" onClick={() => showRound(null)}>
              {words.page.back}
            </button>
          </div>
        )}
        {page === 'review' && past?.compared_at && <ViewNotes inspection={past} />}
        {!drawing && !planning && past?.compared_at && <FindingList inspection={past} session={session} past={round !== null} />}
        {inspection && <SnapshotList inspection={inspection} />}
        {inspection && <MarkForm inspection={inspection} session={session} />}
        {inspection && mayMark && <SnapshotForm inspection={inspection} session={session} />}
      </aside>
      <footer>
        <DrivePanel mayDrive={session.role !== 'viewer'} small={page !== 'live' || trends} />
      </footer>
    </div>
  );
}
