// node screenshots.mjs REPORT COMPARISON [IMAGES] writes report.png, report-dark.png and report-phone.png of a result folder
// and compare.png of the folder of a comparison.

import { mkdirSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { resolve } from "node:path";
import { DESKTOP, PHONE, launch, open, settled } from "./browser.mjs";

const [report, comparison, images = fileURLToPath(new URL("../../docs/images", import.meta.url))] = process.argv.slice(2);
if (comparison === undefined) {
  console.error("usage: node screenshots.mjs REPORT COMPARISON [IMAGES]");
  process.exit(2);
}
mkdirSync(images, { recursive: true });
const browser = await launch();
for (const [name, folder, options] of [
  ["report", report, DESKTOP],
  ["report-dark", report, { ...DESKTOP, colorScheme: "dark" }],
  ["report-phone", report, PHONE],
  ["compare", comparison, { viewport: { width: 1440, height: 1900 } }],
]) {
  const { page, context } = await open(browser, resolve(folder, "report.html"), options);
  await settled(page);
  await page.screenshot({ path: resolve(images, `${name}.png`) });
  await context.close();
}
await browser.close();
