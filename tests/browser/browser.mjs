// A Chromium without network. Every error on its console is a failure; WebGL is drawn in software.

import { chromium } from "playwright-core";

const ARGS = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"];
export const DESKTOP = { viewport: { width: 1440, height: 1000 } };
export const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 };

/** The path of the browser: the variable CHROMIUM, or else that of Debian. */
export const launch = () =>
  chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ARGS });

/** Opens a file in a new context and waits until the page is complete. `before` runs ahead of the page's scripts. */
export async function open(browser, file, options = DESKTOP, before = null) {
  const context = await browser.newContext({ colorScheme: "light", reducedMotion: "no-preference", ...options });
  await context.setOffline(true);
  const page = await context.newPage();
  const complaints = [];
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) complaints.push(message.text());
  });
  page.on("pageerror", (error) => complaints.push(error.stack ?? error.message));
  page.on("request", (request) => {
    if (!/^(file|data|blob):/.test(request.url())) complaints.push(`asks for ${request.url()}`);
  });
  if (before !== null) await page.addInitScript(before);
  await page.goto(`file://${file}`, { waitUntil: "load" });
  await page.waitForFunction(() => window.netcast !== undefined, null, { timeout: 60_000 });
  await settled(page);
  return { page, context, complaints };
}

/** Waits until pending drawing is done. */
export const settled = (page) =>
  page.evaluate(
    () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done)))),
  );

/**
 * Figures of an element's picture: the number of pixels that differ from its background, the number of vivid ones (only ropes
 * are vivid), the brightness of the background (0 to 1), and a checksum that distinguishes pictures.
 */
export async function look(page, selector) {
  // text has colours of its own
  const style = ".replay-state, .replay-title, .replay-labels { visibility: hidden !important; }";
  const picture = (await page.locator(selector).first().screenshot({ style })).toString("base64");
  return page.evaluate(async (picture) => {
    const image = new Image();
    image.src = `data:image/png;base64,${picture}`;
    await image.decode();
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [image.width, image.height];
    const context = canvas.getContext("2d");
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
    const at = 4 * (10 * canvas.width + 10);
    const ground = data.slice(at, at + 3);
    let drawn = 0,
      vivid = 0,
      sum = 0;
    for (let place = 0; place < data.length; place += 4) {
      const [red, green, blue] = [data[place], data[place + 1], data[place + 2]];
      if (Math.abs(red - ground[0]) + Math.abs(green - ground[1]) + Math.abs(blue - ground[2]) > 24) drawn++;
      if (Math.max(red, green, blue) - Math.min(red, green, blue) > 90) vivid++;
      sum = (sum * 31 + red + 256 * green + 65536 * blue) % 4294967291;
    }
    return { drawn, vivid, sum, brightness: (ground[0] + ground[1] + ground[2]) / 765 };
  }, picture);
}

/** The elements beyond the right edge of the window, except those inside a scrolling element. */
export const overflowing = (page) =>
  page.evaluate(() => {
    const scrolls = (element) =>
      element !== null &&
      (["auto", "scroll", "hidden"].includes(getComputedStyle(element).overflowX) || scrolls(element.parentElement));
    const wide = [...document.body.querySelectorAll("*")].filter(
      (element) =>
        element.getBoundingClientRect().right > innerWidth + 0.5 &&
        !scrolls(element.parentElement) &&
        element.checkVisibility(),
    );
    const names = wide.map((element) => `${element.tagName.toLowerCase()}.${element.getAttribute("class") ?? ""}`);
    return document.documentElement.scrollWidth > innerWidth
      ? [...names, `the page: ${document.documentElement.scrollWidth} px`]
      : names;
  });

/** The contents list every section of the page, in order, and each link leads to its section. */
export async function contents(page, checks) {
  const { links, sections, side } = await page.evaluate(() => {
    const [list, main] = [".contents", "main"].map((part) => document.querySelector(part).getBoundingClientRect());
    return {
      links: [...document.querySelectorAll(".contents a")].map((link) => [link.getAttribute("href"), link.textContent]),
      sections: [...document.querySelectorAll("main > section[id]")].map(({ id, firstElementChild }) => [
        `#${id}`,
        firstElementChild.textContent,
      ]),
      side: innerWidth >= 1200 ? list.right <= main.left : list.bottom <= main.top + 1,
    };
  });
  checks.holds("there are contents", links.length > 2, links);
  checks.holds("the contents list the sections", JSON.stringify(links) === JSON.stringify(sections), { links, sections });
  checks.holds("the contents lie beside or above the page", side);
}

/** The number of pages of the page on A4 paper. */
export async function pages(page) {
  const text = (await page.pdf({ format: "A4", printBackground: true })).toString("latin1");
  return text.match(/\/Type\s*\/Page\b/g).length;
}

/** The numbers of the ruler over a view: metres, its width in px and the metres in a pixel. */
export const ruler = (page, view) =>
  page.evaluate((view) => {
    const host = document.querySelector(view), sign = host.querySelector(".replay-ruler");
    const { camera } = netcast.player.look;
    return {
      text: sign.textContent,
      metres: parseFloat(sign.textContent),
      width: sign.getBoundingClientRect().width,
      pixel: camera.pixel(host.clientWidth, host.clientHeight),
    };
  }, view);

/** Puts one or two fingers down, moves them along straight lines and lifts them. A finger is [[x, y], [x, y]]. */
export async function touch(page, ...fingers) {
  const client = await page.context().newCDPSession(page);
  const points = (share) =>
    fingers.map(([from, to], id) => ({
      id,
      x: from[0] + share * (to[0] - from[0]),
      y: from[1] + share * (to[1] - from[1]),
    }));
  await client.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: points(0) });
  for (let step = 1; step <= 8; step++)
    await client.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints: points(step / 8) });
  await client.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  await client.detach();
  await settled(page);
}

/** Collects failed checks, so that one run reports all of them. */
export class Checks {
  failures = [];

  holds(what, condition, found = "") {
    if (!condition) this.failures.push(`${what}${found === "" ? "" : `: ${JSON.stringify(found)}`}`);
  }

  near(what, got, expected, tolerance) {
    this.holds(what, Math.abs(got - expected) <= tolerance, { got, expected });
  }
}
