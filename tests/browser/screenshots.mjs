// node screenshots.mjs FOLDER [IMAGES]: report.png, report-dark.png and report-phone.png of a report.

import { mkdirSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { resolve } from "node:path";
import { DESKTOP, PHONE, launch, open, settled } from "./browser.mjs";

const [folder, images = fileURLToPath(new URL("../../docs/images", import.meta.url))] = process.argv.slice(2);
if (folder === undefined) {
  console.error("usage: node screenshots.mjs FOLDER [IMAGES]");
  process.exit(2);
}
mkdirSync(images, { recursive: true });
const browser = await launch();
for (const [name, options] of [
  ["report", DESKTOP],
  ["report-dark", { ...DESKTOP, colorScheme: "dark" }],
  ["report-phone", PHONE],
]) {
  const { page, context } = await open(browser, resolve(folder, "report.html"), options);
  await settled(page);
  await page.screenshot({ path: resolve(images, `${name}.png`) });
  await context.close();
}
await browser.close();
