// node compare.mjs FOLDER... opens each comparison offline and checks its views, common camera, cursors and table. It prints
// one JSON line a comparison: bytes, opening time, frames a second in software. Exit status 1 if a check fails.

import { readFileSync, statSync } from "node:fs";
import { basename, resolve } from "node:path";
import { Checks, PHONE, contents, launch, look, open, overflowing, pages, ruler, settled } from "./browser.mjs";

const seek = async (page, at) => {
  await page.evaluate((at) => netcast.player.seek(at), at);
  await settled(page);
};

/** The length of the shortest run, s: beyond it a view stands still. */
const shortest = (page) => page.evaluate(() => Math.min(...netcast.player.views.map(({ data }) => data.duration)));

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
  const duration = await shortest(page);
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
  const figures = await page.evaluate(() => netcast.charts.charts.map(({ figure }) => figure.id));
  const duration = await shortest(page);
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

/** The replays come before the tables; four of them stand two by two. */
async function laidOut(page, checks, summary) {
  const { replay, table, boxes } = await page.evaluate(() => ({
    replay: document.querySelector(".replay").getBoundingClientRect().bottom,
    table: document.querySelector("main table").getBoundingClientRect().top,
    boxes: [...document.querySelectorAll(".stage")].map((stage) => stage.getBoundingClientRect()).map(({ left, top }) => [left, top]),
  }));
  checks.holds("the replays come before the tables", replay < table, { replay, table });
  const rows = new Map();
  for (const [, top] of boxes) rows.set(Math.round(top), (rows.get(Math.round(top)) ?? 0) + 1);
  const expected = { 2: [2], 3: [3], 4: [2, 2], 5: [3, 2], 6: [3, 3] }[summary.designs.length];
  if (expected) checks.holds("the replays fill their rows", JSON.stringify([...rows.values()]) === JSON.stringify(expected), [...rows.values()]);
  for (const place of summary.designs.keys()) {
    await page.locator(`#view-${place}`).scrollIntoViewIfNeeded();
    await settled(page);
    const { metres, width, pixel } = await ruler(page, `#view-${place}`);
    checks.near(`the ruler of view ${place}`, width * pixel, metres, 0.02 * metres);
  }
}

/** The page has the numbers of the summary. */
async function tabled(page, checks, summary) {
  const table = await page.evaluate(() => [...document.querySelectorAll(".came-out tbody tr")]
    .map((row) => {
      const plain = (cell) => cell.textContent.replace("★ ", "").replace(" (best)", "");
      const cells = [...row.querySelectorAll("td:not(.reported)")];
      return [row.title, { best: cells.filter((cell) => cell.matches(".best")).map(plain), rest: cells.filter((cell) => !cell.matches(".best")).map(plain) }];
    }));
  const told = new Map(table);
  for (const row of summary.table.filter(({ headline }) => headline)) {
    const { best, rest } = told.get(row.quantity) ?? { best: [], rest: [] };
    // values that read alike share the star, and all alike have none
    const marked = best.length >= row.best.length || new Set(rest).size === 1;
    checks.holds(`${row.quantity} has its best marked`, told.has(row.quantity) && marked, { best, rest });
    checks.holds(`${row.quantity} has no star without a best`, row.best.length > 0 || best.length === 0, best);
    if (summary.designs.every(({ finished, failure }) => finished && !failure))
      checks.holds(`what reads like the best of ${row.quantity} is marked`, !rest.some((text) => best.includes(text)), { best, rest });
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
  await contents(page, checks);
  await laidOut(page, checks, summary);
  await tabled(page, checks, summary);
  await inStep(page, checks, summary);
  const fps = await plays(page, checks);
  await overlaid(page, checks, summary);
  checks.holds("nothing stands out", (await overflowing(page)).length === 0, await overflowing(page));
  await page.emulateMedia({ colorScheme: "dark" });
  await settled(page);
  const dark = await look(page, "#view-0");
  checks.holds("dark when the reader's screen is", dark.brightness < 0.3, dark);
  const paper = await pages(page);
  checks.holds("it is printed", paper >= 1, paper);
  await page.emulateMedia({ colorScheme: "dark", media: "print" });
  const card = await page.evaluate(() => getComputedStyle(document.documentElement).getPropertyValue("--card").trim());
  checks.holds("ink on white on paper, also for a reader in the dark", card === "#ffffff", card);
  checks.holds("no complaint", complaints.length === 0, complaints);
  await context.close();

  const phone = await open(browser, file, PHONE);
  checks.holds("nothing stands out on a phone", (await overflowing(phone.page)).length === 0, await overflowing(phone.page));
  await contents(phone.page, checks);
  (await views(phone.page, summary.designs.length)).forEach((seen, place) => checks.holds(`view ${place} is drawn on a phone`, seen.vivid > 30, seen));
  checks.holds("no complaint on a phone", phone.complaints.length === 0, phone.complaints);
  await phone.context.close();

  console.log(JSON.stringify({
    comparison: basename(resolve(folder)), designs: summary.designs.length, bytes: statSync(file).size, pages_a4: paper, replay_ms: replay, curves_ms: curves,
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
