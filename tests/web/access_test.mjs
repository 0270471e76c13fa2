// Every reader can use the page: in light and dark, at 200 % zoom, by keyboard, without hue.
import assert from 'node:assert/strict';
import { arrive, frames, openReport, state, withoutWebGl } from './browser.mjs';
import { harness } from './harness.mjs';
import { report } from './sample_report.mjs';

const { options, test, run } = harness();
const file = options.sample(report);
const kMinContrast = 4.5; // min contrast of text and background (WCAG 2.2, 1.4.3)

// Returns the lowest contrast of the panels' texts, with the text and the class of its element.
const contrast = (page) =>
  page.evaluate(() => {
    const pen = document.createElement('canvas').getContext('2d', { willReadFrequently: true });
    const over = (colors) => {
      pen.clearRect(0, 0, 1, 1);
      for (const color of colors) {
        pen.fillStyle = color;
        pen.fillRect(0, 0, 1, 1);
      }
      return [...pen.getImageData(0, 0, 1, 1).data].slice(0, 3);
    };
    const light = (rgb) =>
      rgb
        .map((v) => (v / 255 <= 0.04045 ? v / 255 / 12.92 : ((v / 255 + 0.055) / 1.055) ** 2.4))
        .reduce((sum, v, k) => sum + v * [0.2126, 0.7152, 0.0722][k], 0);
    let worst = { ratio: Infinity };
    for (const node of document.querySelectorAll('#side *, #scene-panel *, #timeline output')) {
      const own = [...node.childNodes].some((child) => child.nodeType === 3 && child.data.trim());
      if (!own || !node.checkVisibility()) continue;
      const grounds = [];
      for (let up = node; up; up = up.parentElement)
        grounds.unshift(getComputedStyle(up).backgroundColor);
      const ground = over(grounds);
      const [a, b] = [light(over([...grounds, getComputedStyle(node).color])), light(ground)];
      const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
      if (ratio < worst.ratio) worst = { ratio, text: node.textContent, name: node.className };
    }
    return worst;
  });

for (const theme of ['dark', 'light']) {
  test(`${theme}: every text is readable`, async ({ page }) => {
    await page.emulateMedia({ colorScheme: theme });
    await frames(page, 3);
    assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), theme);
    const worst = await contrast(page);
    console.log(`     least contrast ${worst.ratio.toFixed(2)} (${worst.text})`);
    assert.ok(worst.ratio >= kMinContrast, JSON.stringify(worst));
    await options.picture(page, theme);
  });
}

test('the reader chooses the theme', async ({ page }) => {
  const shown = () => page.evaluate(() => document.documentElement.dataset.theme);
  await page.locator('#view').focus();
  for (const [system, other] of [
    ['light', 'dark'],
    ['dark', 'light'],
  ]) {
    await page.emulateMedia({ colorScheme: system });
    await frames(page, 3);
    assert.deepEqual([await shown(), (await state(page)).theme], [system, 'auto']);
    await page.keyboard.press('y');
    assert.equal(await shown(), other, 'each press changes what is seen');
    await page.keyboard.press('y');
    assert.deepEqual([await shown(), (await state(page)).theme], [system, 'auto']);
  }
});

test('at 200 % zoom nothing is cut off or out of reach', async ({ browser }) => {
  const { page, trouble } = await openReport(browser, file);
  await page.setViewportSize({ width: 640, height: 400 }); // 1280 x 800 at 200 % zoom
  await frames(page, 3);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 640);
  for (const name of ['.play', '.scrub', '.verdict', '.choice.sort select', '#scene-panel .fold'])
    await page.locator(name).first().scrollIntoViewIfNeeded();
  await page.locator('.path').nth(3).click();
  assert.equal((await state(page)).path, 3);
  await page.locator('#scene-panel .fold', { hasText: 'Display' }).click();
  await page.locator('.toggles label', { hasText: 'Heat map' }).click();
  assert.equal((await state(page)).heat, true);
  await options.picture(page, 'zoom', { fullPage: true });
  assert.deepEqual(trouble, []);
  await page.context().close();
});

