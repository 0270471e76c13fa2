// Tests the tools: ruler, typed time, loop range, colours along a line, the tree of parts, and what
// the page saves.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { foundParts, partTree } from '../../web/src/part_tree.js';
import { rangeOf } from '../../web/src/playback.js';
import { measure, rulerText } from '../../web/src/ruler.js';
import { byScalar } from '../../web/src/scalar_colors.js';
import { byStep } from '../../web/src/step_colors.js';
import { parseTime } from '../../web/src/ui/clock.js';
import { frames, state } from './browser.mjs';
import { harness } from './harness.mjs';
import { report } from './sample_report.mjs';
import { lava } from './sample_parts.mjs';

const { options, test, run } = harness();
const put = (page, values) => page.evaluate((v) => window.obby.store.set(v), values);
const tagged = { ...report.levels[0], tags: { [lava]: ['Hazard', 'KillBrick'] } };
const file = options.sample({ ...report, levels: [tagged] });

test('the ruler tells distance, reach and height', () => {
  assert.deepEqual(measure([1, 2, 3], [4, 2, 7]), { distance: 5, reach: 5, height: 0 });
  assert.equal(rulerText([0, 0, 0], [3, -12, 4]), '13.0 studs: reach 5.0, height -12.0');
  assert.equal(rulerText([0, 1, 0], [3, 13, 4]), '13.0 studs: reach 5.0, height +12.0');
  assert.equal(rulerText([0, 0, 0], [3, -0.01, 4]), '5.0 studs: reach 5.0, height 0.0');
});

test('a time can be seconds, or minutes and seconds', () => {
  const times = { 3: 3, '3.25': 3.25, '3,25 s': 3.25, '1:03.5': 63.5, ' 0:07 ': 7, '.5': 0.5 };
  for (const [text, seconds] of Object.entries(times)) assert.equal(parseTime(text), seconds, text);
  for (const text of ['', 'x', '1:', '-2', '1:2:3']) assert.ok(Number.isNaN(parseTime(text)), text);
});

test('a range bounds the loop', () => {
  const range = { loop: true, loopFrom: 60, loopTo: 90 };
  assert.deepEqual(rangeOf(range, 200), { from: 60, to: 90, isPart: true });
  assert.deepEqual(rangeOf(range, 80), { from: 60, to: 80, isPart: true });
  for (const none of [{ loop: false }, { loopTo: 60 }, { loopFrom: 0, loopTo: 0 }])
    assert.deepEqual(rangeOf({ ...range, ...none }, 200), { from: 0, to: 200, isPart: false });
});

test('parts form a tree, and are found by all words of a search', () => {
  const names = ['W/Stage 1/Lava', 'W/Stage 1/Step', 'W/Deep/Only/Rock', 'Bare'];
  const level = { count: 4, names };
  const root = partTree(level);
  assert.deepEqual([...root.folders.keys(), root.parts], ['W', [3]]);
  const { folders } = root.folders.get('W');
  assert.deepEqual(
    [...folders.values()].map(({ name, count, parts }) => [name, count, parts]),
    [['Stage 1', 2, [0, 1]], ['Deep/Only', 1, [2]]],
  );
  const more = (part) => (part === 0 ? 'Kills' : '');
  assert.deepEqual(foundParts(level, 'stage 1', more), [0, 1]);
  assert.deepEqual(foundParts(level, 'kills STAGE', more), [0]);
});

test('colours along a line follow speed and height', () => {
  const points = Float32Array.from([0, 0, 0, 1, 0, 0, 2, 0, 0, 4, 5, 0, 6, 9, 0]);
  const path = { kind: 'solution', points, samples: 5, tickOf: (i) => i };
  const { along, legend } = byScalar({ paths: [path] }, 'height', 60);
  assert.notEqual(along(path, 0), along(path, 4));
  assert.equal(along(path, 0), along(path, 1));
  assert.deepEqual(legend.map(([label]) => label), ['0.0 studs', '2.5 studs', '5.0 studs']);
  assert.deepEqual(byScalar({ paths: [] }, 'speed', 60).legend, []);
});

test('colours by margin and by time to press follow the steps of a solution', () => {
  const { steps } = report.queries[0].trajectories[0].difficulty;
  const path = { difficulty: { steps }, tickOf: (i) => i };
  const bare = { tickOf: (i) => i };
  const margin = byStep({ paths: [path, bare] }, 'margin');
  const at = (tick) => margin.along(path, tick);
  const [least, , most, none] = margin.legend.map(([, color]) => color);
  assert.equal(at(100), least, 'beyond the edge');
  assert.equal(margin.of(path), least, 'a trajectory is as its closest step');
  assert.notEqual(at(0), at(70));
  assert.notEqual(at(70), most, 'the nearer of edge and part that kills counts');
  assert.equal(at(140), none);
  assert.equal(margin.along(bare, 0), none);
  const window = byStep({ paths: [path] }, 'window');
  assert.equal(window.along(path, 0), none, 'a step without a jump');
  assert.notEqual(window.along(path, 90), none);
  assert.deepEqual(byStep({ paths: [bare] }, 'window').legend.map(([label]) => label), ['Not measured']);
});

