// node report.mjs FOLDER... opens each report.html offline, plays it, moves its slider, turns and pinches its view. It prints
// one JSON line a report: bytes, opening time, frames a second in software. Exit status 1 if a check fails.

import { readFileSync, statSync } from "node:fs";
import { basename, resolve } from "node:path";
import {
  Checks, DESKTOP, PHONE, contents, launch, look, open, overflowing, pages, ruler, settled, touch,
} from "./browser.mjs";

/** Most pages of A4 of a report whose inputs have at most this many lines; longer inputs may spill over. */
const [MOST_PAGES, LINES] = [4, 80];

const STAGE = "#replay-view";
const time = (page) => page.evaluate(() => netcast.player.time);
const camera = (page) =>
  page.evaluate(() => {
    const { azimuth, elevation, distance, pan } = netcast.player.look.camera;
    return { azimuth, elevation, distance, pan };
  });
const seek = async (page, at) => {
  await page.evaluate((at) => netcast.player.seek(at), at);
  await settled(page);
};
const middle = async (page, selector) => {
  const box = await page.locator(selector).first().boundingBox();
  return [box.x + box.width / 2, box.y + box.height / 2];
};

async function draws(page, checks) {
  const seen = await look(page, STAGE);
  checks.holds("the net is drawn", seen.drawn > 800, seen);
  checks.holds("ropes have the colour of their tension", seen.vivid > 100, seen);
  const labels = await page.locator(".replay-label > span:visible").allTextContents();
  checks.holds("something is labelled", labels.length > 0);
}

/** The ruler measures the view at any zoom; the wind has an arrow where there is wind; nothing covers the readout. */
async function signs(page, checks, summary) {
  const measures = async () => {
    const { text, metres, width, pixel } = await ruler(page, STAGE);
    checks.holds("the ruler is in metres", /^[\d.]+ m$/.test(text), text);
    checks.near("the ruler is as long as it says", width * pixel, metres, 0.02 * metres);
    checks.holds("the ruler is neither short nor long", width > 35 && width < 115, width);
    return metres;
  };
  const before = await measures();
  await page.evaluate(() => netcast.player.zoom(0.1));
  await settled(page);
  checks.holds("the ruler follows the zoom", (await measures()) < 0.3 * before);
  await page.evaluate(() => netcast.player.reset());
  await settled(page);

  const blows = (summary.air?.wind_m_s ?? []).some((speed) => speed !== 0);
  checks.holds("an arrow where there is wind alone", ((await page.locator(".replay-wind").count()) === 1) === blows);
  if (blows) {
    const arrow = () => page.locator(".replay-wind path").getAttribute("d");
    const first = await arrow();
    await page.evaluate(() => netcast.player.lookFrom("side"));
    await settled(page);
    checks.holds("the arrow turns with the camera", (await arrow()) !== first);
    await page.evaluate(() => netcast.player.reset());
  }
  const duration = await page.evaluate(() => netcast.player.duration);
  for (const share of [0.1, 0.3, 0.6, 1]) {
    for (const from of ["three-quarter", "side", "axis"]) {
      await page.evaluate((from) => netcast.player.lookFrom(from), from);
      await seek(page, share * duration);
      const covered = await page.evaluate((stage) => {
        const boxes = (selector) => [...document.querySelectorAll(`${stage} ${selector}`)]
          .filter((part) => getComputedStyle(part).visibility === "visible").map((part) => part.getBoundingClientRect());
        const signs = boxes(":is(.replay-state, .replay-ruler, .replay-wind)");
        return boxes(".replay-label > span").filter((label) => signs.some((sign) =>
          label.left < sign.right && label.right > sign.left && label.top < sign.bottom && label.bottom > sign.top)).length;
      }, STAGE);
      checks.holds(`no label lies over the readout, ${from} at ${share}`, covered === 0, covered);
    }
  }
  await page.evaluate(() => netcast.player.reset());
  await settled(page);
}

