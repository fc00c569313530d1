// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of the page share: the built page served from a folder, and a browser.
import { mkdtempSync, readFileSync, cpSync, existsSync, mkdirSync, writeFileSync, rmSync, copyFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { basename, dirname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = join(dirname(fileURLToPath(import.meta.url)), '../../..');
export const builtPage = process.env.SANDREEL_PLAYER ?? join(root, 'build/web/player');
export const data = join(root, 'tests/data');
const fromPage = createRequire(join(root, 'app/web/package.json'));
const Browser = process.env.SANDREEL_CHROMIUM ?? '/usr/bin/chromium';

const types = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.svg': 'image/svg+xml', '.json': 'application/json',
                '.png': 'image/png', '.wasm': 'application/wasm' };

/// The decoder as the page's worker has it.
export async function decoderModule() {
    const { build } = await import(fromPage.resolve('esbuild'));
    const { outputFiles } = await build({ entryPoints: [join(root, 'app/web/player/decoder.ts')], bundle: true, write: false, format: 'esm' });
    const { Decoder } = await import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].text).toString('base64')}`);
    return { Decoder, module: await WebAssembly.compile(readFileSync(join(builtPage, 'decoder.wasm'))) };
}

/// The frames that the text of a pinned file has, where it has not all: tests/data/anim/README.md.
export const pinnedFrames = { 'reel-learned-1.0': [0, 11, 23], 'reel-parts-1.0': [0, 7, 23] };

/// tests/data/anim/NAME.txt: the positions that its file has, of these frames one after another.
export function pinnedPositions(name) {
    return Float64Array.from(readFileSync(join(data, 'anim', `${name}.txt`), 'utf8').split(/[\s,]+/).filter(Boolean), Number);
}

/// A folder with the page and a list of these files.
export function makeSite(files) {
    const folder = mkdtempSync(join(tmpdir(), 'sandreel-site-'));
    cpSync(builtPage, folder, { recursive: true });
    mkdirSync(join(folder, 'files'));
    const animations = files.map((file) => {
        copyFileSync(file, join(folder, 'files', basename(file)));
        return { name: basename(file, '.anim'), file: `files/${basename(file)}` };
    });
    writeFileSync(join(folder, 'list.json'), JSON.stringify({ version: 1, animations }));
    return folder;
}

/// Serves a folder as any static web server does. `pieces`: bytes at a time of an .anim, and the pause between.
export async function serve(folder, pieces = null) {
    const server = createServer(async (request, response) => {
        const path = join(folder, normalize(decodeURIComponent(new URL(request.url, 'http://x').pathname)).replace(/\/$/, '/index.html'));
        if (!path.startsWith(folder) || !existsSync(path)) return response.writeHead(404).end();
        const bytes = readFileSync(path);
        const ending = path.slice(path.lastIndexOf('.'));
        response.writeHead(200, { 'content-type': types[ending] ?? 'application/octet-stream', 'content-length': bytes.length });
        if (!pieces || ending !== '.anim') return response.end(bytes);
        for (let at = 0; at < bytes.length; at += pieces.bytes) {
            response.write(bytes.subarray(at, at + pieces.bytes));
            await new Promise((done) => setTimeout(done, pieces.milliseconds));
        }
        response.end();
    });
    await new Promise((done) => server.listen(0, '127.0.0.1', done));
    return { address: `http://127.0.0.1:${server.address().port}/`, close: () => server.close() };
}

export async function startBrowser() {
    const { chromium } = await import(fromPage.resolve('playwright-core'));
    return (chromium ?? (await import(fromPage.resolve('playwright-core'))).default.chromium).launch({
        executablePath: Browser,
        args: ['--no-sandbox', '--disable-dev-shm-usage', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'],
    });
}

export function removeFolder(folder) {
    rmSync(folder, { recursive: true, force: true });
}

/// Waits until the page has loaded all of its file, or says what is wrong with it.
export async function settled(page) {
    await page.waitForFunction(() => ['complete', 'error'].includes(document.body.dataset.state), null, { timeout: 60000 });
    return page.evaluate(() => document.body.dataset.state);
}
