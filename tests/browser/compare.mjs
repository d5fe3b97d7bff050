// node compare.mjs FOLDER... opens each comparison offline and checks its views, common camera, cursors and table. It prints
// one JSON line a comparison: bytes, opening time, frames a second in software. Exit status 1 if a check fails.

import { readFileSync, statSync } from "node:fs";
import { basename, resolve } from "node:path";
import { Checks, PHONE, launch, look, open, overflowing, settled } from "./browser.mjs";

const seek = async (page, at) => {
  await page.evaluate((at) => netcast.player.seek(at), at);
  await settled(page);
};

/** All views, scrolled into sight one after the other: views out of sight are not drawn. */
async function views(page, count) {
  const seen = [];
  for (let place = 0; place < count; place++) {
    await page.locator(`#view-${place}`).scrollIntoViewIfNeeded();
    await settled(page);
    seen.push(await look(page, `#view-${place}`));
  }
  return seen;
}

async function inStep(page, checks, summary) {
  const count = summary.designs.length;
  checks.holds("a view a design", await page.evaluate(() => netcast.player.views.length) === count);
  const duration = await page.evaluate(() => netcast.player.duration);
  await seek(page, 0.4 * duration);
  const before = await views(page, count);
  before.forEach((seen, place) => checks.holds(`view ${place} shows ropes in colour`, seen.vivid > 60, seen));

  // one clock
  await seek(page, 0.1 * duration);
  const earlier = await views(page, count);
  earlier.forEach((seen, place) => checks.holds(`view ${place} follows the clock`, seen.sum !== before[place].sum));
  // one camera: a drag in the first view turns all
  await page.locator("#view-0").scrollIntoViewIfNeeded();
  const box = await page.locator("#view-0").boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + 80, box.y + box.height / 2 + 30, { steps: 4 });
  await page.mouse.up();
  await settled(page);
  const turned = await views(page, count);
  turned.forEach((seen, place) => checks.holds(`view ${place} follows the camera`, seen.sum !== earlier[place].sum));
}

async function plays(page, checks) {
  await seek(page, 0);
  await page.locator("#view-0").focus();
  await page.keyboard.press("Space");
  await page.waitForTimeout(2500);
  const [time, fps] = await page.evaluate(() => [netcast.player.time, netcast.player.framesPerSecond]);
  checks.holds("time goes on while it plays", time > 0);
  await page.keyboard.press("Space");
  await settled(page);
  return fps;
}

/** Every figure has its cursor at the time of the replay, and each design has one colour and dash in all figures. */
async function overlaid(page, checks, summary) {
  const { figures, duration } = await page.evaluate(() => ({ figures: netcast.charts.charts.map(({ figure }) => figure.id), duration: netcast.player.duration }));
  checks.holds("there are curves", figures.length > 3, figures);
  const looks = new Map();
  for (const id of figures) {
    await page.locator(`#${id}`).scrollIntoViewIfNeeded();
    await page.waitForTimeout(60);
    await seek(page, 0.5 * duration);
    const { cursor, expected, lines } = await page.evaluate(([id, at]) => {
      const plot = document.getElementById(id), { xaxis } = plot._fullLayout;
      const line = plot.parentElement.querySelector(".cursor").getBoundingClientRect();
      return {
        cursor: line.left + line.width / 2, expected: plot.getBoundingClientRect().left + xaxis._offset + xaxis.l2p(at),
        lines: plot.data.map(({ name, line }) => [name, `${line.color} ${line.dash}`]),
      };
    }, [id, 0.5 * duration]);
    checks.near(`the cursor of ${id}`, cursor, expected, 1);
    for (const [name, look] of lines) {
      checks.holds(`${name} looks in ${id} as elsewhere`, (looks.get(name) ?? look) === look, look);
      looks.set(name, look);
    }
  }
  checks.holds("no two designs look alike", new Set(looks.values()).size === summary.designs.length, [...looks]);
}

/** The page has the numbers of the summary. */
async function tabled(page, checks, summary) {
  const table = await page.evaluate(() => [...document.querySelectorAll(".came-out tbody tr")]
    .map((row) => [row.title, [...row.querySelectorAll(".best")].length]));
  const told = new Map(table);
  for (const row of summary.table.filter(({ headline }) => headline)) {
    checks.holds(`${row.quantity} has its best marked`, told.get(row.quantity) === row.best.length, told.get(row.quantity) ?? "no row");
  }
  const inputs = await page.locator(".differences tbody tr").count();
  checks.holds("the differences are listed", inputs === summary.differences.length, inputs);
}

async function check(browser, folder) {
  const checks = new Checks();
  const file = resolve(folder, "report.html");
  const summary = JSON.parse(readFileSync(resolve(folder, "summary.json"), "utf8"));
  const { page, context, complaints } = await open(browser, file);
  const [replay, curves] = await page.evaluate(() => ["replay", "curves"].map((name) => Math.round(performance.getEntriesByName(name)[0].startTime)));
  await tabled(page, checks, summary);
  await inStep(page, checks, summary);
  const fps = await plays(page, checks);
  await overlaid(page, checks, summary);
  checks.holds("nothing stands out", (await overflowing(page)).length === 0, await overflowing(page));
  await page.emulateMedia({ colorScheme: "dark" });
  await settled(page);
  const dark = await look(page, "#view-0");
  checks.holds("dark when the reader's screen is", dark.brightness < 0.3, dark);
  checks.holds("no complaint", complaints.length === 0, complaints);
  await context.close();

  const phone = await open(browser, file, PHONE);
  checks.holds("nothing stands out on a phone", (await overflowing(phone.page)).length === 0, await overflowing(phone.page));
  (await views(phone.page, summary.designs.length)).forEach((seen, place) => checks.holds(`view ${place} is drawn on a phone`, seen.vivid > 30, seen));
  checks.holds("no complaint on a phone", phone.complaints.length === 0, phone.complaints);
  await phone.context.close();

  console.log(JSON.stringify({
    comparison: basename(resolve(folder)), designs: summary.designs.length, bytes: statSync(file).size, replay_ms: replay, curves_ms: curves,
    frames_per_s_software: Math.round(10 * fps) / 10, failures: checks.failures,
  }));
  return checks.failures.length === 0;
}

const folders = process.argv.slice(2);
if (folders.length === 0) {
  console.error("usage: node compare.mjs FOLDER...");
  process.exit(2);
}
const browser = await launch();
const fine = [];
for (const folder of folders) fine.push(await check(browser, folder));
await browser.close();
process.exit(fine.every(Boolean) ? 0 : 1);