/** All curves of a figure look different, and channels of energy that are zero all along have none. */
async function distinct(page, checks, folder) {
  const figures = await page.evaluate(() => netcast.charts.charts.map(({ figure, plot, key }) => ({
    id: figure.id,
    names: figure.curves.map(({ name }) => name),
    looks: plot.data.map(({ line }) => `${line.color} ${line.dash}`),
    keys: [...key.querySelectorAll("button")].map((entry) => `${entry.style.cssText} ${entry.className}`),
  })));
  for (const { id, looks, keys } of figures) {
    checks.holds(`no two curves of ${id} look alike`, new Set(looks).size === looks.length, looks);
    checks.holds(`no two names of ${id} look alike`, new Set(keys).size === keys.length, keys);
  }
  const [head, ...rows] = readFileSync(resolve(folder, "history.csv"), "utf8").trim().split("\n").map((row) => row.split(","));
  const energies = figures.find(({ id }) => id === "energies")?.names ?? [];
  for (const [column, title] of head.entries()) {
    const channel = title.match(/^energy_(.*)_j$/)?.[1].replaceAll("_", " ");
    if (channel === undefined || rows.some((row) => Number(row[column]) !== 0)) continue;
    checks.holds(`${channel}, zero all along, has no curve`, !energies.includes(channel));
  }
}

/** Replay and pictures have one scale of tension. */
async function oneScale(page, checks) {
  const { edges, keys } = await page.evaluate(() => ({
    edges: netcast.player.look.edges,
    keys: [...document.querySelectorAll(".net-key svg")].map((key) => [...key.querySelectorAll("text")].at(-1).textContent),
  }));
  const factor = { k: 1e3, M: 1e6 };
  for (const key of keys)
    checks.near("the pictures' scale ends as the replay's", parseFloat(key) * (factor[key.at(-1)] ?? 1), edges.at(-1), 1e-9 * edges.at(-1));
}

async function plays(page, checks) {
  await seek(page, 0);
  const before = await look(page, STAGE);
  await page.locator(STAGE).focus();
  await page.keyboard.press("Space");
  await page.waitForTimeout(2500);
  const { from, fps, playing } = await page.evaluate(() => {
    const { time, framesPerSecond, playing } = netcast.player;
    return { from: time, fps: framesPerSecond, playing };
  });
  checks.holds("it plays", playing && from > 0);
  const goesOn = page.waitForFunction((from) => netcast.player.time > from, from, { timeout: 5000 });
  checks.holds(
    "time goes on while it plays",
    await goesOn.then(
      () => true,
      () => false,
    ),
  );
  await page.keyboard.press("Space");
  await settled(page);
  const rest = await time(page);
  checks.holds("the picture changes", (await look(page, STAGE)).sum !== before.sum);
  await page.waitForTimeout(200);
  checks.holds("it pauses", (await time(page)) === rest);
  checks.holds(
    "it tells its frames a second",
    await page.evaluate(() => Number(document.querySelector("[data-fps]").dataset.fps) > 0),
  );
  return fps;
}

async function scrubs(page, checks) {
  const [times, duration] = await page.evaluate(() => [netcast.player.times, netcast.player.duration]);
  const press = async (key) => {
    await page.keyboard.press(key);
    await settled(page);
  };
  await page.locator(STAGE).focus();
  await press("Home");
  checks.near("Home", await time(page), 0, 0);
  await press("ArrowRight");
  await press("ArrowRight");
  checks.near("two frames on", await time(page), times[2], 1e-12);
  await press("ArrowLeft");
  checks.near("a frame back", await time(page), times[1], 1e-12);
  await press("End");
  checks.near("End", await time(page), duration, 0);

  const slider = page.locator(".replay-transport input");
  // the replay may reach below the window
  await slider.scrollIntoViewIfNeeded();
  const box = await slider.boundingBox();
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  await settled(page);
  checks.near("the slider's middle", await time(page), duration / 2, 0.02 * duration);
  await press("ArrowRight");
  checks.holds("arrows step on the slider too", times.includes(await time(page)));
}

