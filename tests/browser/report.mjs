// node report.mjs FOLDER... opens each report.html offline, plays it, moves its slider, turns and pinches its view. It prints
// one JSON line a report: bytes, opening time, frames a second in software. Exit status 1 if a check fails.

import { statSync } from "node:fs";
import { basename, resolve } from "node:path";
import { Checks, DESKTOP, PHONE, launch, look, open, overflowing, settled, touch } from "./browser.mjs";

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
  await draws(page, checks);
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
  await page.emulateMedia({ colorScheme: "light", media: "print" });
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
