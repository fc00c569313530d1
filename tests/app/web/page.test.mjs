// SPDX-License-Identifier: GPL-3.0-or-later
// The page in a browser: what a person does, and what the GPU computed.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { data, makeSite, pinnedFrames, pinnedPositions, removeFolder, root, serve, settled, startBrowser } from './support.mjs';

const MostError = 1e-5; // of the diagonal
const pinned = ['wave-1.0', 'wave-coddyac-1.0', 'wave-coddyac-ordered-1.0', 'reel-learned-1.0', 'reel-parts-1.0', 'direct-1.0', 'direct-deflate-1.0'];
const anim = (name) => join(data, 'anim', `${name}.anim`);

let browser, site, server;
before(async () => {
    site = makeSite([...pinned.map(anim), join(root, 'resources/samples/walker.anim')]);
    server = await serve(site);
    browser = await startBrowser();
});
after(async () => {
    await browser?.close();
    server?.close();
    if (site) removeFolder(site);
});

/// Runs a test on a fresh page; anything that it throws or logs as an error fails the test.
function onPage(name, { options = {}, address = '', expectErrors = false }, body) {
    test(name, { timeout: 120000 }, async () => {
        const context = await browser.newContext({ locale: 'en-US', reducedMotion: 'reduce', viewport: { width: 900, height: 600 }, ...options });
        const page = await context.newPage();
        const problems = [];
        page.on('pageerror', (error) => problems.push(error.stack));
        page.on('console', (message) => message.type() === 'error' && problems.push(message.text()));
        try {
            await page.goto(server.address + address);
            await settled(page);
            await body(page);
            if (!expectErrors) assert.deepEqual(problems, []);
        } finally {
            await context.close();
        }
    });
}

/// Positions of the frames as the GPU has them, absolute.
async function gpuPositions(page, frames) {
    return page.evaluate(async (frames) => {
        const player = globalThis.sandreelPlayer;
        const result = [];
        for (const frame of frames) {
            player.playback.pause();
            player.playback.seek(frame);
            while (player.shownFrame !== frame) await new Promise(requestAnimationFrame);
            const texels = player.stage.frames.read();
            const { centre } = player.stage.bounds;
            for (let i = 0; i < texels.length; ++i) if (i % 4 < 3) result.push(texels[i] + centre[i % 4]);
        }
        return result;
    }, frames);
}

const count = (page) => page.textContent('#count');
const playing = (page) => page.evaluate(() => globalThis.sandreelPlayer.playback.isPlaying);

/// Drops a file as a person does.
async function drop(page, name, bytes) {
    const transfer = await page.evaluateHandle(([name, values]) => {
        const transfer = new DataTransfer();
        transfer.items.add(new File([new Uint8Array(values)], name));
        return transfer;
    }, [name, [...bytes]]);
    await page.evaluate(() => (document.body.dataset.state = 'dropped'));
    await page.dispatchEvent('#view', 'drop', { dataTransfer: transfer });
    await settled(page);
}

describe('frames', () => {
    pinned.forEach((name, index) => {
        onPage(`${name} is evaluated as by the decoder in C++`, { address: `#${index + 1}` }, async (page) => {
            const expected = pinnedPositions(name);
            const frames = pinnedFrames[name] ?? [0, 1, 2, 3, 4];
            const actual = await gpuPositions(page, frames);
            assert.equal(actual.length, expected.length);
            const range = [0, 1, 2].map((axis) => {
                const values = expected.filter((_, i) => i % 3 === axis);
                return Math.max(...values) - Math.min(...values);
            });
            const worst = Math.max(...actual.map((value, i) => Math.abs(value - expected[i])));
            assert.ok(worst <= MostError * Math.hypot(...range), `${worst / Math.hypot(...range)} of the diagonal`);
        });
    });

    onPage('something is drawn, another frame looks different, and styles do', { address: `#${pinned.length + 1}` }, async (page) => {
        const shot = async () => {
            await page.waitForTimeout(300);
            return (await page.locator('#canvas').screenshot()).toString('base64');
        };
        const pictures = [await shot()];
        await page.keyboard.press('End');
        await page.keyboard.press('ArrowLeft');
        for (let i = 0; i < 40; ++i) await page.keyboard.press('ArrowLeft');
        pictures.push(await shot());
        for (const key of ['2', '3', 'Shift+ArrowRight', '+']) {
            await page.keyboard.press(key);
            if (key === '2') await page.waitForFunction(() => !globalThis.sandreelPlayer.stage.needsEdges);
            pictures.push(await shot());
        }
        assert.equal(new Set(pictures).size, pictures.length);
    });

    test('the picture comes before the file is whole, and gets better', { timeout: 120000 }, async () => {
        const bytes = readFileSync(anim('reel-learned-1.0'));
        const slow = await serve(makeSite([anim('reel-learned-1.0')]), { bytes: Math.ceil(bytes.length / 16), milliseconds: 250 });
        const page = await browser.newPage();
        await page.goto(slow.address);
        const seen = await page.evaluate(async () => {
            const ranks = [];
            while (document.body.dataset.state !== 'complete') {
                const frames = globalThis.sandreelPlayer?.stage.frames;
                if (frames?.coefficients) ranks.push(frames.coefficients.image.depth);
                await new Promise(requestAnimationFrame);
            }
            return [...new Set(ranks)];
        });
        assert.ok(seen.length > 1, `layers seen: ${seen}`);
        await page.close();
        slow.close();
    });
});

