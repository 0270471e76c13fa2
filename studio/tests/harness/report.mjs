// Runs the tests of one file and prints their results. `play(index)` runs a test and returns its
// failure, if any. Returns true if all passed.
export async function report(luau, name, path, play) {
  let failed = 0;
  let titles = [];
  try {
    titles = (await luau.call('open', path)).split('\n').filter(Boolean);
    for (const [index, title] of titles.entries()) {
      const problem = await play(index + 1);
      if (problem) failed += 1;
      console.log(`${problem ? 'FAILED' : 'ok    '} ${name}: ${title}`);
      if (problem) console.log(`    ${problem.replaceAll('\n', '\n    ')}`);
    }
  } catch (error) {
    // Printing the whole error would include a megabyte of the VM.
    console.log(`FAILED ${name}: ${error.message}`);
    return false;
  }
  console.log(`${titles.length - failed} of ${titles.length} tests passed`);
  return failed === 0 && titles.length > 0;
}
