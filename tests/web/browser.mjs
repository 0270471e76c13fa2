// Opens a page in a headless browser and keeps count of what must not happen: errors, warnings, requests.
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
const kPatience = 120000; // ms that a slow machine gets for what is waited for

// Whether the tests keep pictures for people to look at; nothing is asserted of these.
export const kPictures = Boolean(process.env.OBBY_PICTURES);

// Pixels of the 3D view for one of the page, each way. Without a GPU a picture takes as long as it has pixels, and only
// pictures that somebody looks at need all of them.
const kDensity = kPictures ? 1 : 0.5;

export async function launch(webFolder, executablePath) {
  const { chromium } = createRequire(resolve(webFolder, 'package.json'))('playwright-core');
  return chromium.launch({ executablePath, headless: true, args: kFlags, timeout: kPatience });
}

// A page of its own context. `density`: pixels of the 3D view for one of the page; the page itself stays as it is.
export async function newPage(browser, { viewport = kViewport, density = kDensity, ...more } = {}) {
  const context = await browser.newContext({ viewport, ...more });
  context.setDefaultTimeout(kPatience);
  const page = await context.newPage();
  await page.addInitScript((value) => {
    Object.defineProperty(window, 'devicePixelRatio', { get: () => value });
  }, density);
  return page;
}

// For `prepare`: the browser has no WebGL.
export const withoutWebGl = (page) =>
  page.addInitScript(() => {
    const { prototype } = HTMLCanvasElement;
    const original = prototype.getContext;
    prototype.getContext = function get(kind, ...more) {
      return kind.startsWith('webgl') ? null : original.call(this, kind, ...more);
    };
  });

// `fragment`: of the address. `prepare`: is given the page before it has loaded anything. `more`: as of newPage.
export async function openReport(
  browser,
  file,
  { fragment = '', prepare = async () => {}, ...more } = {},
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

// The camera is where it flies to, without the way there, and that is drawn.
export async function arrive(page) {
  await page.evaluate(() => window.obby.stage.rig.settle());
  await frames(page, 2);
}

export const state = (page) => page.evaluate(() => ({ ...window.obby.store.state }));

// How many different colours the 3D view shows, and the share of its most frequent one; `anew`: drawn for this look.
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

// Counts from now on the programs of the GPU that the page makes: `linked` of its window.
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

// A report in the page that the build made.
export function fillTemplate(template, data, title) {
  const json = JSON.stringify(data).replace(/</g, '\\u003c');
  return template.replace('@@OBBY_TITLE@@', () => title).replace('@@OBBY_DATA@@', () => json);
}
