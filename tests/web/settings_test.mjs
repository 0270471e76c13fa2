// The browser keeps camera mode, colours, speed and layers for the next page, and the help resets
// them.
import assert from 'node:assert/strict';
import { pathToFileURL } from 'node:url';
import { settingsOf } from '../../web/src/view_settings.js';
import { frames, openReport, started, state } from './browser.mjs';
import { harness } from './harness.mjs';
import { report } from './sample_report.mjs';

const { options, test, run } = harness();
const file = options.sample(report);

const kChosen = {
  ...{ colorBy: 'height', colors: 'level', speed: 2, theme: 'dark', loop: false, attempts: true },
  ...{ runners: true, regions: false, labels: false, motionPaths: false, grid: false, heat: true },
};

// Returns what the page draws and what its controls say.
const shown = (page) =>
  page.evaluate(() => {
    const { stage, store } = window.obby;
    return {
      ends: stage.markers.ends.visible,
      runners: stage.markers.runners.visible,
      regions: stage.regionView.group.visible,
      grid: stage.grid.visible,
      motionPaths: stage.motionPaths.visible,
      colored: stage.pathView.played.material.vertexColors,
      tiles: store.state.heatMax > 0,
      theme: document.documentElement.dataset.theme,
      speed: document.querySelector('#timeline select').value,
      loop: document.querySelector('#timeline [aria-pressed]').getAttribute('aria-pressed'),
      checks: [...document.querySelectorAll('.toggles input')].map((input) => input.checked),
      choice: document.querySelector('.choice.colorBy select').value,
    };
  });

async function openAgain(page) {
  await page.goto('about:blank');
  await page.goto(pathToFileURL(file).href);
  await started(page);
}

test('only values that this version knows are taken', () => {
  assert.deepEqual(settingsOf('{"grid":false,"speed":3,"colorBy":"mood","tick":9}'), { grid: false });
  for (const text of [null, 'x', 'null', '[]', '7']) assert.deepEqual(settingsOf(text), {});
});

test('the next page begins with the settings of the last', async ({ browser }) => {
  const { page, trouble } = await openReport(browser, file, { attempts: false, colorScheme: 'light' });
  const first = await shown(page);
  await page.evaluate((values) => window.obby.store.set(values), kChosen);
  await frames(page, 2);
  const before = await shown(page);
  await openAgain(page);
  assert.deepEqual(await shown(page), before);
  assert.equal((await state(page)).follow, false);

  // The camera follows again, unless a link says where the camera is.
  await page.evaluate(() => window.obby.store.set({ follow: true }));
  await openAgain(page);
  assert.equal((await state(page)).follow, true);
  await frames(page, 3);
  await options.picture(page, 'settings-kept');
  await page.goto('about:blank');
  await page.goto(`${pathToFileURL(file).href}#cam=5,30,40,0.4,-0.6,30`);
  await started(page);
  assert.equal((await state(page)).follow, false);

  await page.locator('#view').focus();
  await page.keyboard.press('?');
  await options.picture(page, 'settings-help');
  await page.getByRole('button', { name: 'Reset view settings' }).click();
  assert.equal(await page.locator('#help').isVisible(), false);
  assert.deepEqual(await shown(page), first);
  await openAgain(page);
  assert.deepEqual(await shown(page), first);
  assert.deepEqual(trouble, []);
  await page.context().close();
});

test('a browser that refuses storage shows the page all the same', async ({ browser }) => {
  const refuse = (page) =>
    page.addInitScript(() => {
      Object.defineProperty(window, 'localStorage', {
        get: () => {
          throw new DOMException('refused', 'SecurityError');
        },
      });
    });
  const { page, trouble } = await openReport(browser, file, { prepare: refuse });
  await page.evaluate(() => window.obby.store.set({ grid: false }));
  assert.equal((await state(page)).grid, false);
  assert.deepEqual(trouble, []);
  await page.context().close();
});

await run();
