// Tests the camera's views: the first picture hides nothing of the query, R shows the whole course
// in the free part of the picture, and the followed player is never behind a wall.
import assert from 'node:assert/strict';
import { Solids, entry } from '../../web/src/scene/solids.js';
import { bestDirection, visibleShare } from '../../web/src/scene/view_choice.js';
import { axesOf, fitted } from '../../web/src/scene/framing.js';
import { headingAt } from '../../web/src/scene/follow_camera.js';
import { cornersOf, subjectOf } from '../../web/src/scene/subject.js';
import { arrive, frames, openReport, state } from './browser.mjs';
import { harness } from './harness.mjs';
import { report } from './sample_report.mjs';

const { options, test, run } = harness();
const { Vector3 } = await import('../../web/node_modules/three/build/three.module.js');

const kSlopes = { wide: 0.6, tall: 0.4 };

// Returns a level of blocks, each [centre, size].
function blocks(...parts) {
  const column = (Type, values) => Type.from(values.flat());
  return {
    count: parts.length,
    position: column(Float32Array, parts.map(([at]) => at)),
    size: column(Float32Array, parts.map(([, size]) => size)),
    rotation: column(Float32Array, parts.map(() => [0, 0, 0, 1])),
    look: column(Uint8Array, parts.map(([, , alpha = 255]) => [0, 0, 0, alpha])),
    shape: column(Uint8Array, parts.map(() => 0)),
    hulls: [],
  };
}

test('a line enters each shape where its surface is', () => {
  const down = (shape, x, z) => 1 - 2 * entry(shape, [x, 1, z], [0, -2, 0]);
  assert.equal(down('block', 0.5, -0.5), 1);
  assert.ok(Math.abs(down('wedge', 0.5, -0.5) + 0.5) < 1e-9, 'the slope rises to +z');
  assert.ok(Math.abs(down('cornerWedge', 0, 0)) < 1e-9, 'the corner is at +x, -z');
  assert.ok(Math.abs(down('ball', 0.6, 0) - 0.8) < 1e-9);
  assert.ok(Math.abs(down('cylinder', 0.9, 0.6) - 0.8) < 1e-9, 'its axis is x');
  assert.equal(entry('ball', [0.9, 1, 0.9], [0, -2, 0]), Infinity);
  assert.equal(entry('block', [0, 3, 0], [0, -1, 0]), Infinity, 'the line ends before it');
});

test('all fitted points are in the picture, and one touches its border', () => {
  const points = [0, 0, 0, 30, 2, 0, 30, 2, 60, -5, 20, 8];
  for (const direction of [{ yaw: 0.4, pitch: -0.5 }, { yaw: 2.6, pitch: -1 }]) {
    const { eye } = fitted(points, direction, kSlopes);
    const { forward, right, up } = axesOf(direction);
    let most = 0;
    for (let i = 0; i < points.length; i += 3) {
      const at = new Vector3(...points.slice(i, i + 3)).sub(eye);
      const depth = at.dot(forward);
      most = Math.max(
        most,
        Math.abs(at.dot(right)) / (depth * kSlopes.wide),
        Math.abs(at.dot(up)) / (depth * kSlopes.tall),
      );
    }
    assert.ok(Math.abs(most - 1) < 1e-6, `${most}`);
  }
});

test('the first view is not behind a wall', () => {
  const seen = [0, 10, 20, 30, 40].map((x) => new Vector3(x, 2, 0));
  const frame = seen.flatMap((point) => point.toArray());
  const subject = { frame, seen, from: seen[0], to: seen[4] };
  const floor = [[20, -1, 0], [60, 2, 20]];
  for (const z of [-14, 14]) {
    const solids = new Solids(blocks(floor, [[20, 20, z], [90, 40, 2]]));
    const direction = bestDirection(subject, solids, kSlopes);
    const { eye } = fitted(frame, direction, kSlopes);
    assert.equal(visibleShare(seen, eye, solids), 1);
    assert.ok((z - eye.z) * z > 0, `the wall is at ${z}, the eye at ${eye.z}`);
  }
  const glass = new Solids(blocks([[20, 20, 14], [90, 40, 2], 60]));
  assert.equal(visibleShare(seen, new Vector3(20, 10, 60), glass), 1, 'glass hides nothing');
});

test('the floor around the start is framed, and a huge ground is not', () => {
  const level = blocks(
    [[0, -8, 0], [2048, 16, 2048]],
    [[40, 2, 0], [4, 4, 4]],
    [[0, 0, 0], [12, 1, 12]],
  );
  const farthest = (corners) => Math.max(...corners.filter((_, i) => i % 3 === 0));
  assert.equal(farthest(cornersOf(level)), 42);
  assert.equal(farthest(cornersOf(blocks([[0, -8, 0], [200, 16, 200]], [[0, 0, 0], [4, 4, 4]]))), 100);
  const query = { startPosition: [0, 0.5, 0], goals: [], visits: [], waypoints: [], paths: [] };
  const { frame } = subjectOf(query, level);
  assert.equal(farthest(frame), 6, 'of the pad, not of the ground below it');
  const onGround = subjectOf({ ...query, startPosition: [20, 0, 0] }, level).frame;
  assert.equal(farthest(onGround), 32, 'no farther than near');
});

test('the heading of a followed player ignores hops on the spot', () => {
  const poseAt = (tick) => ({ x: Math.max(0, tick - 60) / 4, z: 0.4 * Math.sin(tick), yaw: 1 });
  assert.ok(Math.abs(headingAt({ poseAt }, 200, 60) + Math.PI / 2) < 0.1, 'towards +x');
  assert.equal(headingAt({ poseAt: () => ({ x: 0, z: 0, yaw: 1 }) }, 30, 60), 1, 'it stands still');
});

