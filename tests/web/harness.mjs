// Collects a file's tests and runs them in one page. Prints failures. If any test fails, the exit
// code is 1. With OBBY_PICTURES=1 the tests save pictures in their output folder.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { fillTemplate, kPictures, launch, openReport } from './browser.mjs';

// Reads the command line: --web FOLDER, --page TEMPLATE, --out FOLDER, and --viewer, --solver,
// --calibrator and --chromium, each with a PROGRAM.
function readOptions() {
  const words = process.argv.slice(2);
  const options = {};
  for (let i = 0; i + 1 < words.length; i += 2) options[words[i].replace(/^--/, '')] = words[i + 1];
  mkdirSync(options.out, { recursive: true });
  return options;
}

export function harness() {
  const options = readOptions();
  const tests = [];
  const test = (name, body) => tests.push({ name, body });

  // Writes the page of the build with a report in it. Returns the file.
  options.sample = (report) => {
    const file = join(options.out, `${basename(process.argv[1], '.mjs')}.html`);
    writeFileSync(file, fillTemplate(readFileSync(options.page, 'utf8'), report, report.title));
    return file;
  };

  // Saves a picture for people to look at, if requested. Each picture takes about as long as a
  // small test.
  options.picture = async (page, name, more = {}) => {
    if (kPictures) await page.screenshot({ path: join(options.out, `${name}.png`), ...more });
  };

  const run = async (file) => {
    const browser = await launch(options.web, options.chromium);
    let failed = 0;
    try {
      const opened = file ? await openReport(browser, file) : {};
      for (const { name, body } of tests) {
        try {
          await body({ ...opened, browser });
          console.log(`ok   ${name}`);
        } catch (error) {
          failed += 1;
          console.log(`FAIL ${name}\n${error.stack}`);
        }
      }
    } finally {
      await browser.close();
    }
    process.exit(failed ? 1 : 0);
  };
  return { options, test, run };
}
