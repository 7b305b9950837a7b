// Prints how late each picture is when a browser has drawn it.
// usage: node latency.mjs ADDRESS#STREAM SECONDS
import { chromium } from '@playwright/test';

const [, , target, seconds] = process.argv;
const [address, stream] = target.split('#');
const browser = await chromium.launch({ executablePath: process.env.RVA_CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox'] });
const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
await page.goto(address);
await page.getByTestId(`stream-${stream}`).click();
await page.waitForTimeout(2000);
const latencies_ms = await page.evaluate(async (limit_ms) => {
  const live = document.querySelector('[data-testid=live]');
  const seen = [];
  const observer = new MutationObserver(() => seen.push(Number(live.dataset.latency)));
  observer.observe(live, { attributes: true, attributeFilter: ['data-frame'] });
  await new Promise((resolve) => setTimeout(resolve, limit_ms));
  return seen;
}, 1000 * Number(seconds));
console.log(JSON.stringify({ latencies_ms }));
await browser.close();
