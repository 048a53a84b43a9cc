// report_opening.mjs REPORT: how long a report takes to open in a headless Chromium, from the start of
// navigation until its charts and its replay are ready. Milliseconds, the median of five; needs node.
import {statSync} from "node:fs";
import {open} from "../tests/support/chromium.mjs";

const [file] = process.argv.slice(2);
const ready = "document.documentElement.dataset.replay === 'ready' && document.documentElement.dataset.charts === 'ready'";
const times = [];
for (let run = 0; run < 5; ++run) {
  const page = await open("chromium", file);
  await page.until(ready);
  times.push(await page.value("performance.now()"));
  await page.close();
}
times.sort((a, b) => a - b);
console.log(`${times[2].toFixed(0)} ms (${times[0].toFixed(0)} to ${times[4].toFixed(0)}), ` +
  `${(statSync(file).size / 1e6).toFixed(1)} MB`);