async function turns(page, checks) {
  const [x, y] = await middle(page, STAGE);
  const start = await camera(page);
  const drag = async (button) => {
    await page.mouse.move(x, y);
    await page.mouse.down({ button });
    await page.mouse.move(x + 120, y + 40, { steps: 4 });
    await page.mouse.up({ button });
    await settled(page);
  };
  await drag("left");
  const turned = await camera(page);
  checks.holds("a drag turns", turned.azimuth !== start.azimuth && turned.elevation !== start.elevation);
  await drag("right");
  checks.holds(
    "a right drag moves",
    (await camera(page)).pan.some((part) => part !== 0),
  );
  await page.mouse.wheel(0, -240);
  await settled(page);
  checks.holds("the wheel zooms in", (await camera(page)).distance < turned.distance);
  await page.keyboard.press("2");
  await settled(page);
  checks.near(
    "2 looks along the axis, from ahead",
    await page.evaluate(() => {
      const { camera } = netcast.player.look;
      return camera.frame.back.reduce((sum, part, axis) => sum + part * camera.axis[axis], 0);
    }),
    1,
    1e-9,
  );
  await page.keyboard.press("r");
  await settled(page);
  const home = await camera(page);
  checks.holds("r brings the camera back", home.azimuth === start.azimuth && home.distance === start.distance, {
    home,
    start,
  });
  for (const mode of ["linear", "class", "log"]) {
    await page.getByLabel("Colour of the ropes").selectOption(mode);
    await settled(page);
    const { vivid } = await look(page, STAGE);
    checks.holds(`ropes are drawn in colour: ${mode}`, vivid > 100, vivid);
  }
}

/** The cursor is at the place of the time in plotly's axis, and a press in a figure moves the replay to its time. */
async function linked(page, checks) {
  const figures = await page.evaluate(() => netcast.charts.charts.map(({ figure }) => figure.id));
  const duration = await page.evaluate(() => netcast.player.duration);
  checks.holds("there are curves", figures.length > 0);
  for (const [place, id] of figures.entries()) {
    const at = duration * (0.2 + (0.6 * place) / figures.length);
    await page.locator(`#${id}`).scrollIntoViewIfNeeded();
    await page.waitForTimeout(60);
    await seek(page, at);
    const { cursor, expected, left, top, width, height } = await page.evaluate(
      ([id, at]) => {
        const plot = document.getElementById(id),
          { xaxis, yaxis } = plot._fullLayout,
          box = plot.getBoundingClientRect();
        const line = plot.parentElement.querySelector(".cursor").getBoundingClientRect();
        return {
          cursor: line.left + line.width / 2,
          expected: box.left + xaxis._offset + xaxis.l2p(at),
          left: box.left + xaxis._offset,
          top: box.top + yaxis._offset,
          width: xaxis._length,
          height: yaxis._length,
        };
      },
      [id, at],
    );
    checks.near(`the cursor of ${id}`, cursor, expected, 1);
    await page.mouse.click(left + 0.4 * width, top + height / 2);
    await settled(page);
    const asked = await page.evaluate(
      ([id, x]) => document.getElementById(id)._fullLayout.xaxis.p2l(x),
      [id, 0.4 * width],
    );
    checks.near(`a press in ${id}`, await time(page), Math.min(duration, Math.max(0, asked)), 0.01 * duration);
    // a user who seeks there sees the replay
    const box = await page.locator(STAGE).boundingBox();
    checks.holds(`the replay is in sight beside ${id}`, box.y > -box.height / 2 && box.y < 1000 - box.height / 2, box);
    if (await page.locator(".replay-close").isVisible()) await page.locator(".replay-close").click();
  }
  await page.evaluate(() => scrollTo(0, 0));
}

async function phone(browser, file, checks) {
  const { page, context, complaints } = await open(browser, file, PHONE);
  checks.holds("nothing stands out on a phone", (await overflowing(page)).length === 0, await overflowing(page));
  await contents(page, checks);
  await page.locator(STAGE).scrollIntoViewIfNeeded();
  await draws(page, checks);
  const [x, y] = await middle(page, STAGE);
  const start = await camera(page);
  await touch(page, [
    [x - 40, y],
    [x + 60, y + 30],
  ]);
  const turned = await camera(page);
  checks.holds("a finger turns", turned.azimuth !== start.azimuth, turned);
  await touch(
    page,
    [
      [x - 30, y],
      [x - 120, y],
    ],
    [
      [x + 30, y],
      [x + 120, y],
    ],
  );
  checks.near("two fingers zoom", (await camera(page)).distance / turned.distance, 0.25, 0.02);
  for (const control of await page.locator(".replay-controls :is(button, select, input):visible").all()) {
    await control.scrollIntoViewIfNeeded();
    const box = await control.boundingBox();
    checks.holds("a control is within reach", box.x >= 0 && box.x + box.width <= 390 && box.height >= 32, box);
  }
  await page.locator(".replay-play").tap();
  await page.waitForTimeout(500);
  checks.holds("a tap plays", await page.evaluate(() => netcast.player.playing));
  checks.holds("no complaint on a phone", complaints.length === 0, complaints);
  await context.close();
}

