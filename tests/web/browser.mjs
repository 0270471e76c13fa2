// Opens a page in a headless browser and collects its errors, warnings and requests.
import { createRequire } from 'node:module';
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const kFlags = [
  '--no-sandbox',
  '--use-gl=angle',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--no-first-run',
];

const kViewport = { width: 1280, height: 800 };
const kPatience = 120000; // max ms of each wait, enough for a slow machine

// True if the tests save pictures for people to look at. The tests assert nothing about these
// pictures.
export const kPictures = Boolean(process.env.OBBY_PICTURES);

// Pixels of the 3D view per page pixel, on each axis. Without a GPU the time to draw grows with the
// pixels, so only saved pictures are drawn in full.
const kDensity = kPictures ? 1 : 0.5;

export async function launch(webFolder, executablePath) {
  const { chromium } = createRequire(resolve(webFolder, 'package.json'))('playwright-core');
  return chromium.launch({ executablePath, headless: true, args: kFlags, timeout: kPatience });
}

// Returns a page with its own context. `density`: pixels of the 3D view per page pixel; it does not
// affect the rest of the page.
export async function newPage(browser, { viewport = kViewport, density = kDensity, ...more } = {}) {
  const context = await browser.newContext({ viewport, ...more });
  context.setDefaultTimeout(kPatience);
  const page = await context.newPage();
  await page.addInitScript((value) => {
    Object.defineProperty(window, 'devicePixelRatio', { get: () => value });
  }, density);
  return page;
}

// A value for `prepare` that removes WebGL from the browser.
export const withoutWebGl = (page) =>
  page.addInitScript(() => {
    const { prototype } = HTMLCanvasElement;
    const original = prototype.getContext;
    prototype.getContext = function get(kind, ...more) {
      return kind.startsWith('webgl') ? null : original.call(this, kind, ...more);
    };
  });

// `attempts`: whether to show failed attempts, which a reader sees on request. `fragment`: the
// fragment of the address. `prepare`: called with the page before it loads
// anything. `more`: options of newPage.
export async function openReport(
  browser,
  file,
  { attempts = true, fragment = '', prepare = async () => {}, ...more } = {},
) {
  const page = await newPage(browser, { offline: true, ...more });
  const trouble = [];
  const requests = [];
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type()))
      trouble.push(`${message.type()}: ${message.text()}`);
  });
  page.on('pageerror', (error) => trouble.push(`exception: ${error.stack}`));
  page.on('request', (request) => requests.push(request.url()));
  await prepare(page);
  await page.goto(pathToFileURL(file).href + fragment);
  await started(page);
  if (attempts) {
    await page.evaluate(() => window.obby.store.set({ attempts: true }));
    await frames(page, 2);
  }
  return { page, trouble, requests };
}

// Waits until the page has begun to draw.
export async function started(page) {
  await page.waitForFunction(() => window.obby?.stage?.width > 0);
  await frames(page, 3);
}

// Waits until the page has drawn a few times.
export async function frames(page, count = 2) {
  await page.evaluate(
    (n) =>
      new Promise((done) => {
        const next = (left) => (left ? requestAnimationFrame(() => next(left - 1)) : done());
        next(n);
      }),
    count,
  );
}

// Moves the camera to its destination at once, and waits until the new view is drawn.
export async function arrive(page) {
  await page.evaluate(() => window.obby.stage.rig.settle());
  await frames(page, 2);
}

export const state = (page) => page.evaluate(() => ({ ...window.obby.store.state }));

// Returns the number of different colours in the 3D view, and the share of the most frequent one.
// `anew`: whether to redraw the view first.
export async function colours(page, anew = true) {
  return page.evaluate((draw) => {
    if (draw) window.obby.stage.render();
    const view = document.getElementById('view');
    const copy = document.createElement('canvas');
    [copy.width, copy.height] = [320, 200];
    const pen = copy.getContext('2d');
    pen.drawImage(view, 0, 0, copy.width, copy.height);
    const { data } = pen.getImageData(0, 0, copy.width, copy.height);
    const counts = new Map();
    for (let i = 0; i < data.length; i += 4) {
      const key = `${data[i] >> 4},${data[i + 1] >> 4},${data[i + 2] >> 4},${data[i + 3] >> 6}`;
      counts.set(key, (counts.get(key) ?? 0) + 1);
    }
    return { different: counts.size, share: Math.max(...counts.values()) / (data.length / 4) };
  }, anew);
}

// Counts the GPU programs that the page links from now on, in `window.linked`.
export const countPrograms = (page) =>
  page.evaluate(() => {
    window.linked = 0;
    const { prototype } = WebGL2RenderingContext;
    const original = prototype.linkProgram;
    prototype.linkProgram = function counted(...args) {
      window.linked += 1;
      return original.apply(this, args);
    };
  });

// Returns the page of the build with a report in it.
export function fillTemplate(template, data, title) {
  const json = JSON.stringify(data).replace(/</g, '\\u003c');
  return template.replace('@@OBBY_TITLE@@', () => title).replace('@@OBBY_DATA@@', () => json);
}
