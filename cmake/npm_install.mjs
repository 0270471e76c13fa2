// npm_install.mjs FOLDER: installs the folder's locked packages into its node_modules, or does
// nothing, without network access, if they are there already. Install scripts never run, since
// programs come as separate optional packages.
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';

const here = resolve(process.argv[2]);
const stamp = join(here, 'node_modules', '.obby-lock');
const wanted = createHash('sha256')
  .update(readFileSync(join(here, 'package-lock.json')))
  .update(`${process.platform} ${process.arch}`)
  .digest('hex');
const inPlace = () => existsSync(stamp) && readFileSync(stamp, 'utf8') === wanted;

// Two build folders may configure at once. The first one installs, and the other waits until it has
// finished or ended.
const guard = join(here, '.installing');

function alive(pid) {
  try {
    process.kill(pid, 0);
    return true;
  } catch (error) {
    return error.code === 'EPERM';
  }
}

function takeGuard() {
  for (;;) {
    try {
      writeFileSync(guard, String(process.pid), { flag: 'wx' });
      return;
    } catch (error) {
      if (error.code !== 'EEXIST') throw error;
    }
    Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0, 300);
    const owner = existsSync(guard) ? Number(readFileSync(guard, 'utf8')) : 0;
    if (owner > 0 && !alive(owner)) rmSync(guard, { force: true });
  }
}

if (!inPlace()) {
  takeGuard();
  try {
    if (!inPlace()) {
      const npm = process.env.OBBY_NPM || 'npm';
      execFileSync(
        npm,
        ['ci', '--ignore-scripts', '--include=dev', '--include=optional', '--prefer-offline'],
        { cwd: here, stdio: ['ignore', 'inherit', 'inherit'] },
      );
      writeFileSync(stamp, wanted);
    }
  } finally {
    rmSync(guard, { force: true });
  }
}
