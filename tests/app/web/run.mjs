// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a test of the page: node run.mjs FILE. Ends with 77 where the page was not built.
import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { builtPage } from './support.mjs';

if (!existsSync(join(builtPage, 'index.html'))) {
    console.log(`Skipped: there is no ${builtPage}. bash tests/run builds it.`);
    process.exit(77);
}
const test = join(dirname(fileURLToPath(import.meta.url)), process.argv[2]);
process.exit(spawnSync(process.execPath, ['--test', test], { stdio: 'inherit' }).status ?? 1);