async function withoutWebGl(browser, file, checks) {
  const { page, context, complaints } = await open(browser, file, DESKTOP, () => {
    const { getContext } = HTMLCanvasElement.prototype;
    HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
      return kind === "webgl2" ? null : getContext.call(this, kind, ...more);
    };
  });
  checks.holds("without WebGL 2 a sentence", (await page.locator(STAGE).textContent()).includes("WebGL 2"));
  await linked(page, checks);
  checks.holds("no complaint without WebGL 2", complaints.length === 0, complaints);
  await context.close();
}

async function check(browser, folder) {
  const checks = new Checks();
  const file = resolve(folder, "report.html");
  const { page, context, complaints } = await open(browser, file);
  const summary = JSON.parse(readFileSync(resolve(folder, "summary.json"), "utf8"));
  await draws(page, checks);
  await contents(page, checks);
  await signs(page, checks, summary);
  await distinct(page, checks, folder);
  await oneScale(page, checks);
  const fps = await plays(page, checks);
  await scrubs(page, checks);
  await turns(page, checks);
  await linked(page, checks);
  checks.holds("nothing stands out", (await overflowing(page)).length === 0, await overflowing(page));
  await page.emulateMedia({ colorScheme: "dark" });
  await settled(page);
  const dark = await look(page, STAGE);
  checks.holds("dark when the reader's screen is", dark.brightness < 0.3, dark);
  checks.holds("drawn in the dark", dark.vivid > 100, dark);
  const paper = await pages(page);
  const lines = (await page.locator(".inputs pre").textContent()).split("\n").length;
  checks.holds("few pages on paper", paper <= MOST_PAGES + (lines > LINES ? 1 : 0), paper);
  await page.emulateMedia({ colorScheme: "dark", media: "print" });
  const card = await page.evaluate(() => getComputedStyle(document.documentElement).getPropertyValue("--card").trim());
  checks.holds("ink on white on paper, also for a reader in the dark", card === "#ffffff", card);
  checks.holds("no empty stage on paper", !(await page.locator(STAGE).isVisible()));
  checks.holds("no complaint", complaints.length === 0, complaints);
  const size = await page.evaluate(() => {
    const { data } = netcast.player.views[0];
    return { segments: data.segments, frames: data.frames };
  });
  await context.close();
  await phone(browser, file, checks);
  await withoutWebGl(browser, file, checks);

  // the opening time of a second opening: the browser has started by now
  const again = await open(browser, file);
  const [painted, replay, curves] = await again.page.evaluate(() =>
    ["first-contentful-paint", "replay", "curves"].map((name) => performance.getEntriesByName(name)[0]?.startTime),
  );
  await again.context.close();
  const round = (value) => Math.round(10 * value) / 10;
  console.log(
    JSON.stringify({
      report: basename(resolve(folder)),
      bytes: statSync(file).size,
      ...size,
      pages_a4: paper,
      first_paint_ms: round(painted),
      replay_ms: round(replay),
      curves_ms: round(curves),
      frames_per_s_software: round(fps),
      failures: checks.failures,
    }),
  );
  return checks.failures.length === 0;
}

const folders = process.argv.slice(2);
if (folders.length === 0) {
  console.error("usage: node report.mjs FOLDER...");
  process.exit(2);
}
const browser = await launch();
const fine = [];
for (const folder of folders) fine.push(await check(browser, folder));
await browser.close();
process.exit(fine.every(Boolean) ? 0 : 1);
