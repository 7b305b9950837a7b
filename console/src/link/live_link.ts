// The WebSocket, which receives pictures and status and sends the deflections of the sticks.
import { Store } from '../store';
import type { ClientMessage, Lease, PictureHead, Pointed, Pointing, Protocol, ServerMessage, Status, Stream } from '../types';
import { api } from './api';
import { clientId, person } from './client';
import { Refusal } from './refusal';
import { words } from '../words/words';

export interface LivePicture {
  head: PictureHead;
  bitmap: ImageBitmap;
  /** Time from the camera to here, by the clocks of both computers; reliable only if both are one computer. */
  latency_ms: number;
}

export type LinkState = 'connecting' | 'open' | 'lost';

const protocol: Protocol = 1;
const retry_ms = 500;
const silence_ms = 3000;

class LiveLink {
  readonly state = new Store<LinkState>('connecting');
  readonly status = new Store<Status | null>(null);
  readonly lease = new Store<Lease>({ type: 'lease', yours: false });
  /** Why the last message was refused, or why the controls were lost. */
  readonly refused = new Store<Refusal | null>(null);
  /** What people point at in the live picture, the oldest first. */
  readonly pointed = new Store<Pointed[]>([]);
  /** Why the server ended the connection for good; null if it did not. */
  readonly ended = new Store<Refusal | null>(null);
  onPicture: (picture: LivePicture) => void = () => undefined;

  private socket: WebSocket | null = null;
  private stream: Stream | null = null;
  private heard_ms = 0;
  private watched_ms = 0;
  private started = false;
  private releasing = false;

  start(): void {
    if (this.started) return;
    this.started = true;
    this.connect();
    setInterval(() => this.watchSilence(), retry_ms);
  }

  watch(stream: Stream | null): void {
    this.stream = stream;
    this.send({ type: 'watch', stream: stream ?? 'none' });
  }

  drive(pan: number, tilt: number): void {
    this.send({ type: 'drive', pan, tilt, stamp_ms: performance.now() });
  }

  /** Points at something, for all consoles. */
  point(mark: Omit<Pointing, 'type'>): void {
    this.send({ type: 'pointing', ...mark });
  }

  stop(): void {
    this.send({ type: 'stop' });
  }

  takeControls(takeOver: boolean): void {
    this.send({ type: 'lease', action: takeOver ? 'take-over' : 'take', name: person.name });
  }

  releaseControls(): void {
    this.releasing = true;
    this.send({ type: 'lease', action: 'release' });
  }

  private connect(): void {
    const scheme = location.protocol === 'https:' ? 'wss' : 'ws';
    const socket = new WebSocket(`${scheme}://${location.host}/api/live`);
    socket.binaryType = 'arraybuffer';
    this.socket = socket;
    socket.onopen = () => {
      this.heard_ms = performance.now();
      this.send({ type: 'hello', protocol, client: clientId, name: person.name });
      if (this.stream) this.watch(this.stream);
      this.state.value = 'open';
    };
    socket.onmessage = (event: MessageEvent<string | ArrayBuffer>) => {
      this.heard_ms = performance.now();
      if (typeof event.data === 'string') this.hear(event.data);
      else void this.show(event.data);
    };
    socket.onclose = (event) => {
      if (this.socket !== socket) return;
      this.socket = null;
      this.state.value = 'lost';
      this.lease.value = { type: 'lease', yours: false };
      const policyViolation = 1008;
      if (event.code === policyViolation) this.ended.value = new Refusal('unknown', event.reason);
      else setTimeout(() => void this.reconnect(), retry_ms);
    };
  }

  // A restarted server has forgotten all sign-ins: it responds, but the session is no longer valid.
  private async reconnect(): Promise<void> {
    const session = await api.session().catch(() => null);
    if (session && !session.role) this.ended.value = new Refusal('console', words.page.ended);
    else this.connect();
  }

  // A status arrives at least every second, so silence shows a broken connection long before the browser detects it.
  private watchSilence(): void {
    const now_ms = performance.now();
    // A page that was busy itself may not have processed the messages that have arrived.
    const listened = now_ms - this.watched_ms < 2 * retry_ms;
    this.watched_ms = now_ms;
    if (this.state.value !== 'open' || !listened || now_ms - this.heard_ms < silence_ms) return;
    this.socket?.close();
  }

  private hear(text: string): void {
    const message = JSON.parse(text) as ServerMessage;
    switch (message.type) {
      case 'status':
        this.status.value = message;
        break;
      case 'lease':
        this.sayWhyLost(message);
        this.lease.value = message;
        break;
      case 'pointed':
        this.pointed.value = [...this.pointed.value, message];
        break;
      case 'refused':
        this.refused.value = new Refusal(message.code, message.message);
        break;
    }
  }

  // A message explains why the stick has no effect after the controls were lost.
  private sayWhyLost(now: Lease): void {
    if (this.lease.value.yours && !now.yours && !this.releasing) {
      const message = now.holder !== undefined
        ? words.drive.takenOver(now.holder || words.page.somebody)
        : words.drive.handedBack;
      this.refused.value = new Refusal('console', message);
    }
    if (!now.yours) this.releasing = false;
  }

  private async show(bytes: ArrayBuffer): Promise<void> {
    const length = new DataView(bytes).getUint32(0, true);
    const head = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 4, length))) as PictureHead;
    const jpeg = new Blob([new Uint8Array(bytes, 4 + length)], { type: 'image/jpeg' });
    try {
      const bitmap = await createImageBitmap(jpeg);
      this.onPicture({ head, bitmap, latency_ms: Date.now() - head.taken_ms });
    } finally {
      this.send({ type: 'shown' });
    }
  }

  private send(message: ClientMessage): void {
    if (this.socket?.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(message));
  }
}

export const link = new LiveLink();