test('without WebGL everything but the picture works', async ({ browser }) => {
  const { page, trouble } = await openReport(browser, file, { prepare: withoutWebGl });
  assert.match(await page.locator('#stage').innerText(), /no WebGL/);
  assert.equal(await page.locator('#view').isVisible(), false);
  assert.equal(await page.locator('.query').count(), report.queries.length);
  await page.locator('.path').nth(1).click();
  assert.equal((await state(page)).path, 1);
  await page.locator('.play').click();
  await page.waitForFunction(() => window.obby.store.state.tick > 0);
  assert.equal(await page.locator('#hud').isVisible(), true);
  // These keys affect only the picture, which is missing.
  for (const key of ['f', 'g', 't', 'r', 'c', 'b', 'Escape', '9', '9'])
    await page.keyboard.press(key);
  for (let query = 0; query < report.queries.length; query++) {
    await page.locator('.query').nth(query).click();
    await frames(page, 3);
  }
  assert.ok(
    trouble.every((text) => /WebGL/.test(text)),
    trouble.join(),
  );
  await page.context().close();
});

test('the keyboard reaches every control, and each has a name', async ({ page }) => {
  await page.locator('.filters .fold').click();
  await page.locator('#view').focus();
  for (let i = 0; i < 160; i++) {
    await page.keyboard.press('Tab');
    const { what, again } = await page.evaluate(() => {
      const node = document.activeElement;
      const name =
        node.ariaLabel || node.labels?.[0]?.textContent || node.textContent || node.title;
      const reached = Boolean(node.dataset.reached);
      node.dataset.reached = 'yes';
      return { what: `${node.tagName} ${name.trim()}`, again: reached };
    });
    if (again) break; // the focus has passed all controls
    assert.match(what, /^\w+ \S/, 'a control without a name');
  }
  const missed = await page.evaluate(() =>
    [...document.querySelectorAll('button:not([role=option][tabindex="-1"]), select, input')]
      .filter((node) => node.checkVisibility() && !node.dataset.reached)
      .map((node) => node.className || node.ariaLabel),
  );
  assert.deepEqual(missed, []);
});

test('only keyboard focus draws a frame', async ({ page }) => {
  const focused = () =>
    page.evaluate(() => [
      document.activeElement.id,
      getComputedStyle(document.activeElement).outlineStyle,
    ]);
  const view = page.locator('#view');
  for (let round = 0; round < 2; round++) {
    await view.focus();
    await page.keyboard.press('Tab');
    await page.keyboard.press('Shift+Tab');
    assert.deepEqual(await focused(), ['view', 'solid']);
    await page.locator('.query').first().focus();
    await view.click({ button: 'right', position: { x: 400, y: 300 } }); // chooses nothing
    assert.deepEqual(await focused(), ['view', 'none']);
  }
});

test('screen readers read the slider but no ticks', async ({ page }) => {
  await page.evaluate(() => window.obby.store.set({ path: 0, ghost: 1, tick: 66 }));
  const spoken = await page.evaluate(() =>
    [...document.querySelectorAll('#timeline output, #comparison output')].map((node) =>
      node.getAttribute('aria-live'),
    ),
  );
  assert.deepEqual(spoken, ['off', 'off']);
  assert.equal(await page.locator('.scrub').getAttribute('aria-valuetext'), '1.100 of 9.00 s');
  await page.evaluate(() => window.obby.store.set({ ghost: -1 }));
});

test('Space toggles a focused checkbox and otherwise plays', async ({ page }) => {
  const fold = page.getByRole('button', { name: 'Display' });
  const onBox = () => page.evaluate(() => document.activeElement.type === 'checkbox');
  await fold.click();
  await page.keyboard.press('Tab');
  for (const solutions of [false, true]) {
    await page.keyboard.press('Space');
    const now = await state(page);
    assert.deepEqual([now.solutions, now.playing, await onBox()], [solutions, false, true]);
  }
  const attempts = page.locator('.toggles label', { hasText: 'Attempts' });
  await page.locator('#view').focus();
  await attempts.click();
  assert.deepEqual([(await state(page)).attempts, await onBox()], [false, false]);
  for (const playing of [true, false]) {
    await page.keyboard.press('Space');
    const now = await state(page);
    assert.deepEqual([now.attempts, now.playing], [false, playing]);
  }
  await attempts.click();
  await fold.click();
});

