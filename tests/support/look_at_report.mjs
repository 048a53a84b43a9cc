// look_at_report.mjs PAGE ESTIMATE_CSV: opens a report in Chromium, uses it, and says what is wrong with it. The first
// estimate of the page is that of the table.
import {readFileSync} from "node:fs";
import {open} from "./chromium.mjs";

const [file, csv] = process.argv.slice(2);
const wrong = [];
const expect = (condition, what) => { if (!condition) wrong.push(what); };

const [header, ...lines] = readFileSync(csv, "utf8").trimEnd().split("\n").map((line) => line.split(","));
const table = new Map(lines.map((cells) => [Number(cells[0]).toFixed(3), cells]));
const angles = header.filter((name) => name.endsWith("_deg") && !name.endsWith("_sd_deg"));

const shown = `JSON.stringify({
  time: document.querySelector("#replay .clock").textContent,
  angles: Object.fromEntries([...document.querySelectorAll("#replay .readout tbody tr")].map(
    (row) => [row.dataset.angle, [...row.cells].slice(1).map((cell) => cell.textContent)])),
})`;
const pixels = `document.querySelector("#replay .scene").toDataURL()`;

function compareWithTable(numbers) {
  const row = table.get(numbers.time.replace(" s", ""));
  expect(row, `no row of estimate.csv at ${numbers.time}`);
  for (const name of row ? angles : []) {
    const text = numbers.angles[name.replace(/_deg$/, "")]?.[0], cell = row[header.indexOf(name)];
    const close = cell === "" ? text === "–" : Math.abs(Number(text) - Number(cell)) <= 0.0051;
    expect(close, `${name} at ${numbers.time}: ${text} on the page, ${cell} in estimate.csv`);
    const deviation = row[header.indexOf(name.replace(/_deg$/, "_sd_deg"))];
    if (deviation)
      expect(Math.abs(Number(numbers.angles[name.replace(/_deg$/, "")][1]) - Number(deviation)) <= 0.0051,
        `standard deviation of ${name} at ${numbers.time}`);
  }
}

// Every sample that a live chart holds is one of the table.
async function compareChart(page) {
  const charts = JSON.parse(await page.value(`JSON.stringify((() => {
    const data = document.querySelector("figure[data-estimate='0'][data-charts]")?.dataset.charts;
    if (!data) return [];
    return JSON.parse(document.getElementById(data).textContent).map((chart) => ({
      title: chart.title,
      time: Array.from(new Uint32Array(packedBytes(chart.xs[chart.lines[0].x].data)),
        (steps) => chart.xs[chart.lines[0].x].offset + steps * chart.xs[chart.lines[0].x].unit),
      value: Array.from(unpacked(chart.lines[0].y)),
    }));
  })())`));
  for (const chart of charts) {
    const column = header.indexOf(chart.title.replaceAll(" ", "_") + "_deg");
    if (column < 0) continue;
    const off = chart.time.filter((time, i) => {
      const cell = table.get(time.toFixed(3))?.[column];
      return cell === undefined || (cell !== "" && Math.abs(Number(cell) - chart.value[i]) > 0.006);
    });
    expect(off.length === 0, `${chart.title}: ${off.length} samples of the chart are not in estimate.csv`);
  }
}

const page = await open("chromium", file);
await page.until("document.documentElement.dataset.replay === 'ready' && document.documentElement.dataset.charts === 'ready'");
const live = await page.value("typeof uPlot !== 'undefined'");
expect(!live || await page.value("document.querySelectorAll('.chart canvas').length") > 0, "no live chart");
compareWithTable(JSON.parse(await page.value(shown)));
await compareChart(page);

// Keys step, and the picture follows.
const first = await page.value(pixels);
await page.value("document.querySelector('#replay .scene').focus()");
for (const key of ["ArrowRight", "ArrowRight", "End", "ArrowLeft"]) {
  await page.press(key, key === "ArrowRight" ? 8 : 0);
  compareWithTable(JSON.parse(await page.value(shown)));
}
expect(await page.value(pixels) !== first, "the arm does not move with time");

// Space plays and pauses.
await page.press("Home");
await page.press(" ");
await page.until("parseFloat(document.querySelector('#replay .clock').textContent) > 0.3");
await page.press(" ");
expect(await page.value("document.querySelector('#replay .play').textContent") === "Play", "space does not pause");
compareWithTable(JSON.parse(await page.value(shown)));

// A drag turns.
const unturned = await page.value(pixels);
const box = JSON.parse(await page.value("JSON.stringify(document.querySelector('#replay .scene').getBoundingClientRect())"));
await page.mouse("mousePressed", box.x + 100, box.y + 100);
await page.mouse("mouseMoved", box.x + 200, box.y + 150);
await page.mouse("mouseReleased", box.x + 200, box.y + 150);
expect(await page.value(pixels) !== unturned, "a drag does not turn the arm");

for (const problem of page.problems) wrong.push("the browser says: " + problem);
await page.close();
for (const text of wrong) console.log(text);
process.exit(wrong.length === 0 ? 0 : 1);