// Returns how far the points of a view reach beyond the free area, in pixels.
const beyond = (page, what) =>
  page.evaluate((kind) => {
    const { stage, views } = window.obby;
    const { camera, free, size } = stage.rig;
    camera.updateMatrixWorld();
    const points = [];
    if (kind === 'query') points.push(...views.subject().frame);
    else {
      const { position, size: extent, count } = stage.level;
      for (let i = 0; i < count; i++)
        for (const side of [-0.5, 0.5])
          for (let k = 0; k < 3; k++) {
            const at = [...position.subarray(3 * i, 3 * i + 3)];
            at[k] += side * extent[3 * i + k];
            points.push(...at);
          }
    }
    let most = -Infinity;
    for (let i = 0; i < points.length; i += 3) {
      const p = camera.position.clone().fromArray(points, i).project(camera);
      const [x, y] = [(p.x + 1) / 2, (1 - p.y) / 2];
      most = Math.max(most, (free.left - x) * size.x, (x - free.right) * size.x);
      most = Math.max(most, (free.top - y) * size.y, (y - free.bottom) * size.y);
    }
    return most;
  }, what);

test('the first picture shows start, trajectory and goal next to the panels', async ({ page }) => {
  assert.ok((await beyond(page, 'query')) < 0);
  const free = await page.evaluate(() => window.obby.stage.rig.free);
  assert.ok(free.right < 0.9 && free.bottom < 0.95, 'the legend and the keys are left out');
});

test('R shows the whole course, also while following', async ({ page }) => {
  await page.locator('#view').focus();
  for (const key of ['r', 'g']) {
    if (key === 'g') {
      await page.keyboard.press('g');
      await arrive(page);
      assert.ok((await beyond(page, 'course')) > 0, 'the camera is close to the player');
    }
    await page.keyboard.press('r');
    await arrive(page);
    assert.ok((await beyond(page, 'course')) < 0);
    assert.equal((await state(page)).follow, false);
  }
});

const eyeAndHead = (page) =>
  page.evaluate(() => {
    const { rig, avatar } = window.obby.stage;
    const away = rig.camera.position.distanceTo(rig.now.target);
    return { away, inside: rig.inside, drawn: avatar.group.visible };
  });

test('G follows close behind, and the wheel goes to the eyes and back', async ({ page }) => {
  await page.evaluate(() => window.obby.store.set({ tick: 200, playing: false }));
  await page.keyboard.press('g');
  await frames(page, 3);
  await arrive(page);
  const behind = await eyeAndHead(page);
  assert.ok(behind.away > 3 && behind.away <= 18.1 && behind.drawn, JSON.stringify(behind));
  const ahead = await page.evaluate(() => {
    const { obby } = window;
    const yaw = obby.stage.rig.goal.yaw - obby.stage.rig.heading;
    return Math.cos(yaw);
  });
  assert.ok(ahead > 0.99, 'it looks the way that the player goes');
  const seen = () => eyeAndHead(page).then(({ inside, drawn }) => [inside, drawn]);
  await page.locator('#view').hover();
  for (let i = 0; i < 6; i++) await page.mouse.wheel(0, -700);
  await frames(page, 2);
  await arrive(page);
  await page.evaluate(() => (window.obby.dirty = true));
  await frames(page, 2);
  assert.deepEqual(await seen(), [true, false]);
  await page.mouse.wheel(0, 700);
  await frames(page, 2);
  await arrive(page);
  await page.evaluate(() => (window.obby.dirty = true));
  await frames(page, 2);
  assert.deepEqual(await seen(), [false, true]);
  await page.keyboard.press('g');
  assert.equal(await page.evaluate(() => window.obby.stage.rig.following), false);
});

test('a wall behind the player does not hide it', async ({ page }) => {
  const distances = await page.evaluate(() => {
    const { rig, solids } = window.obby.stage;
    rig.follow(rig.goal.target.clone(), 0);
    rig.goal.distance = 18;
    rig.settle();
    const free = rig.clearDistance(1);
    const sight = rig.sight;
    rig.sight = () => 0.5;
    const near = rig.clearDistance(0.1);
    rig.sight = () => 1;
    const back = rig.clearDistance(0.1);
    rig.sight = sight;
    rig.unfollow();
    return { free, near, back, solids: solids.all.length };
  });
  assert.ok(distances.near < 9 && distances.near > 8, 'it comes closer at once');
  assert.ok(distances.back > distances.near && distances.back < 10, 'and goes back smoothly');
});

for (const [width, height] of [[390, 844], [768, 1024], [3840, 2160]])
  test(`${width} × ${height} pixels show the query and no overflow`, async ({ browser }) => {
    const viewport = { width, height };
    const { page } = await openReport(browser, options.sample(report), { viewport, density: 0.25 });
    assert.ok((await beyond(page, 'query')) < 0);
    const sizes = await page.evaluate(() => ({
      wide: document.documentElement.scrollWidth,
      text: document.querySelector('.detail .reason').getBoundingClientRect().height,
    }));
    assert.ok(sizes.wide <= width, `${sizes.wide} pixels wide`);
    assert.ok(width < 3000 || sizes.text > 24, 'panels grow with a large window');
    await page.context().close();
  });

test('the page raised no error', async ({ trouble }) => assert.deepEqual(trouble, []));

await run(options.sample(report));