test('the time slider handles only its own keys', async ({ page }) => {
  const taken = (init) =>
    page.locator('.scrub').evaluate((slider, how) => {
      const event = new KeyboardEvent('keydown', { ...how, bubbles: true, cancelable: true });
      return !slider.dispatchEvent(event);
    }, init);
  for (const key of ['ArrowLeft', 'ArrowUp', 'PageDown', 'Home', 'End'])
    assert.equal(await taken({ key }), true, key);
  for (const how of [{ key: 'F5' }, { key: 'r', ctrlKey: true }, { key: 'Tab' }])
    assert.equal(await taken(how), false, how.key);
});

test('a report update keeps the keyboard focus', async ({ page }) => {
  const focused = () =>
    page.evaluate(() => {
      const { className, innerText } = document.activeElement;
      return `${className}: ${innerText.slice(0, 40)}`;
    });
  const lasts = async (button) => {
    await button.focus();
    const before = await focused();
    await page.evaluate(() => window.obby.sidebar.refresh());
    assert.equal(await focused(), before);
  };
  await lasts(page.locator('.findings .trajectory').nth(1));
  await lasts(page.locator('.query').nth(2));
  await page.evaluate(() => window.obby.store.set({ query: 1 }));
  await arrive(page);
  await lasts(page.locator('.findings .text', { hasText: 'without Lava' }));
  await lasts(page.locator('.ends .killer', { hasText: 'Lava' })); // it has the same part
  await page.evaluate(() => window.obby.store.set({ query: 0 }));
  await arrive(page);
});

test('the colour scale gets lighter throughout', async ({ page }) => {
  const colors = await page.evaluate(() => {
    window.obby.store.set({ colorBy: 'time' });
    return window.obby
      .query()
      .paths.map((path) => [path.ticks, window.obby.trajectories.coloring.of(path)]);
  });
  const light = (hex) =>
    [1, 3, 5].reduce(
      (sum, at, k) => sum + parseInt(hex.slice(at, at + 2), 16) * [0.21, 0.72, 0.07][k],
      0,
    );
  const sorted = colors.sort((a, b) => a[0] - b[0]).map(([, color]) => light(color));
  sorted.forEach((value, i) => assert.ok(i === 0 || value >= sorted[i - 1] - 0.8, `${sorted}`));
});

test('a row names its verdict and the comparison', async ({ page }) => {
  await page.getByRole('option', { name: 'Solved whole course' }).waitFor();
  await page.getByRole('option', { name: 'Unreachable without jumping' }).waitFor();
  const described = () =>
    page
      .locator('.path[aria-description]')
      .evaluateAll((rows) => rows.map(({ dataset }) => Number(dataset.path)));
  await page.evaluate(() => window.obby.store.set({ path: 0, ghost: 3 }));
  assert.deepEqual(await described(), [3]);
  await page.evaluate(() => window.obby.store.set({ ghost: -1 }));
  assert.deepEqual(await described(), []);
});

test('two fingers zoom and select nothing', async ({ browser }) => {
  const { page, trouble } = await openReport(browser, file, { hasTouch: true });
  const cdp = await page.context().newCDPSession(page);
  const { x, y } = await page.locator('#view').boundingBox();
  const touch = (type, ...offsets) =>
    cdp.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: offsets.map((dx, id) => ({ x: x + 300 + dx, y: y + 250, id })),
    });
  const look = () =>
    page.evaluate(() => {
      const { distance, yaw } = window.obby.stage.rig.goal;
      const { path, part } = window.obby.store.state;
      return { distance, rest: [yaw, path, part] };
    });
  const before = await look();
  await touch('touchStart', -50, 50);
  await touch('touchMove', -100, 100);
  await touch('touchEnd');
  await frames(page, 3);
  const after = await look();
  const share = after.distance / before.distance;
  assert.ok(Math.abs(share - 0.5) < 0.02, `twice as far apart: ${share} of the distance`);
  assert.deepEqual(after.rest, before.rest);
  assert.deepEqual(trouble, []);
  await page.context().close();
});

test('the page raised no error', async ({ trouble }) => assert.deepEqual(trouble, []));

await run(file);