describe('controls', () => {
    onPage('keys', {}, async (page) => {
        assert.equal(await count(page), '1 / 5');
        await page.keyboard.press('ArrowRight');
        assert.equal(await count(page), '2 / 5');
        await page.keyboard.press('End');
        assert.equal(await count(page), '5 / 5');
        await page.keyboard.press('ArrowLeft');
        await page.keyboard.press('ArrowLeft');
        assert.equal(await count(page), '3 / 5');
        await page.keyboard.press('Home');
        assert.equal(await count(page), '1 / 5');
        await page.keyboard.press('Space');
        assert.equal(await playing(page), true);
        await page.keyboard.press('Space');
        assert.equal(await playing(page), false);
        await page.keyboard.press('PageDown');
        await page.waitForFunction(() => location.hash === '#2');
        assert.equal(await page.getAttribute('#list li:nth-child(2) button', 'aria-current'), 'true');
    });

    onPage('buttons and sliders', {}, async (page) => {
        await page.click('#forward');
        assert.equal(await count(page), '2 / 5');
        await page.click('#play');
        assert.equal(await page.getAttribute('#play', 'aria-label'), 'Pause');
        await page.click('#play');
        await page.fill('#frame', '3');
        assert.equal(await count(page), '4 / 5');
        assert.equal(await page.getAttribute('#frame', 'aria-valuetext'), 'Frame 4 of 5');
        await page.fill('#rate', '60');
        await page.keyboard.press('Enter');
        assert.equal(await page.evaluate(() => globalThis.sandreelPlayer.playback.rate), 60);
        await page.click('#loop');
        assert.equal(await page.getAttribute('#loop', 'aria-pressed'), 'false');
        await page.click('#play'); // to the end, and stays there
        await page.waitForFunction(() => !globalThis.sandreelPlayer.playback.isPlaying);
        assert.equal(await count(page), '5 / 5');
        await page.click('#points');
        await page.fill('#density', '0.5');
        assert.equal(await page.evaluate(() => globalThis.sandreelPlayer.stage.cloud.geometry.drawRange.count), 15);
    });

    onPage('another animation from the list', {}, async (page) => {
        await page.click('#list li:nth-child(4) button');
        await page.waitForFunction(() => document.getElementById('count').textContent === '1 / 24');
        assert.match(await page.textContent('#info'), /^120 vertices/);
    });

    onPage('it plays by itself where nothing speaks against motion', { options: { reducedMotion: 'no-preference' } }, async (page) => {
        await page.waitForFunction(() => globalThis.sandreelPlayer.playback.frame > 0);
        assert.equal(await playing(page), true);
    });

    onPage('Czech, by the language of the browser and by choice', { options: { locale: 'cs-CZ' } }, async (page) => {
        assert.equal(await page.getAttribute('html', 'lang'), 'cs');
        assert.equal(await page.getAttribute('#play', 'aria-label'), 'Přehrát');
        assert.match(await page.textContent('#info'), /vrcholů/);
        await page.click('#language');
        assert.equal(await page.getAttribute('#play', 'aria-label'), 'Play');
        await page.reload();
        await settled(page);
        assert.equal(await page.getAttribute('html', 'lang'), 'en');
    });

    onPage('everything that can be used has a name', {}, async (page) => {
        const nameless = await page.$$eval('button, input, canvas, [role]', (parts) => parts
            .filter((part) => !part.hidden && part.type !== 'file' && part.id !== 'message')
            .filter((part) => !(part.getAttribute('aria-label') || part.textContent.trim() || part.labels?.length))
            .map((part) => part.outerHTML));
        assert.deepEqual(nameless, []);
    });

    onPage('nothing is cut off on a phone', { options: { viewport: { width: 360, height: 640 }, hasTouch: true, isMobile: true } }, async (page) => {
        const outside = await page.$$eval('#bar *, #tools *', (parts) => parts
            .filter((part) => part.checkVisibility())
            .filter((part) => {
                const box = part.getBoundingClientRect();
                return box.left < -1 || box.right > innerWidth + 1 || box.bottom > innerHeight + 1;
            })
            .map((part) => part.id || part.outerHTML));
        assert.deepEqual(outside, []);
        await page.tap('#play');
        assert.equal(await playing(page), true);
    });
});

describe('files that are dropped', () => {
    onPage('a good one is shown', {}, async (page) => {
        await drop(page, 'mine.anim', readFileSync(anim('reel-parts-1.0')));
        assert.equal(await page.textContent('#count'), '1 / 24');
        assert.equal(await page.isHidden('#message'), true);
    });

    const good = readFileSync(anim('reel-1.0'));
    const changed = Buffer.from(good);
    changed[good.length - 20] ^= 1;
    const broken = [
        ['text', Buffer.from('This is not an animation at all.'), 'BadMagic'],
        ['the half', good.subarray(0, good.length / 2), 'Truncated'],
        ['one byte changed', changed, 'ChecksumMismatch'],
    ];
    for (const [name, bytes, error] of broken)
        onPage(`${name}: ${error}, and the page goes on`, {}, async (page) => {
            await drop(page, 'broken.anim', bytes);
            assert.equal(await page.getAttribute('#message', 'data-error'), error);
            assert.equal(await page.isVisible('#message'), true);
            await page.click('#list li:nth-child(1) button');
            await page.waitForFunction(() => document.body.dataset.state === 'complete');
            assert.equal(await page.isHidden('#message'), true);
            assert.equal(await count(page), '1 / 5');
        });

    onPage('a file of the list that is missing is told', { expectErrors: true }, async (page) => {
        await page.route('**/reel-learned-1.0.anim', (route) => route.fulfill({ status: 404 }));
        await page.click('#list li:nth-child(4) button');
        await page.waitForFunction(() => document.body.dataset.state === 'error');
        assert.equal(await page.getAttribute('#message', 'data-error'), 'CannotLoad');
    });
});
