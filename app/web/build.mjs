// SPDX-License-Identifier: GPL-3.0-or-later
// Puts the page together: node build.mjs DECODER.wasm FOLDER. The folder is what `sandreel-cli export-player` copies.
import * as esbuild from 'esbuild';
import { copyFileSync, existsSync, mkdirSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

const MostBytes = 600 * 1024; // with gzip, all files together

const here = dirname(fileURLToPath(import.meta.url));
const [decoder, target] = process.argv.slice(2).map((path) => resolve(path));
if (!target) {
    console.error('usage: node build.mjs DECODER.wasm FOLDER');
    process.exit(2);
}
const folder = `${target}.new`;
rmSync(folder, { recursive: true, force: true });
mkdirSync(folder, { recursive: true });
await esbuild.build({
    entryPoints: { player: join(here, 'player/main.ts'), worker: join(here, 'player/worker.ts') },
    outdir: folder,
    bundle: true,
    minify: true,
    format: 'esm',
    target: 'es2022',
    legalComments: 'none',
    loader: { '.glsl': 'text', '.svg': 'text' },
    logLevel: 'warning',
});
// three.js asks for its licence to be kept with copies.
const licence = readFileSync(join(here, 'node_modules/three/LICENSE'), 'utf8');
writeFileSync(join(folder, 'licences.txt'), `Sandreel player: GPL-3.0-or-later\n\nthree.js:\n${licence}`);
for (const file of ['index.html', 'style.css'])
    copyFileSync(join(here, 'player', file), join(folder, file));
copyFileSync(join(here, '../../resources/icons/sandreel.svg'), join(folder, 'icon.svg'));
copyFileSync(decoder, join(folder, 'decoder.wasm'));

const files = ['index.html', 'style.css', 'icon.svg', 'player.js', 'worker.js', 'decoder.wasm', 'licences.txt'];
const sizes = files.map((file) => [file, gzipSync(readFileSync(join(folder, file)), { level: 9 }).length]);
const total = sizes.reduce((sum, [, bytes]) => sum + bytes, 0);
for (const [file, bytes] of [...sizes, ['all', total]])
    console.log(`${file.padEnd(14)} ${(bytes / 1024).toFixed(1).padStart(7)} KiB with gzip`);
if (total > MostBytes) {
    console.error(`The page has more than ${MostBytes / 1024} KiB.`);
    process.exit(1);
}
rmSync(target, { recursive: true, force: true });
if (existsSync(folder))
    renameSync(folder, target);