test('two clicks measure, and Escape ends it', async ({ page }) => {
  await page.locator('#view').focus();
  await page.keyboard.press('m');
  const status = page.locator('#status');
  assert.match(await status.innerText(), /click two points/);
  const view = await page.locator('#view').boundingBox();
  const at = (x, y) => page.mouse.click(view.x + x * view.width, view.y + y * view.height);
  await at(0.4, 0.45);
  assert.match(await status.innerText(), /second point/);
  await at(0.6, 0.5);
  assert.match(await status.innerText(), /^\d+\.\d studs: reach \d+\.\d, height [+-]?\d+\.\d$/);
  await frames(page, 2);
  assert.equal(await page.locator('.label', { hasText: 'reach' }).count(), 1);
  assert.equal((await state(page)).path, 0, 'no trajectory was selected');
  await page.keyboard.press('Escape');
  const { ruler, measuring } = await state(page);
  assert.deepEqual([ruler.length, measuring, await status.isVisible()], [0, false, false]);
});

test('a click on the clock takes a time', async ({ page }) => {
  await put(page, { playing: false, tick: 0 });
  await page.locator('.clock .time').click();
  await page.keyboard.type('1.5');
  await page.keyboard.press('Enter');
  assert.equal((await state(page)).tick, 90);
  assert.match(await page.locator('.clock .time').innerText(), /^1\.500 \//);
  await page.locator('.clock .time').click();
  await page.keyboard.type('l');
  await page.keyboard.press('Escape');
  const { tick, loop, path } = await state(page);
  assert.deepEqual([tick, loop, path], [90, true, 0], 'letters in the field are no shortcuts');
});

test('comma and period step one tick, and clock and player are exact', async ({ page }) => {
  await page.locator('#view').focus();
  const { rate, points } = await page.evaluate(() => {
    const [path] = window.obby.query().paths;
    return { rate: window.obby.playback.rateOf(), points: [...path.points.slice(0, 12)] };
  });
  await put(page, { tick: 0.4, playing: true });
  for (const tick of [1, 2, 3]) {
    await page.keyboard.press('.');
    assert.deepEqual([(await state(page)).tick, (await state(page)).playing], [tick, false]);
    const time = (tick / rate).toFixed(3);
    const shown = await page.locator('.clock').innerText();
    assert.ok(shown.startsWith(`${time} /`) && shown.includes(`tick ${tick}`), shown);
    const at = await page.evaluate((t) => window.obby.path().poseAt(t), tick);
    assert.deepEqual([at.x, at.y, at.z], points.slice(3 * tick, 3 * tick + 3));
  }
  await page.keyboard.press(',');
  assert.equal((await state(page)).tick, 2);
  // A typed time leads to the tick that shows it.
  await page.locator('.clock .time').click();
  await page.keyboard.type((7 / rate).toFixed(2));
  await page.keyboard.press('Enter');
  assert.equal((await state(page)).tick, 7);
  await page.locator('#view').focus();
});

test('the loop runs in a range', async ({ page }) => {
  await page.locator('#view').focus();
  await put(page, { tick: 100 });
  await page.keyboard.press('<');
  await put(page, { tick: 130 });
  await page.keyboard.press('>');
  assert.equal(await page.locator('.profile .range').count(), 1);
  await put(page, { playing: true, tick: 120 });
  const ticks = await page.evaluate(() => {
    const { playback, store } = window.obby;
    return Array.from({ length: 20 }, () => {
      playback.advance(0.05);
      return store.state.tick;
    });
  });
  assert.ok(ticks.every((tick) => tick >= 100 && tick <= 130), `${ticks}`);
  await put(page, { playing: false });
  await page.keyboard.press('l');
  const { loop, loopTo } = await state(page);
  assert.deepEqual([loop, loopTo, await page.locator('.profile .range').count()], [false, 0, 0]);
  await page.keyboard.press('l');
  const track = await page.locator('.track').boundingBox();
  await page.keyboard.down('Shift');
  await page.mouse.move(track.x + 0.25 * track.width, track.y + 20);
  await page.mouse.down();
  await page.mouse.move(track.x + 0.5 * track.width, track.y + 20);
  await page.mouse.up();
  await page.keyboard.up('Shift');
  const drawn = await state(page);
  const { loopFrom: from, loopTo: to } = drawn;
  assert.ok(Math.abs(to - 2 * from) < 4, `${from} to ${to}`);
  await put(page, { loopFrom: 0, loopTo: 0 });
});

test('speed colours the lines, and the legend is its scale', async ({ page }) => {
  const colored = () =>
    page.evaluate(() => window.obby.stage.pathView.played.material.vertexColors);
  assert.equal(await colored(), false);
  await put(page, { colorBy: 'speed' });
  assert.equal(await colored(), true);
  assert.match(await page.locator('.legend').innerText(), /studs\/s/);
  await frames(page, 2);
  await put(page, { colorBy: 'margin' });
  assert.equal(await colored(), true);
  assert.match(await page.locator('.legend').innerText(), /2 studs or more/);
  await put(page, { colorBy: 'outcome' });
  assert.equal(await colored(), false);
});

test('the tree selects a part, and the inspector tells about it', async ({ page }) => {
  await page.locator('#scene-panel .fold', { hasText: 'Parts' }).click();
  assert.ok((await page.locator('.parts summary').count()) > 0);
  await page.getByLabel('Find a part').fill('hazard');
  const found = await page.locator('.parts .part').allInnerTexts();
  assert.deepEqual(found, [report.levels[0].names[lava]]);
  await page.locator('.parts .part').click();
  assert.equal((await state(page)).part, lava);
  const facts = await page.locator('.inspector').innerText();
  assert.match(facts, /Collides\s+(yes|no)/);
  assert.match(facts, /Tags\s+Hazard, KillBrick/);
  await put(page, { part: -1 });
  await page.locator('#scene-panel .fold', { hasText: 'Parts' }).click();
});

const saved = async (page, name) => {
  const [file] = await Promise.all([
    page.waitForEvent('download'),
    page.locator('.tools').getByText(name).click(),
  ]);
  return { name: file.suggestedFilename(), bytes: readFileSync(await file.path()) };
};

// Returns what a browser finds in a film.
async function played(browser, bytes) {
  const page = await browser.newPage();
  const found = await page.evaluate(async (base64) => {
    const video = document.createElement('video');
    video.src = `data:video/webm;base64,${base64}`;
    await new Promise((done, failed) => {
      video.onloadeddata = done;
      video.onerror = () => failed(new Error(video.error.message));
    });
    return { duration: video.duration, width: video.videoWidth };
  }, bytes.toString('base64'));
  await page.close();
  return found;
}

test('the picture and the film are saved', async ({ page, browser }) => {
  await page.locator('#scene-panel .fold', { hasText: 'Tools' }).click();
  const picture = await saved(page, 'Save picture');
  assert.match(picture.name, /\.png$/);
  assert.equal(picture.bytes.subarray(1, 4).toString(), 'PNG');
  const { width, height } = await page.evaluate(() => {
    const { width, height } = window.obby.stage.canvas;
    return { width, height };
  });
  assert.ok(Math.abs(picture.bytes.readUInt32BE(16) - width) < 2);
  assert.ok(Math.abs(picture.bytes.readUInt32BE(20) - height) < 2);
  await put(page, { loop: true, loopFrom: 100, loopTo: 130 });
  const film = await saved(page, 'Save film');
  assert.match(film.name, /\.webm$/);
  assert.equal(film.bytes.readUInt32BE(0), 0x1a45dfa3, 'the beginning of a WebM file');
  assert.ok(film.bytes.length > 4000);
  assert.ok(film.bytes.includes('V_VP9'), 'this browser encodes VP9');
  const seen = await played(browser, film.bytes);
  assert.ok(Math.abs(seen.duration - 31 / 30) < 0.08, `${seen.duration} s: 16 pictures and 15 held`);
  assert.ok(Math.abs(seen.width - width) < 2);
  assert.match(await page.locator('#status').innerText(), /^Saved a film/);
  assert.equal((await state(page)).playing, false);
  await put(page, { loopFrom: 0, loopTo: 0 });
});

test('a path is copied as JSON', async ({ page }) => {
  const text = await page.evaluate(async () => {
    let copied = '';
    Object.defineProperty(navigator, 'clipboard', {
      value: { writeText: async (value) => (copied = value) },
    });
    [...document.querySelectorAll('.tools button')].at(-1).click();
    await new Promise((done) => setTimeout(done, 50));
    return copied;
  });
  const { samples, tickRate, outcome } = JSON.parse(text);
  const points = report.queries[0].trajectories[0];
  assert.deepEqual([samples.length, tickRate, outcome], [points.ticks + 1, 60, 'goal']);
  assert.deepEqual(Object.keys(samples[0]), ['tick', 'position', 'yaw']);
});

test('the page raised no error', async ({ trouble }) => assert.deepEqual(trouble, []));

await run(file);
