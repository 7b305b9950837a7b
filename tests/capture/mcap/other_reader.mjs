// Reads a file that `rva export --to mcap` wrote with npm's @mcap/core, by its index and as a stream, and compares
// both with what is expected.
//
// usage: node other_reader.mjs FILE.mcap DEPTH_FRAMES MODULES    MODULES: a folder with @mcap/core and fzstd
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { resolve } from 'node:path';

const [path, frames, modules] = process.argv.slice(2);
const require = createRequire(resolve(modules, 'x.js'));
let core, fzstd;
try {
  core = require('@mcap/core');
  fzstd = require('fzstd');
} catch {
  console.log(`SKIPPED: ${modules} has no @mcap/core and fzstd; install them there with npm`);
  process.exit(77);
}

const bytes = new Uint8Array(readFileSync(path));
const decompressHandlers = { zstd: (data) => fzstd.decompress(data) };

async function countIndexed() {
  const readable = {
    size: async () => BigInt(bytes.length),
    read: async (at, count) => bytes.slice(Number(at), Number(at + count)),
  };
  const reader = await core.McapIndexedReader.Initialize({ readable, decompressHandlers });
  const counts = new Map();
  let before = 0n;
  for await (const message of reader.readMessages()) {
    if (message.logTime < before) throw new Error('messages are not in the order of their times');
    before = message.logTime;
    const { topic } = reader.channelsById.get(message.channelId);
    counts.set(topic, (counts.get(topic) ?? 0) + 1);
  }
  for (const [id, count] of reader.statistics.channelMessageCounts)
    if (Number(count) !== counts.get(reader.channelsById.get(id).topic)) throw new Error(`statistics of channel ${id}`);
  return counts;
}

function countStreamed() {
  const reader = new core.McapStreamReader({ decompressHandlers, validateCrcs: true });
  reader.append(bytes);
  const topics = new Map();
  const counts = new Map();
  for (let record; (record = reader.nextRecord()); ) {
    if (record.type === 'Channel') topics.set(record.id, record.topic);
    if (record.type !== 'Message') continue;
    const topic = topics.get(record.channelId);
    counts.set(topic, (counts.get(topic) ?? 0) + 1);
  }
  if (!reader.done()) throw new Error('the file does not end as it should');
  return counts;
}

const indexed = await countIndexed();
const streamed = countStreamed();
console.log(Object.fromEntries(indexed));
for (const [topic, count] of indexed)
  if (streamed.get(topic) !== count) throw new Error(`${topic}: ${count} by index, ${streamed.get(topic)} as a stream`);
if (indexed.get('/camera/depth/image_rect_raw') !== Number(frames)) throw new Error('other depth frames than expected');
