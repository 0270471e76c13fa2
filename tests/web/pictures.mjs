// Makes the picture and the film of the guides from reports of levels/demo.rbxlx, for
// scripts/pictures: node pictures.mjs WEB CHROMIUM REPORT WHOLE FOLDER
// REPORT has its stages, WHOLE a run from the start to the last pad.
import { join } from 'node:path';
import { frames, launch, openReport } from './browser.mjs';

const [web, chromium, report, whole, folder] = process.argv.slice(2);
const kPage = { attempts: false, density: 1, viewport: { width: 1360, height: 800 } };
// The film's bits grow with its pixels: 20 seconds of this size take less than 1.5 MB.
const kFilm = { ...kPage, viewport: { width: 528, height: 484 } };
const kQuery = '#q=stage3';
const kPatience = 900000; // ms; without a GPU a picture of the film takes half a second

const browser = await launch(web, chromium);
try {
  const { page } = await openReport(browser, report, { ...kPage, fragment: `${kQuery}&t=3.5` });
  await page.evaluate(() => window.obby.store.set({ theme: 'dark' }));
  await frames(page, 4);
  await page.screenshot({ path: join(folder, 'viewer.jpg'), type: 'jpeg', quality: 85 });
  await page.context().close();

  const filmed = await openReport(browser, whole, kFilm);
  const values = { follow: true, isolate: true };
  await filmed.page.evaluate((v) => window.obby.store.set(v), values);
  await frames(filmed.page, 30); // the camera arrives behind the player
  const [film] = await Promise.all([
    filmed.page.waitForEvent('download', { timeout: kPatience }),
    filmed.page.evaluate(() => window.obby.film.toggle()),
  ]);
  await film.saveAs(join(folder, 'follow.webm'));
  console.log(`pictures: ${folder}/viewer.jpg, ${folder}/follow.webm`);
} finally {
  await browser.close();
}
