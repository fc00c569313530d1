// SPDX-License-Identifier: GPL-3.0-or-later
// What the page costs, in Chromium: node tests/bench/web.mjs FILE.anim...
//   decode   time in the worker, over all pieces of the file
//   first    from the choice in the list to the first picture; the smallest of several, shaders compiled before
//   frame    on the page's main thread: a frame's evaluation and drawing handed to the GPU; median and smallest
// Without a GPU Chromium draws on the processor, which competes with what is measured.
import { makeSite, removeFolder, serve, settled, startBrowser } from '../app/web/support.mjs';

const Times = 7;

const files = process.argv.slice(2);
if (files.length === 0) {
    console.error('usage: node tests/bench/web.mjs FILE.anim...');
    process.exit(2);
}
const site = makeSite(files);
const server = await serve(site);
const browser = await startBrowser();
const page = await (await browser.newContext({ viewport: { width: 640, height: 480 } })).newPage();
const began = performance.now();
await page.goto(server.address);
await settled(page);
await page.waitForFunction(() => globalThis.sandreelPlayer.times.firstPicture > 0);
console.log(`page and first picture, nothing cached: ${(performance.now() - began).toFixed(0)} ms`);
for (const [index, file] of files.entries()) {
    const runs = [];
    for (let i = 0; i < Times; ++i) {
        await page.evaluate((index) => {
            document.body.dataset.state = 'asked';
            globalThis.sandreelPlayer.choose(index);
        }, index);
        await settled(page);
        await page.waitForFunction(() => globalThis.sandreelPlayer.times.firstPicture > 0);
        runs.push(await page.evaluate(() => {
            const { times } = globalThis.sandreelPlayer;
            return { decode: times.decode, first: times.firstPicture - times.opened };
        }));
    }
    const frames = await page.evaluate(async () => {
        const player = globalThis.sandreelPlayer;
        player.times.frames.length = 0;
        player.playback.setRate(60);
        if (!player.playback.isPlaying) player.playback.play();
        while (player.times.frames.length < 100) await new Promise(requestAnimationFrame);
        return player.times.frames.slice(10).sort((a, b) => a - b);
    });
    const least = (key) => Math.min(...runs.map((run) => run[key])).toFixed(0);
    console.log(`${file.split('/').pop()}: ${await page.textContent('#info')}; decode ${least('decode')} ms, first ${least('first')} ms, ` +
                `frame ${frames[Math.floor(frames.length / 2)].toFixed(2)} ms (smallest ${frames[0].toFixed(2)})`);
}
await browser.close();
server.close();
removeFolder(site);
